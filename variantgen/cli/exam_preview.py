"""``show EXAM.toml``: the sheet of one student of an exam, as the class would see it."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from msgspec.structs import replace

from variantgen.cli.messages import say, tell
from variantgen.cli.options import some_text
from variantgen.errors import InputError, Problem

if TYPE_CHECKING:
    from variantgen.exam.exam import Exam
    from variantgen.exam.roster import Student
    from variantgen.exam.sheets import Sheet

# What the exam file says: the options of one problem have no meaning for a sheet.
_OF_A_FAMILY = (
    "set", "range", "form", "ask", "nice", "units", "lang", "figure", "method", "depth", "notation",
    "view", "true_scale",
)  # fmt: skip
_OF_AN_EXAM = ("student", "roster", "problem")
_FIRST = "1"  # the student of a class that nobody has named


def add_students(parser: argparse.ArgumentParser) -> None:
    """The ways to choose a student of an exam."""
    parser.add_argument(
        "--student",
        type=some_text,
        metavar="WHO",
        help="of an exam: whose sheet, by the id, or with --roster by the name or a part of it (default: variant 1)",
    )
    parser.add_argument(
        "--roster", type=Path, metavar="FILE", help="of an exam: the class list, CSV or XLSX, as for  variantgen build"
    )
    parser.add_argument(
        "--problem",
        type=int,
        metavar="N",
        help="of an exam, with --motion: the number of the problem that moves (default: 1)",
    )


def exam_file(text: str, folders: tuple[Path, ...]) -> Path | None:
    """The path of an exam file, by a path or the name of a sample; None for a family or a scene."""
    from variantgen.exam.samples import exam_path
    from variantgen.families.reading.folders import family_names
    from variantgen.families.reading.load import FAMILY_KEYS
    from variantgen.tables import read_toml

    if text in family_names(folders):
        return None
    try:
        path = exam_path(Path(text))
        if path.suffix != ".toml" or not path.is_file():
            return None
        content = read_toml(path)
    except (InputError, OSError, ValueError):
        return None  # what is wrong with it is told where it is read as a scene
    is_exam = "problem" in content or (content and not FAMILY_KEYS & content.keys())
    return path if is_exam else None


def refuse_exam(arguments: argparse.Namespace, command: str) -> None:
    """Raise InputError where a ``command`` for families is given an exam."""
    from variantgen.families.reading.folders import family_folders

    if exam_file(arguments.family, family_folders(arguments.families)) is None:
        return
    name = arguments.family
    remedy = f"its sheets:  variantgen show {name}  or  variantgen build {name} ..."
    raise InputError(Problem(f"this is an exam, {command}", name, remedy=remedy))


def check_options(arguments: argparse.Namespace, of_an_exam: bool) -> None:
    """Raise InputError for options that have no meaning for what is shown."""
    names: tuple[str, ...]
    names, reason, remedy = _OF_AN_EXAM, "only has a meaning for an exam", "give the file of an exam, or leave it out"
    if of_an_exam:
        names, reason, remedy = _OF_A_FAMILY, "has no meaning for an exam: its file says it", "change the file"
    values = {name: getattr(arguments, name) for name in names}
    given = [
        f"--{name.replace('_', '-')}" for name, value in values.items() if value or (value == 0 and value is not False)
    ]
    if given:
        raise InputError([Problem(reason, key=option, remedy=remedy) for option in given])
    if arguments.problem is not None and not arguments.motion:
        raise InputError(Problem("only has a meaning for a motion", key="--problem", remedy="add --motion FILE"))


def show_exam(arguments: argparse.Namespace, path: Path) -> None:
    """Print the sheet with its answers, or write its pages; with ``--explain`` the solutions. Raises InputError."""
    from variantgen.builder.preview import one_sheet
    from variantgen.exam.sections.named_families import composing
    from variantgen.families.reading.folders import family_folders
    from variantgen.outputs.formats import read_exam
    from variantgen.outputs.single.one_sheet import plain_sheet, write_sheet

    composing.set(tell)
    exam = read_exam(path, family_folders(arguments.families, beside=path))
    if arguments.seed is not None:
        exam = replace(exam, seed=arguments.seed)
    if arguments.explain and not exam.solutions.wanted:
        exam = replace(exam, solutions=replace(exam.solutions, depth="full"))
    students, place = _chosen(arguments, exam)
    sheet = one_sheet(exam, students, place)
    if arguments.motion:
        _write_motion(arguments, exam, sheet)
    if arguments.out:
        for written in write_sheet(exam, sheet, arguments.out, arguments.explain):
            tell(f"written: {written}")
    elif not arguments.motion:
        say(plain_sheet(exam, sheet, arguments.explain))


def _write_motion(arguments: argparse.Namespace, exam: Exam, sheet: Sheet) -> None:
    """Plots of the motion of one problem of the sheet."""
    from variantgen.outputs.single.motion_plot import write_motion

    number = 1 if arguments.problem is None else arguments.problem
    if not 1 <= number <= len(sheet.items):
        count = f"the sheet has problems 1 to {len(sheet.items)}"
        raise InputError(Problem("there is no such problem", key="--problem", value=str(number), remedy=count))
    item, student = sheet.items[number - 1], sheet.student
    remark = f"{exam.title}  ·  {student.name or student.id}  ·  {number}"
    write_motion(item.variant, item.asked, exam.language, arguments.motion, remark)
    tell(f"written: {arguments.motion}")


def _chosen(arguments: argparse.Namespace, exam: Exam) -> tuple[Sequence[Student], int]:
    """The class, and the place of the student in it."""
    from variantgen.exam.allocation import HandedOutSheet
    from variantgen.exam.roster import Student, read_class
    from variantgen.exam.sheets import variant_codes
    from variantgen.finished.find import find_among

    if not arguments.roster:
        return [Student(arguments.student or _FIRST, "")], 0
    students = read_class(arguments.roster).students
    if arguments.student is None:
        return students, 0
    codes = variant_codes(exam.seed, students)
    known = [HandedOutSheet(student, code, ()) for student, code in zip(students, codes, strict=True)]
    return students, find_among(known, exam.build_id, arguments.student)
