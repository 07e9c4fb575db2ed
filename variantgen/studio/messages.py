"""Messages of the program in the language of the page, ``assets/messages/<language>.toml``: by their English text.

A message that is not there stays in English: its words are those of the command, too.
"""

from __future__ import annotations

import re
import tomllib
from functools import cache
from typing import Any

from variantgen.errors import VariantgenError
from variantgen.studio.words import ASSETS

_VALUE = re.compile(r"(.*)( \([^()]*\))", re.DOTALL)
_GOT = re.compile(r"(.*) \(got (.*)\)", re.DOTALL)
_RUSSIAN_GOT = "{} (получено {})"


def in_language(text: str, language: str) -> str:
    """A message in a language, with the messages that it quotes."""
    if language == "en" or not text:
        return text
    said = _GOT.fullmatch(text)
    if said:
        return _RUSSIAN_GOT.format(in_language(said[1], language), said[2])
    said = _VALUE.fullmatch(text)  # a mistake with the value in its message
    if said and (spoken := in_language(said[1], language)) != said[1]:
        return spoken + in_language(said[2], language)
    for pattern, words in _messages(language):
        if found := pattern.fullmatch(text):
            return words.format(*(in_language(part, language) for part in found.groups()))
    return text


def explained(problem: Any, language: str) -> dict[str, Any]:
    """A problem or a mistake as pages show it."""
    known = {"key": problem.key, "line": getattr(problem, "line", 0)}
    return {**known, **{name: in_language(getattr(problem, name), language) for name in ("message", "remedy")}}


def error_text(error: VariantgenError, language: str) -> str:
    """An error as text: every problem with the file, the key, the value and the remedy."""
    found = []
    for problem in getattr(error, "problems", ()):
        where = ": ".join(filter(None, (problem.file, problem.key)))
        message = in_language(problem.message + (f" (got {problem.value})" if problem.value else ""), language)
        found.append(
            ": ".join(filter(None, (where, message))) + f"\n    {in_language(problem.remedy, language)}".rstrip()
        )
    return "\n".join(found) or in_language(str(error), language)


def command_text(said: str, language: str) -> str:
    """What a command has said of wrong input: lines of file, key, message, and of what to do."""
    return "\n".join(_line(line, language) for line in said.strip().removeprefix("variantgen: ").splitlines()[-8:])


def _line(line: str, language: str) -> str:
    """A line of a command: the longest end of it that is a known message is put into the language."""
    if said := _GOT.fullmatch(line):
        return _RUSSIAN_GOT.format(_line(said[1], language), said[2]) if language != "en" else line
    bare = line.strip()
    starts = [0, *(found.end() for found in re.finditer(": ", bare))]
    spoken = ((bare[:start], bare[start:], in_language(bare[start:], language)) for start in starts)
    translated = next((head + new for head, old, new in spoken if new != old), bare)
    return line[: len(line) - len(line.lstrip())] + translated


@cache
def _messages(language: str) -> tuple[tuple[re.Pattern[str], str], ...]:
    """The messages of a language by patterns of their English text, the most special first."""
    path = ASSETS / "messages" / f"{language}.toml"
    table = tomllib.loads(path.read_text("utf-8")) if path.is_file() else {}
    order = sorted(table, key=lambda text: -len(text.replace("{}", "")))
    return tuple((re.compile("(.*)".join(map(re.escape, text.split("{}"))), re.DOTALL), table[text]) for text in order)
