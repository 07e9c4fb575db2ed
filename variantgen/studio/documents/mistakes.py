"""What is wrong with the text of an exam file, at its lines."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.studio.documents.toml_lines import parse_path, places
from variantgen.tables import parse_toml


class Mistake(Struct, frozen=True):
    """A mistake in the text of a file, with its line."""

    line: int
    key: str
    message: str
    remedy: str


def located(problems: Sequence[Problem], text: str, path: Path) -> list[Mistake]:
    """Problems of a TOML text at its lines; ``path`` is that of its file."""
    try:
        parse_toml(text, path)
        found = places(text)
    except (InputError, ValueError, IndexError):
        found = None
    mistakes = []
    for problem in problems:
        line = found.line(parse_path(problem.key)) if found else line_of(problem.message)
        value = f" ({problem.value})" if problem.value else ""
        mistakes.append(Mistake(line, problem.key, problem.message + value, problem.remedy))
    return mistakes


def line_of(message: str) -> int:
    """The line that a reader names in its message; 1 where it names none."""
    _, _, rest = message.partition("line ")
    digits = rest[: len(rest) - len(rest.lstrip("0123456789"))]
    return int(digits) if digits else 1


def is_empty(mistake: Mistake) -> bool:
    """Whether a mistake is only that the exam has no problems yet: so every new one begins."""
    return mistake.key == "problem" and "at least one" in mistake.message
