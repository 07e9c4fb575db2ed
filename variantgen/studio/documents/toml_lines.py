"""Where the keys of a TOML text stand: for edits that leave comments and order as they are, and for errors at lines.

The text has to be correct TOML; it is read by :mod:`tomllib`, and here only its places are found.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TypeAlias

from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.limits import KEY_PARTS

Path: TypeAlias = tuple[str | int, ...]  # keys, and numbers of the tables of a list from 0

_HEADER = re.compile(r"[ \t]*(\[\[?)([^\]\n]*)\]\]?")
_KEY_PART = re.compile(r"""[ \t]*(?:([A-Za-z0-9_-]+)|"((?:[^"\\\n]|\\.)*)"|'([^'\n]*)')[ \t]*(\.?)""")
_LONGEST = 1000  # letters of a key
_STRINGS = ('"""', "'''", '"', "'")


class Entry(Struct, frozen=True):
    """A key with its value: its full path, the places in the text of its line, its value, its end of line."""

    path: Path
    start: int
    value: int
    value_end: int
    end: int


class Header(Struct, frozen=True):
    """The head of a table: its path, where the block of it begins (with the comments above it), its line, its end."""

    path: Path
    block: int
    start: int
    end: int


class Places(Struct, frozen=True):
    """The places of all keys and heads of a text, in their order."""

    text: str
    entries: tuple[Entry, ...]
    headers: tuple[Header, ...]

    def line(self, path: Path) -> int:
        """The number of the line, from 1, of a key; of one that is not there, of the nearest table above it; else 1."""
        for length in range(len(path), 0, -1):
            part = path[:length]
            known: list[Entry | Header] = [*self.entries, *self.headers]
            for item in known:
                if item.path == part:
                    return self.text.count("\n", 0, item.start) + 1
            for entry in self.entries:
                if entry.path[:length] == part:
                    return self.text.count("\n", 0, entry.start) + 1
        return 1


def parse_path(key: str) -> Path:
    """The path of a key as messages write it: ``problem[3].range.phi`` is ("problem", 2, "range", "phi").

    Raises InputError for one that is longer than any key.
    """
    found: list[str | int] = []
    parts = re.findall(r"[^.\[\]]+|\[[0-9]{1,6}\]", key)
    if len(parts) > KEY_PARTS or len(key) > _LONGEST:
        raise InputError(Problem("is longer than any key", value=key[:40]))
    for part in parts:
        found.append(int(part[1:-1]) - 1 if part.startswith("[") else part)
    return tuple(found)


def written_path(path: Path) -> str:
    """A path as messages write it."""
    return "".join(f"[{part + 1}]" if isinstance(part, int) else f".{part}" for part in path).removeprefix(".")


def places(text: str) -> Places:
    """The places of the keys of a correct text."""
    entries: list[Entry] = []
    headers: list[Header] = []
    table: Path = ()
    counts: dict[Path, int] = {}
    for start, end in _statements(text):
        header = _HEADER.match(text, start)
        if header:
            keys = _inside(_keys(header[2] + "=", 0)[0], counts)
            if header[1] == "[[":
                counts[keys] = counts.get(keys, -1) + 1
                keys = (*keys, counts[keys])
            table = keys
            headers.append(Header(keys, _with_comments(text, start), start, end))
        else:
            keys, after = _keys(text, start)
            value = after + len(text[after:]) - len(text[after:].lstrip(" \t"))
            entries.append(Entry((*table, *keys), start, value, _value_end(text, value), end))
    return Places(text, tuple(entries), tuple(headers))


def _inside(keys: Path, counts: dict[Path, int]) -> Path:
    """The path of the head of a table with the numbers of the lists that it lies in."""
    found: Path = ()
    for number, key in enumerate(keys):
        found = (*found, key)
        if found in counts and number < len(keys) - 1:
            found = (*found, counts[found])
    return found


def _keys(text: str, start: int) -> tuple[Path, int]:
    """The parts of a dotted key, and the place after its sign of equality."""
    found: list[str] = []
    place = start
    while match := _KEY_PART.match(text, place):
        found.append(next(part for part in match.groups()[:3] if part is not None))
        place = match.end()
        if not match[4]:
            break
    return tuple(found), text.index("=", place) + 1


def _statements(text: str) -> Iterator[tuple[int, int]]:
    """The begin and the end (after its line) of every head and of every key with its value."""
    place = 0
    while place < len(text):
        line_end = _line_end(text, place)
        line = text[place:line_end].strip()
        if line and not line.startswith("#"):
            if not line.startswith("["):
                after = _keys(text, place)[1]
                line_end = _line_end(text, _value_end(text, after))
            yield place, line_end
        place = line_end


def _line_end(text: str, place: int) -> int:
    found = text.find("\n", place)
    return len(text) if found < 0 else found + 1


def _value_end(text: str, start: int) -> int:
    """The end of a value: where, outside brackets and strings, a line or a comment begins, without spaces before it."""
    depth, place, end = 0, start, start
    while place < len(text):
        quote = next((mark for mark in _STRINGS if text.startswith(mark, place)), "")
        letter = text[place]
        if quote:
            place = end = _string_end(text, place, quote)
            continue
        if letter == "#":
            if not depth:
                break
            place = _line_end(text, place)
            continue
        if letter == "\n" and not depth:
            break
        depth += (letter in "[{") - (letter in "]}")
        place += 1
        if not letter.isspace():
            end = place
    return end


def _string_end(text: str, place: int, quote: str) -> int:
    """The place after a string that begins here."""
    place += len(quote)
    while place < len(text) and not text.startswith(quote, place):
        place += 2 if text[place] == "\\" and quote[0] == '"' else 1
    place += len(quote)
    while len(quote) == 3 and text.startswith(quote[0], place):  # up to two quotation marks belong to the string
        place += 1
    return place


def _with_comments(text: str, start: int) -> int:
    """Where the comments begin that stand directly above a line."""
    while start:
        before = text.rfind("\n", 0, start - 1) + 1
        if not text[before:start].lstrip().startswith("#"):
            return start
        start = before
    return start


def detached(block: str) -> str:
    """The comments at the end of a table that an empty line parts from it: they are not about it."""
    lines = block.split("\n")
    last = max(i for i, line in enumerate(lines) if line.strip() and not line.lstrip().startswith("#"))
    after = lines[last + 1 :]
    return "\n".join(after[after.index("") :]) if "" in after else ""
