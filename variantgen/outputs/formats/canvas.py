"""A package of quizzes for Canvas (QTI 1.2), for Classic and New Quizzes.

In an exam file, ``[canvas]``:

- ``quizzes = "students"`` (usual): a quiz for each sheet, titled by its code, to be assigned to one student;
  ``quizzes = "draw"``: one quiz, with a group of questions for each problem, of which every student gets one by
  chance. A group draws single questions, and a question of Canvas has one number: drawn one by one, the numbers of a
  problem would be asked of different variants. So this needs an exam in which every problem asks for one number;
- ``statement = "each"`` (usual): every question has the statement and the figure; ``statement = "once"``: they stand in
  a text before the questions of a problem, which New Quizzes may drop;
- ``names = true``: the quizzes of students are titled by their names too;
- ``formulas`` of solutions: ``"html"`` (usual), letters, indices and powers in the text, or ``"mathml"``;
- ``figures``: ``"png"`` (usual) or ``"svg"``.

Margins are exact in decimals. Canvas reads numbers in the habits of the language that a student has chosen there; a
decimal point is understood in any.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.outputs.formats import Chunk, Fragment, WholeExam
from variantgen.outputs.qti import canvas
from variantgen.tables import Table

HELP = "canvas.zip, quizzes for Canvas (QTI 1.2)"
FILES = ("canvas.zip",)
TARGETS = "package"
SUMMARIES = ()
write_key = None


def read_options(table: Table) -> canvas.CanvasOptions:
    """The table ``[canvas]``."""
    return canvas.read_table(table)


def check(exam: Exam, students: Sequence[Student]) -> None:
    """Raise InputError if questions are to be drawn and a problem asks for more than one number."""
    canvas.check(exam)


def make(part: Chunk) -> Iterator[Fragment]:
    """The questions of a few students."""
    return canvas.make(part)


def finish(whole: WholeExam) -> None:
    """The package."""
    canvas.finish(whole)
