"""The words by which statements are read, from ``templates/reading/<language>.toml``."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache

from msgspec import Struct

from variantgen.resources import templates_dir
from variantgen.tables import read_toml


class Vocabulary(Struct, frozen=True):
    """Patterns of a language: senses of motion and nouns by key, and what stands between a length and its number."""

    senses: Mapping[str, re.Pattern[str]]
    nouns: Mapping[str, re.Pattern[str]]
    equals: str


@cache
def vocabulary(language: str) -> Vocabulary:
    """The words of a language; where it has no file of them, there is nothing to read but signs."""
    path = templates_dir() / "reading" / f"{language}.toml"
    tables = read_toml(path) if path.is_file() else {}
    senses, nouns = (
        {key: re.compile(rf"\b(?:{'|'.join(words)})\b", re.IGNORECASE) for key, words in tables.get(name, {}).items()}
        for name in ("senses", "nouns")
    )
    return Vocabulary(senses, nouns, "|".join(tables.get("equals", ["="])))
