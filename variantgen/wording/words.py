"""What is looked up by name in the files of a language."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TypeVar

from variantgen.errors import InputError, Problem, nearest
from variantgen.resources import languages

T = TypeVar("T")


class MissingWordError(InputError, KeyError):
    """A file of a language lacks an entry. A KeyError too: a template may ask whether there is one."""


def check_language(name: str) -> None:
    """Raise InputError for the name of a language that has no file of words."""
    if name not in languages():
        raise InputError(Problem("unknown language", key="language", value=name, remedy=nearest(name, languages())))


class Words(dict[str, T]):
    """Words, sentences or tables of them by key; a key that is missing is an error that names the file."""

    def __init__(self, content: Mapping[str, T], path: Path, table: str = "") -> None:
        super().__init__(content)
        self.path, self.table = path, table

    def __missing__(self, key: str) -> T:
        name = f"{self.table}.{key}" if self.table else key
        remedy = "write it as in the same file of another language"
        raise MissingWordError(Problem("the language has no such entry", str(self.path), name, remedy=remedy))
