"""The problems of a form for marking as blocks of columns."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from variantgen.exam.exam import Exam, ExamProblem
from variantgen.exam.sheets import Answer, Sheet
from variantgen.outputs.spreadsheet.headings import Headings
from variantgen.wording.language import Language

PER_ANSWER = 3  # columns on the sheet of answers: value and bounds


class ProblemColumns(Struct, frozen=True):
    """A problem and its columns: what is asked (where students differ), what is typed, points, correction.

    ``place`` is the index of the problem on a sheet, ``most`` the largest number of answers. ``names`` are symbols and
    headings of the answers: numbers where students are asked different things (then it is not ``uniform``). ``first``
    is the first column, ``answers`` that on the sheet of answers.
    """

    task: ExamProblem
    place: int
    most: int
    names: tuple[tuple[str, str], ...]
    uniform: bool
    first: int
    answers: int

    @property
    def typed(self) -> int:
        """The first column of typed answers."""
        return self.first + (not self.uniform)

    @property
    def points(self) -> int:
        """The first column of points."""
        return self.typed + self.most

    @property
    def correction(self) -> int:
        """The column that shows the points given or taken by hand, the last one."""
        return self.points + self.most

    @property
    def answers_end(self) -> int:
        """The column behind the last one on the sheet of answers."""
        return self.answers + PER_ANSWER * self.most

    def value(self, number: int) -> int:
        """The column with the value of an answer on the sheet of answers; its bounds follow."""
        return self.answers + PER_ANSWER * number

    @property
    def worth(self) -> int:
        """The points of the problem: those of the exam, or one for each answer."""
        return self.task.points or self.most

    def shares(self) -> list[float]:
        """The points of the answers, equal parts."""
        return [self.worth / self.most] * self.most

    def title(self, language: Language) -> str:
        """``1. Four-bar linkage``, of a problem of several types ``Problem 1``."""
        titles = {family.title(language.name) for family in self.task.families}
        if len(titles) == 1:
            return f"{self.task.number}. {titles.pop()}"
        return f"{language.words('sheet')['problem']} {self.task.number}"

    def own(self, sheet: Sheet) -> tuple[Answer, ...]:
        """The answers of a student."""
        return sheet.items[self.place].answers


def point_format(blocks: Sequence[ProblemColumns]) -> str:
    """The format of points: two decimals where the answers of a problem share its points in fractions."""
    whole = all(float(share).is_integer() for block in blocks for share in block.shares())
    return "General" if whole else "0.00"


def blocks(exam: Exam, sheets: Sequence[Sheet], headings: Headings, first: int, answers: int) -> list[ProblemColumns]:
    """The problems of an exam in order, from the columns ``first`` and ``answers`` of the two sheets on."""
    found: list[ProblemColumns] = []
    for place, task in enumerate(exam.tasks):
        items = [sheet.items[place] for sheet in sheets]
        asked = {tuple((headings.symbol(i, a), headings.heading(i, a)) for a in i.answers) for i in items}
        most = max(len(names) for names in asked)
        names = asked.pop() if len(asked) == 1 else ()
        numbers = tuple((str(number), str(number)) for number in range(1, most + 1))
        found.append(ProblemColumns(task, place, most, names or numbers, bool(names), first, answers))
        first, answers = found[-1].correction + 1, found[-1].answers_end
    return found
