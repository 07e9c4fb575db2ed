"""Which letters of names and titles the fonts of the typesetting engine have: without one, paper would show a box."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from variantgen.errors import InputError, Problem
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.outputs.typst.typesetter import Typesetter, typesetter

# The engine draws a letter that no font has as this glyph; the private use area is empty in all of its fonts.
_NOBODY = "\U0010fffd"
_USUAL_END = 0x0500  # Latin, Greek, Cyrillic with their accents: the fonts of the engine have them (a test)
_GLYPH = re.compile(r'<symbol id="(\w+)"')


def texts_of(exam: Exam, students: Sequence[Student]) -> Iterable[tuple[str, str]]:
    """Every text from outside that is printed, after words that say which it is."""
    yield "the title", exam.title
    yield "the course", exam.course
    yield from ((f"the {name}", text) for name, text in exam.notices.words)
    for student in students:
        yield f"the name of student {student.id}", student.name
        yield f"the group of student {student.id}", student.group
        yield f"the id of student {student.id}", student.id


def check_letters(exam: Exam, students: Sequence[Student]) -> None:
    """Raise InputError, which names every text with a letter that no font has."""
    texts = list(texts_of(exam, students))
    absent = absent_letters(text for _, text in texts)
    if not absent:
        return
    remedy = "write it with other letters, or make pages for browsers, which have more fonts: --format html"
    raise InputError(
        Problem(f"the fonts for PDF lack a letter of {what}", value=_told(text, absent), remedy=remedy)
        for what, text in texts
        if absent & set(text)
    )


def absent_letters(texts: Iterable[str]) -> set[str]:
    """The letters of texts that no font has."""
    unusual = sorted({letter for text in texts for letter in text if ord(letter) >= _USUAL_END})
    if not unusual:
        return set()
    with typesetter() as engine:
        return missing(engine, unusual)


def missing(engine: Typesetter, letters: Sequence[str]) -> set[str]:
    """Those of the letters that the fonts do not have."""
    if not letters:
        return set()
    *pages, nobody = engine.compile("letters.typ", [*letters, _NOBODY], "svg")
    absent = _glyphs(nobody)
    return {letter for letter, page in zip(letters, pages, strict=True) if _glyphs(page) & absent}


def _glyphs(page: bytes) -> set[str]:
    return set(_GLYPH.findall(page.decode()))


def _told(text: str, absent: set[str]) -> str:
    found = [letter for letter in dict.fromkeys(text) if letter in absent]
    more = f" and {len(found) - 5} more" if len(found) > 5 else ""
    return ", ".join(f"{letter} U+{ord(letter):04X}" for letter in found[:5]) + more
