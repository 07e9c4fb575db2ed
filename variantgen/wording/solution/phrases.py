"""The sentences of solutions in a language, read from ``templates/solution/<language>/*.toml``.

A sentence is text with fields in braces, ``{vector}`` or ``{body.of}``, and letters, ``{=x}``. What follows the point
is the form of a name, a case for example: which forms there are is the language's own affair. A body has those of its
table ``[bodies.*]``, a fact that is a sentence itself those of its keys (``image`` and ``image.of``). Sentences are cut
into text, fields and letters once and filled often.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from typing import Any

from msgspec import Struct

from variantgen.resources import templates_dir
from variantgen.tables import read_toml
from variantgen.wording.words import Words

_FIELD = re.compile(r"\{(=?)(\w+)(?:\.(\w+))?\}")
TABLES = ("words", "bodies", "functions")


class SentenceField(Struct, frozen=True):
    """A place in a sentence that a fact fills, perhaps in a form."""

    name: str
    form: str = ""


class Letter(Struct, frozen=True):
    """A letter set as in a formula: an axis, an angle."""

    name: str


Phrase = tuple[str | SentenceField | Letter, ...]


def cut(text: str) -> Phrase:
    """A sentence as text, fields and letters."""
    parts: list[str | SentenceField | Letter] = []
    last = 0
    for match in _FIELD.finditer(text):
        if match.start() > last:
            parts.append(text[last : match.start()])
        parts.append(Letter(match[2]) if match[1] else SentenceField(match[2], match[3] or ""))
        last = match.end()
    if last < len(text):
        parts.append(text[last:])
    return tuple(parts)


class Phrases(Struct, frozen=True):
    """Sentences by key ``file.name``, and tables of words, of names of bodies by kind and form, of functions."""

    sentences: Mapping[str, Phrase]
    words: Mapping[str, str]
    bodies: Mapping[str, Mapping[str, str]]
    functions: Mapping[str, str]

    def sentence(self, key: str) -> Phrase:
        """A sentence. Raises InputError for one that the language does not have."""
        return self.sentences[key]


@cache
def load_phrases(language: str) -> Phrases:
    """The phrases of a language."""
    sentences: dict[str, Phrase] = {}
    tables: dict[str, dict[str, Any]] = {name: {} for name in TABLES}
    folder = templates_dir() / "solution" / language
    for path in sorted(folder.glob("*.toml")):
        for name, value in read_toml(path).items():
            if isinstance(value, str):
                sentences[f"{path.stem}.{name}"] = cut(value)
            else:
                tables[name].update(value)
    bodies = {kind: Words(forms, folder, f"bodies.{kind}") for kind, forms in tables["bodies"].items()}
    words, functions = (Words(tables[name], folder, name) for name in ("words", "functions"))
    return Phrases(Words(sentences, folder), words, Words(bodies, folder, "bodies"), functions)
