"""What an exam file says at the head of every sheet: instructions, date, duration, deadline.

Each is plain text with simple formulas (:mod:`variantgen.wording.inline`), or a table of such texts by language.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from msgspec import Struct

from variantgen.errors import nearest
from variantgen.exam import printable
from variantgen.resources import languages
from variantgen.tables import Table
from variantgen.wording.inline import inline
from variantgen.wording.language import load_language
from variantgen.wording.text import Text

FACTS = ("date", "duration", "deadline")
_INSTRUCTIONS = "instructions"
_PARAGRAPH = re.compile(r"\n\s*\n")


class Notices(Struct, frozen=True):
    """What stands at the head of the sheets, in their language: ``facts`` by name, ``instructions`` by paragraph."""

    facts: tuple[tuple[str, Text], ...] = ()
    instructions: tuple[Text, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.facts or self.instructions)

    @property
    def words(self) -> Iterator[tuple[str, str]]:
        """The words of the notices without formulas, each after the key that it comes from."""
        for name, text in (*self.facts, *((_INSTRUCTIONS, text) for text in self.instructions)):
            yield from ((name, part) for part in text if isinstance(part, str))


def read_notices(top: Table, language: str) -> Notices:
    """The notices of an exam whose sheets are in ``language``; mistakes are noted in the table."""
    found = {name: _paragraphs(top, name, language) for name in (*FACTS, _INSTRUCTIONS)}
    facts = tuple((name, found[name][0]) for name in FACTS if found[name])
    return Notices(facts, found[_INSTRUCTIONS])


def _paragraphs(top: Table, name: str, language: str) -> tuple[Text, ...]:
    """The paragraphs of a text in the language of the sheets."""
    top.expect(name)
    value = top.data.get(name)
    if value is None:
        return ()
    if not isinstance(value, dict):
        return _read(top, name, name, value, language)
    texts = top.table(name)
    found: dict[str, tuple[Text, ...]] = {}
    for key, text in value.items():
        if key in languages():
            found[key] = _read(texts, key, name, text, key)
        else:
            texts.problem("unknown language", key, remedy=nearest(key, languages()))
    if language not in value and language in languages():
        texts.problem(f"no text in the language of the sheets, {language}", "", remedy=f'add  {language} = "..."')
    return found.get(language, ())


def _read(table: Table, key: str, name: str, value: Any, language: str) -> tuple[Text, ...]:
    """The paragraphs of a text; facts have one."""
    if not isinstance(value, str):
        remedy = f'write it as it is to be printed, in quotes, for example  {key} = "12 May, 10:00"'
        table.problem("expected a text, or a table of texts by language", key, value, remedy)
        return ()
    if problems := printable.problems(value, f"the {name}", table.key(key), allowed="\n\r\t"):
        table.problems += problems
        return ()
    parts = _PARAGRAPH.split(value) if name == _INSTRUCTIONS else [value]
    texts = [text for part in parts if (text := " ".join(part.split()))]
    if language not in languages():
        return ()
    found: list[Text] = []
    for text in texts:
        with table.collecting(key):
            found.append(inline(text, load_language(language)))
    return tuple(found)
