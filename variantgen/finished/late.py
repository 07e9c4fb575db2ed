"""Students who come, go or change after an exam was built, and the sheets that are handed out already."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.exam.allocation import HandedOutSheet
from variantgen.exam.exam import Exam, with_floors
from variantgen.exam.manifest import NAME, Manifest, read_manifest
from variantgen.exam.roster import Student
from variantgen.exam.student_order import in_order
from variantgen.finished.restore import restore


class Changes(Struct, frozen=True):
    """A class against earlier builds: who is ``new``, who is ``gone``, whose id another name or group had.

    ``changed`` has pairs: who it was, who it is.
    """

    new: tuple[Student, ...]
    gone: tuple[Student, ...]
    changed: tuple[tuple[Student, Student], ...]


def changes(records: Sequence[Manifest], students: Sequence[Student]) -> Changes:
    """The differences of a class from earlier builds, each list sorted by group and name."""
    before = {sheet.student.id: sheet.student for record in records for sheet in record.sheets}
    now = {student.id: student for student in in_order(students)}
    return Changes(
        tuple(student for student in now.values() if student.id not in before),
        tuple(student for student in in_order(list(before.values())) if student.id not in now),
        tuple((before[student.id], student) for student in now.values() if before.get(student.id, student) != student),
    )


def is_same_exam(record: Manifest, exam: Exam) -> bool:
    """Whether an output is of this exam file and its seed."""
    return record.exam_hash == exam.hash and record.seed == exam.seed


def series(out: Path) -> tuple[list[Path], Path]:
    """A finished build, those of students who were late (``OUT-new``, ``OUT-new-2``, ...), and the next name."""
    names = _names(out)
    found: list[Path] = []
    for folder in names:
        if not folder.exists():
            break
        found.append(folder)
    return found, out if not found else folder


def _names(out: Path) -> Iterator[Path]:
    yield out
    number = 1
    while True:
        yield out.with_name(f"{out.name}-new" if number == 1 else f"{out.name}-new-{number}")
        number += 1


def earlier(folders: Sequence[Path], exam: Exam) -> list[Manifest]:
    """The manifests of earlier builds of an exam. Raises InputError where there are none or of another exam."""
    if not folders:
        remedy = "leave the option out: everybody is new"
        raise InputError(Problem("there is no finished build in the folder of --out", key="--only-new", remedy=remedy))
    found = [read_manifest(folder) for folder in folders]
    for record in found:
        if not is_same_exam(record, exam):
            what = "seed" if record.exam_hash == exam.hash else "exam file"
            remedy = (
                "give the one it was built with (the manifest has it), or build the whole class into another folder"
            )
            raise InputError(
                Problem(
                    f"the folder was built with another {what}", file=str(record.path), key="--only-new", remedy=remedy
                )
            )
    return found


def standing(records: Sequence[Manifest], folders: tuple[Path, ...]) -> tuple[list[HandedOutSheet], list[str]]:
    """The sheets that are handed out, and what is not as it was when they were; ``folders`` hold own families."""
    found: list[HandedOutSheet] = []
    differences: dict[str, None] = {}
    for record in records:
        finished = restore(record, folders)
        differences.update(dict.fromkeys(finished.differences))
        found += [
            HandedOutSheet(sheet.student, sheet.code, tuple(own))
            for sheet, own in zip(record.sheets, finished.variants(record.sheets), strict=True)
        ]
    return found, list(differences)


def is_marked_otherwise(record: Manifest, exam: Exam) -> bool:
    """Whether an output has other tolerances than its exam file says: it was given another key since."""
    given = with_floors(replace(exam, tolerance=record.tolerance), record.floors)
    return any(
        given.tolerance_of(now) != exam.tolerance_of(then) for now, then in zip(given.tasks, exam.tasks, strict=True)
    )


def has_manifest(folder: Path) -> bool:
    """Whether a folder holds a finished build."""
    return (folder / NAME).is_file()
