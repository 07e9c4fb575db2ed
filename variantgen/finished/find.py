"""Which student of a finished exam is meant: by what stands on the sheet, or by what one knows of the student."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

from variantgen.errors import InputError, Problem, nearest
from variantgen.exam.manifest import Manifest
from variantgen.exam.roster import Student
from variantgen.exam.student_order import base, in_order

_QR = "variantgen:1:"
_LISTED = 20


class Held(Protocol):
    """A sheet that a student has: whose it is, and its code."""

    @property
    def student(self) -> Student:
        """Whose it is."""

    @property
    def code(self) -> str:
        """What names it on paper."""


def find(record: Manifest, text: str) -> int:
    """The place of the student meant in a finished exam (see :func:`find_among`)."""
    return find_among(record.sheets, record.exam_id, text)


def find_among(sheets: Sequence[Held], exam_id: str, text: str) -> int:
    """The place of the student meant: by the id, the code of the sheet, the text of its QR code, the name or a part.

    ``exam_id`` is the name of the build in QR codes. Raises InputError if there is none, with names and ids that are
    close, or if there are several, with a list.
    """
    wanted = " ".join(text.split())
    if wanted.casefold().startswith(_QR):
        wanted = _code_of(exam_id, wanted)
    ways: Sequence[Callable[[Held], bool]] = (
        lambda sheet: sheet.student.id == wanted,
        lambda sheet: _is_code(sheet.code, wanted),
        lambda sheet: _words(sheet.student.name) == _words(wanted) != [],
        lambda sheet: _has_words(sheet.student.name, wanted),
    )
    for way in ways:
        found = [place for place, sheet in enumerate(sheets) if way(sheet)]
        if len(found) == 1:
            return found[0]
        if found:
            raise _several([sheets[place] for place in found], text)
    ids, names = [sheet.student.id for sheet in sheets], [s.student.name for s in sheets if s.student.name]
    close = nearest(wanted, {*ids, *names, *(sheet.code for sheet in sheets)})
    if not close.startswith("did you mean"):
        close = "give the code of the sheet, the text of its QR code, the name or a part of it, or the id"
    raise InputError(Problem("the exam has no such student", key="--student", value=text, remedy=close))


def _code_of(exam_id: str, text: str) -> str:
    """The code in the text of a QR code. Raises InputError if the sheet is of another build."""
    exam, _, code = text[len(_QR) :].partition(":")
    if exam_id and exam.casefold() != exam_id.casefold():
        remedy = f"this folder is the exam {exam_id.upper()}: look for the folder of the other one"
        raise InputError(Problem("the sheet is of another exam", key="--student", value=text, remedy=remedy))
    return code


def _is_code(code: str, text: str) -> bool:
    """Whether a text is a code, in large or small letters, with or without dashes."""
    return bool(text) and code.casefold().replace("-", "") == text.casefold().replace("-", "").replace(" ", "")


def _words(text: str) -> list[str]:
    return base(text).split()


def _has_words(name: str, text: str) -> bool:
    """Whether every word of a text begins a word of the name, or the text is somewhere in it."""
    words, wanted = _words(name), _words(text)
    begun = all(any(word.startswith(part) for word in words) for part in wanted)
    return bool(wanted) and (begun or " ".join(wanted) in " ".join(words))


def _several(found: Sequence[Held], text: str) -> InputError:
    """The list to choose from."""
    own = {sheet.student.id: sheet for sheet in found}
    lines = []
    for student in in_order([sheet.student for sheet in found])[:_LISTED]:
        who = ", ".join(filter(None, (student.name, student.group)))
        suffix = "" if student.name and student.name in student.id else f"  (id {student.id})"
        lines.append(f"{own[student.id].code}  {who}{suffix}")
    if len(found) > _LISTED:
        lines.append(f"... and {len(found) - _LISTED} more")
    remedy = "give the code of one of them:\n      " + "\n      ".join(lines)
    return InputError(Problem(f"{len(found)} students may be meant", key="--student", value=text, remedy=remedy))
