"""Packages of QTI 2.1 and of QTI 3.0, which are two formats: items with their figures, tests, manifest.

In an exam file, ``[qti21]`` and ``[qti30]``:

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

from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.outputs.formats import Chunk, Fragment, WholeExam
from variantgen.outputs.qti import exam_package
from variantgen.outputs.qti.dialect import QTI21, QTI30, Dialect
from variantgen.outputs.qti.options import PackageOptions
from variantgen.tables import Table


class QtiFormat:
    """A version of QTI; fulfils :class:`variantgen.outputs.formats.Format`."""

    TARGETS = "package"
    SUMMARIES = ()
    write_key = None

    def __init__(self, dialect: Dialect, version: str) -> None:
        self.dialect = dialect
        self.HELP = f"{dialect.name}.zip, a package of QTI {version} for learning platforms"
        self.FILES = (f"{dialect.name}.zip",)

    def read_options(self, table: Table) -> PackageOptions:
        """The table of the version."""
        return exam_package.read_table(table)

    def check(self, exam: Exam, students: Sequence[Student]) -> None:
        """Nothing is needed but the engine, which every build has."""

    def make(self, part: Chunk) -> Iterator[Fragment]:
        """The items of a few students."""
        return exam_package.make(part, self.dialect)

    def finish(self, whole: WholeExam) -> None:
        """The package."""
        exam_package.finish(whole, self.dialect)


FORMATS = {"qti21": QtiFormat(QTI21, "2.1"), "qti30": QtiFormat(QTI30, "3.0")}
