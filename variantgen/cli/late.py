"""What ``build`` says and does where the exam was built before: who is new, gone or changed since."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from variantgen.cli.messages import some_of, tell
from variantgen.errors import InputError, Problem

if TYPE_CHECKING:
    from variantgen.exam.allocation import HandedOutSheet
    from variantgen.exam.exam import Exam
    from variantgen.exam.manifest import Manifest
    from variantgen.exam.roster import Student
    from variantgen.finished.late import Changes


def late(
    arguments: argparse.Namespace, exam: Exam, students: Sequence[Student], folders: tuple[Path, ...]
) -> tuple[Path, Sequence[Student], Sequence[HandedOutSheet]]:
    """Where to build, for whom, and which sheets are handed out; reports who is new, gone or changed since.

    Raises InputError for ``--only-new`` with ``--force``, and where there is no earlier build of this exam.
    """
    if not arguments.only_new and not arguments.out.exists():
        return arguments.out, students, ()
    from variantgen.finished.late import (
        changes,
        earlier,
        has_manifest,
        is_marked_otherwise,
        is_same_exam,
        series,
        standing,
    )

    if arguments.only_new:
        if arguments.force:
            raise InputError(Problem("--only-new replaces nothing", key="--force", remedy="leave one of both out"))
        found, out = series(arguments.out)
        records = earlier(found, exam)
        new = _tell_changes(changes(records, students)).new
        sheets, differences = standing(records, folders) if new else ([], [])
        for difference in differences:
            tell(f"not as when the exam was made: {difference}")
        if new and is_marked_otherwise(records[0], exam):
            tell(
                f"{arguments.out} was given other tolerances since it was built: do the same to {out} with  "
                f"variantgen rekey, for its key has those of the exam file"
            )
        return out, new, sheets
    if has_manifest(arguments.out):
        record = _record(arguments.out)
        if record is not None and is_same_exam(record, exam):
            if _tell_changes(changes([record], students)).new:
                tell("--only-new makes sheets for the new ones alone, in a folder of their own")
        else:
            tell(f"{arguments.out} holds another exam, or this one with another seed or another text of its file")
    return arguments.out, students, ()


def _record(folder: Path) -> Manifest | None:
    """The manifest of a folder; None if it cannot be read."""
    from variantgen.exam.manifest import read_manifest

    try:
        return read_manifest(folder)
    except InputError:
        return None


def _tell_changes(found: Changes) -> Changes:
    """Say who is new, gone or changed."""
    for word, own in (("new", found.new), ("gone", found.gone)):
        if own:
            tell(f"{word}: {some_of([student.name or student.id for student in own])}")
    if found.changed:
        pairs = [f"{was.id} was {_who(was)}, is {_who(now)}" for was, now in found.changed]
        tell(f"changed: {some_of(pairs, '; ')}")
    if not (found.new or found.gone or found.changed):
        tell("the students are those of the finished build")
    return found


def _who(student: Student) -> str:
    return " ".join(filter(None, (student.name, student.group))) or "nobody"
