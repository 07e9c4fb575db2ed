"""The sentences of solutions in a language, read from ``templates/solution/<language>/*.toml``.

A sentence is text with fields in braces, ``{vector}`` or ``{body.of}``; what follows the point is the grammatical case
of a body, and letters, ``{=x}``. Sentences are cut into text, fields and letters once and filled often.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from variantgen.resources import templates_dir
from variantgen.tables import read_toml

_FIELD = re.compile(r"\{(=?)(\w+)(?:\.(\w+))?\}")
TABLES = ("words", "bodies", "functions")


@dataclass(frozen=True, slots=True)
class Field:
    """A place in a sentence that a fact fills, in a case if it is a body."""

    name: str
    case: str = ""


@dataclass(frozen=True, slots=True)
class Letter:
    """A letter set as in a formula: an axis, an angle."""

    name: str


Phrase = tuple[str | Field | Letter, ...]


def cut(text: str) -> Phrase:
    """A sentence as text, fields and letters."""
    parts: list[str | Field | Letter] = []
    last = 0
    for match in _FIELD.finditer(text):
        if match.start() > last:
            parts.append(text[last : match.start()])
        parts.append(Letter(match[2]) if match[1] else Field(match[2], match[3] or ""))
        last = match.end()
    if last < len(text):
        parts.append(text[last:])
    return tuple(parts)


@dataclass(frozen=True)
class Phrases:
    """Sentences by key ``file.name``, and tables of words, of names of bodies by kind and case, of functions."""

    sentences: Mapping[str, Phrase]
    words: Mapping[str, str]
    bodies: Mapping[str, Mapping[str, str]]
    functions: Mapping[str, str]

    def sentence(self, key: str) -> Phrase:
        """A sentence. Raises KeyError for one that the language does not have (a test keeps the languages equal)."""
        return self.sentences[key]


@cache
def load_phrases(language: str) -> Phrases:
    """The phrases of a language."""
    sentences: dict[str, Phrase] = {}
    tables: dict[str, dict[str, Any]] = {name: {} for name in TABLES}
    for path in sorted((templates_dir() / "solution" / language).glob("*.toml")):
        for name, value in read_toml(path).items():
            if isinstance(value, str):
                sentences[f"{path.stem}.{name}"] = cut(value)
            else:
                tables[name].update(value)
    return Phrases(sentences, tables["words"], tables["bodies"], tables["functions"])
