"""Reading TOML files and their tables with messages for the author: file, key, value, expectation, remedy."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from decimal import Decimal
from pathlib import Path
from typing import Any, TypeVar

from msgspec.structs import replace

from variantgen.errors import InputError, Problem, nearest
from variantgen.limits import DIGITS, KEY_PARTS, TOML_BYTES

T = TypeVar("T")
# Part after part of a dotted key, bare or in quotes; what has been read is not read again in another way.
_PART = r"""(?:[A-Za-z0-9_-]++|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+')[ \t]*+"""
_DEEP_KEY = re.compile(rf"(?<![A-Za-z0-9_-])(?:{_PART}\.[ \t]*+){{{KEY_PARTS},}}")

# A value that begins like a number and goes on: Python does not write out whole numbers of any length.
_LONG_NUMBER = re.compile(rf"(?<=[=\[,])[ \t\r\n]*[+-]?(?:0[xob])?[0-9A-Fa-f_]{{{DIGITS + 1},}}+")
_LAST_KEY = re.compile(r"([A-Za-z0-9_.-]+)[ \t]*=[^=]*\Z")


def read_limited(path: Path, limit: int) -> bytes:
    """The bytes of a file; InputError if there are more than ``limit``, also for a device without an end."""
    with path.open("rb") as file:
        content = file.read(limit + 1)
    if len(content) > limit:
        raise InputError(
            Problem(f"the file is larger than {limit // 1000} kB", file=str(path), remedy="is it the right file?")
        )
    return content


def read_toml(path: Path) -> dict[str, Any]:
    """The content of a TOML file, numbers with a decimal point as Decimal. Raises InputError."""
    return parse_toml(read_text(path), path)


def read_text(path: Path) -> str:
    """The text of a TOML file. Raises InputError."""
    try:
        return read_limited(path, TOML_BYTES).decode("utf-8-sig")
    except OSError as error:
        raise InputError(Problem(f"cannot be read: {error.strerror}", file=str(path))) from None
    except UnicodeDecodeError:
        raise InputError(Problem("is not a text file in UTF-8", file=str(path), remedy="save it as UTF-8")) from None


def parse_toml(text: str, path: Path) -> dict[str, Any]:
    """The content of the text of a file, numbers with a decimal point as Decimal. Raises InputError."""
    # A key stands in one line; to count dots takes a tenth of the time of looking for keys.
    dotted = any(line.count(".") >= KEY_PARTS for line in text.split("\n"))
    for found, what, remedy in (
        (
            _DEEP_KEY.search(text) if dotted else None,
            f"a key of more than {KEY_PARTS} parts",
            "no key has so many; part a text by spaces",
        ),
        (_LONG_NUMBER.search(text), f"a number of more than {DIGITS} digits", "no quantity is that large: shorten it"),
    ):
        if found:
            message = f"{what} in line {text.count(chr(10), 0, found.start()) + 1}"
            before = _LAST_KEY.search(text, text.rfind("\n", 0, found.start()) + 1, found.start())
            key, value = before[1] if before else "", shown(found[0].strip())
            raise InputError(Problem(message, str(path), key, value, remedy))
    try:
        return tomllib.loads(text, parse_float=Decimal)
    except (tomllib.TOMLDecodeError, RecursionError, MemoryError, ValueError, ArithmeticError) as error:
        raise InputError(
            Problem(f"is not valid TOML: {error}", file=str(path), remedy="compare it with a file of the catalogue")
        ) from None


class Table:
    """A TOML table that is read key by key; mistakes are collected, unknown keys are reported at the end."""

    def __init__(self, data: Any, path: str, problems: list[Problem]) -> None:
        self.problems = problems
        self.path = path
        self.data: dict[str, Any] = data if isinstance(data, dict) else {}
        self._seen: set[str] = set()
        if not isinstance(data, dict):
            self.problem("expected a table", "", data)

    def key(self, name: str) -> str:
        """The full name of a key, for messages."""
        return f"{self.path}.{name}" if self.path and name else self.path or name

    def problem(self, message: str, name: str, value: Any = "", remedy: str = "") -> None:
        """Note a mistake in this table."""
        self.problems.append(Problem(message, key=self.key(name), value=shown(value), remedy=remedy))

    def bounded(self, name: str, most: int) -> bool:
        """Whether a list or table inside has at most ``most`` entries; if not, it is noted and read as an empty one."""
        found = self.data.get(name)
        if not isinstance(found, list | dict) or len(found) <= most:
            return True
        self.problem(f"expected at most {most} entries", name, len(found), "leave some out")
        self.data = {**self.data, name: [] if isinstance(found, list) else {}}
        return False

    @contextmanager
    def collecting(self, name: str) -> Iterator[None]:
        """Collect the problems of an InputError raised inside, under this key.

        Without a name the problems keep their own keys, put under this table's; those of another file stay as they are.
        """
        try:
            yield
        except InputError as error:
            self.problems += [self._placed(problem, name) for problem in error.problems]

    def _placed(self, problem: Problem, name: str) -> Problem:
        if problem.file or (name and problem.key.startswith(self.key(name))):
            return problem
        return replace(problem, key=self.key(name or problem.key))

    def take(self, name: str, kind: type[T] | tuple[type[T], ...], default: T, expected: str = "") -> T:
        """A value of the given type, or the default when the key is absent or wrong (which is noted)."""
        self._seen.add(name)
        value = self.data.get(name, default)
        right = isinstance(value, kind) and not (isinstance(value, bool) and kind is not bool)
        if name in self.data and not right:
            self.problem(f"expected {expected or _kind_name(kind)}", name, value)
            return default
        found: T = value
        return found

    def need(self, name: str, kind: type[T] | tuple[type[T], ...], default: T, expected: str = "") -> T:
        """Like :meth:`take`, and noted when absent."""
        self._seen.add(name)
        if name not in self.data:
            self.problem(f"missing, expected {expected or _kind_name(kind)}", name)
            return default
        return self.take(name, kind, default, expected)

    def choice(self, name: str, known: Sequence[str], default: str = "") -> str:
        """One of the known words; the default (or the first) when the key is absent or wrong (which is noted)."""
        default = default or known[0]
        value = self.take(name, str, default)
        if value in known:
            return value
        expected = ", ".join(f'"{word}"' for word in known)
        self.problem(f"expected one of {expected}", name, value, nearest(value, known))
        return default

    def expect(self, *names: str) -> None:
        """Note keys that the table may have, so that a mistyped one is compared with them."""
        self._seen.update(names)

    def number(self, name: str, default: int | Decimal) -> Decimal:
        """A number as it is written in the file; one that is not finite is noted."""
        value: Any = self.take(name, (int, Decimal), default, "a number")
        found = Decimal(value)
        if not math.isfinite(float(found)):
            self.problem("expected a finite number", name, value)
            return Decimal(default)
        return found

    def strings(self, name: str, default: tuple[str, ...] = ()) -> tuple[str, ...]:
        """A list of strings."""
        self._seen.add(name)
        value = self.data.get(name, list(default))
        if not isinstance(value, list) or any(not isinstance(item, str) for item in value):
            self.problem("expected a list of strings", name, value)
            return default
        return tuple(value)

    def table(self, name: str) -> Table:
        """A table inside (empty when absent)."""
        return Table(self.take(name, dict, {}, "a table"), self.key(name), self.problems)

    def tables(self, name: str) -> list[Table]:
        """A list of tables inside (empty when absent)."""
        items = self.take(name, list, [], "a list of tables")
        return [Table(item, f"{self.key(name)}[{i + 1}]", self.problems) for i, item in enumerate(items)]

    def each(self, read: Callable[[str, Any], T | None]) -> dict[str, T]:
        """Apply a reader to every key; what it returns as None is left out (it has noted why)."""
        found = {}
        for name, value in self.data.items():
            self._seen.add(name)
            item = read(name, value)
            if item is not None:
                found[name] = item
        return found

    def finish(self) -> None:
        """Note the keys that nobody asked for."""
        for name in self.data:
            if name not in self._seen:
                self.problem("unknown key", name, remedy=nearest(name, self._seen))


def _kind_name(kind: Any) -> str:
    kinds = kind if isinstance(kind, tuple) else (kind,)
    words = {str: "a string", int: "a whole number", bool: "true or false", list: "a list", dict: "a table"}
    words[Decimal] = "a number"
    return " or ".join(dict.fromkeys(words.get(k, k.__name__) for k in kinds))


def shown(value: Any) -> str:
    """A value as its author wrote it, shortened."""
    text = str(value).lower() if isinstance(value, bool) else str(value)
    return text if len(text) <= 60 else text[:57] + "..."
