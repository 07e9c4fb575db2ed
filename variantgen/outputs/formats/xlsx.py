"""The key and a form for marking by hand as workbooks."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable, Sequence
from importlib.util import find_spec
from pathlib import Path

from msgspec import Struct

from variantgen.errors import missing_package
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.outputs.files.student_groups import GROUPS, GroupFiles
from variantgen.outputs.formats import Chunk, Fragment, WholeExam, options
from variantgen.tables import Table

HELP = "key.xlsx and grading.xlsx, a form for marking by hand"
FILES = ("key.xlsx", "grading.xlsx", "key/*.xlsx", "grading/*.xlsx")
TARGETS = "(?!)"  # there are no pieces
SUMMARIES: tuple[tuple[int, Callable[[Chunk], Iterable[Fragment]]], ...] = ()
write_key = None


class XlsxOptions(Struct, frozen=True):
    """What an exam file may say of workbooks.

    ``protect``: the form for marking is protected (without a password), so that formulas are not typed over.
    ``files``: workbooks for all students, or for each group.
    """

    protect: bool = True
    files: str = "joined"


def read_options(table: Table) -> XlsxOptions:
    """The table ``[xlsx]``."""
    found = XlsxOptions(table.take("protect", bool, True), table.choice("files", ("joined", GROUPS)))
    table.finish()
    return found


def check(exam: Exam, students: Sequence[Student]) -> None:
    """Raise ToolMissingError without XlsxWriter."""
    if find_spec("xlsxwriter") is None:
        raise missing_package("xlsx output needs", "XlsxWriter", "xlsx")


def make(part: Chunk) -> Iterable[Fragment]:
    """Nothing: the workbooks are made of the answers alone."""
    return ()


def finish(whole: WholeExam) -> None:
    """Both workbooks, or both for each group."""
    chosen: XlsxOptions = options(whole.exam, "xlsx")
    if chosen.files != GROUPS:
        _write(whole, whole.sheets, "key.xlsx", "grading.xlsx")
        return
    for name in ("key", "grading"):
        (whole.folder / name).mkdir(exist_ok=True)  # keys in other formats may be there
    groups = GroupFiles.of(sheet.student.group for sheet in whole.sheets)
    for group, places in groups.places.items():
        stem = groups.stems[group]
        _write(whole, [whole.sheets[place] for place in places], f"key/{stem}.xlsx", f"grading/{stem}.xlsx")


def _write(whole: WholeExam, sheets: Sequence[Sheet], key: str, grading: str) -> None:
    """Both workbooks of some students."""
    from variantgen.outputs.spreadsheet.grading_book import write_grading
    from variantgen.outputs.spreadsheet.key_book import write_key

    chosen: XlsxOptions = options(whole.exam, "xlsx")
    with tempfile.TemporaryDirectory(dir=whole.folder) as folder:
        write_key(whole.exam, sheets, whole.folder / key, Path(folder))
        write_grading(whole.exam, sheets, whole.folder / grading, Path(folder), chosen.protect)
