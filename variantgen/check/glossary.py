"""One word for one thing: the words that a language avoids, from ``templates/glossary/<language>.toml``."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache

from msgspec import Struct

from variantgen.families.family import Family
from variantgen.resources import languages, templates_dir
from variantgen.tables import read_text, read_toml

# What a template computes with is no text: expressions, statements and comments of Jinja.
_CODE = re.compile(r"\{%.*?%\}|\{\{.*?\}\}|\{#.*?#\}", re.DOTALL)


class GlossaryTerm(Struct, frozen=True):
    """A thing by its key, the word for it in one language, and a pattern of words that are avoided."""

    key: str
    use: str
    avoided: re.Pattern[str]


@cache
def terms(language: str) -> tuple[GlossaryTerm, ...]:
    """The terms of a language; none where it has no glossary."""
    path = templates_dir() / "glossary" / f"{language}.toml"
    tables = read_toml(path) if path.is_file() else {}
    return tuple(
        GlossaryTerm(key, table["use"], re.compile(rf"(?<!\w)(?:{'|'.join(table['avoid'])})(?!\w)", re.IGNORECASE))
        for key, table in tables.items()
    )


def avoided_words(text: str, language: str) -> Iterator[tuple[str, GlossaryTerm]]:
    """The avoided words of a text with the terms that have another word for the same."""
    for term in terms(language):
        for found in term.avoided.finditer(text):
            yield found[0], term


def family_words(family: Family) -> Iterator[tuple[str, str]]:
    """Where a family uses an avoided word, in a title or in the template of a statement, and what to write."""
    for language in languages():
        texts = [("title", family.titles.get(language, ""))]
        path = family.folder / f"statement.{language}.j2" if family.folder else None
        if path is not None and path.is_file():
            texts.append((path.name, _CODE.sub("", read_text(path))))
        for where, text in texts:
            for word, term in avoided_words(text, language):
                yield where, f"{word!r} is called {term.use!r} elsewhere (templates/glossary/{language}.toml)"
