"""A package of QTI 3.0: items with their figures, tests, manifest.

In an exam file, ``[qti30]``:

- ``tests = "draw"`` (usual): one test, which gives every student a sheet by chance, all its problems together;
  ``tests = "students"``: a test for each sheet, titled by its code;
- ``names = true``: the tests of students are titled by their names too;
- ``formulas`` of solutions: ``"mathml"`` (usual) or ``"html"``, letters, indices and powers in the text, for platforms
  that do not show MathML; statements are always written so;
- ``figures``: ``"png"`` (usual) or ``"svg"``.

Numbers have a decimal point, since QTI knows no other; students are asked to enter them so.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from variantgen.exam.exam_file import Exam
from variantgen.exam.roster import Student
from variantgen.outputs.formats import Chunk, Fragment, WholeExam
from variantgen.outputs.qti import exam_package as qti
from variantgen.outputs.qti.dialect import QTI30
from variantgen.outputs.qti.options import PackageOptions
from variantgen.tables import Table

HELP = "qti30.zip, a package of QTI 3.0 for learning platforms"
FILES = ("qti30.zip",)
TARGETS = "package"
SUMMARIES = ()
write_key = None


def read_options(table: Table) -> PackageOptions:
    """The table ``[qti30]``."""
    return qti.read_table(table)


def check(exam_package: Exam, students: Sequence[Student]) -> None:
    """Nothing is needed but the engine, which every build has."""


def make(part: Chunk) -> Iterator[Fragment]:
    """The items of a few students."""
    return qti.make(part, QTI30)


def finish(whole: WholeExam) -> None:
    """The package."""
    qti.finish(whole, QTI30)
