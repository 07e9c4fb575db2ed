"""The key and a form for marking by hand as workbooks."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

from variantgen.errors import missing_package
from variantgen.exam.blueprint import Exam
from variantgen.exam.roster import Student
from variantgen.outputs.formats import Part, Piece, Whole, options
from variantgen.tables import Table

HELP = "key.xlsx and grading.xlsx, a form for marking by hand"
FILES = ("key.xlsx", "grading.xlsx")
TARGETS = "(?!)"  # there are no pieces
SUMMARIES: tuple[tuple[int, Callable[[Part], Iterable[Piece]]], ...] = ()


@dataclass(frozen=True)
class Options:
    """What an exam file may say of workbooks.

    ``protect``: the form for marking is protected (without a password), so that formulas are not typed over.
    """

    protect: bool = True


def read_options(table: Table) -> Options:
    """The table ``[xlsx]``."""
    found = Options(table.take("protect", bool, True))
    table.finish()
    return found


def check(exam: Exam, students: Sequence[Student]) -> None:
    """Raise ToolMissingError without XlsxWriter."""
    if find_spec("xlsxwriter") is None:
        raise missing_package("xlsx output needs", "XlsxWriter", "xlsx")


def make(part: Part) -> Iterable[Piece]:
    """Nothing: the workbooks are made of the answers alone."""
    return ()


def finish(whole: Whole) -> None:
    """Both workbooks."""
    from variantgen.outputs.spreadsheet.grading_book import write_grading
    from variantgen.outputs.spreadsheet.key_book import write_key

    chosen: Options = options(whole.exam, "xlsx")
    with tempfile.TemporaryDirectory(dir=whole.folder) as folder:
        write_key(whole.exam, whole.sheets, whole.folder / "key.xlsx", Path(folder))
        write_grading(whole.exam, whole.sheets, whole.folder / "grading.xlsx", Path(folder), chosen.protect)
