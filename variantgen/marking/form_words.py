"""The form for marking of a build, as it is known among other tables."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from variantgen.exam.exam import Exam


class FormWords(Struct, frozen=True):
    """The words by which the form for marking is known: heads of its first columns, of the column that says what is
    asked, of the last column of each problem; and the numbers of the problems in their order.
    """

    heads: tuple[str, ...]
    asked: str
    last: str
    problems: tuple[int, ...]

    @classmethod
    def of(cls, exam: Exam) -> FormWords:
        """The words of the form of an exam."""
        language = exam.spoken
        words = language.words("spreadsheet")
        heads = (language.words("key")["variant"], words["id"], words["name"], words["group"])
        return cls(heads, words["asked"], words["adjustment"], tuple(task.number for task in exam.tasks))

    def columns(self, cells: Sequence[str]) -> dict[int, tuple[int, int]]:
        """Where answers are typed, by column the number of the problem and of the answer in it; {} for another table.

        ``cells`` are those of a row that may be the head. A problem has a column for each answer, then one for the
        points of each, then the last one.
        """
        ends = [column for column, cell in enumerate(cells) if cell == self.last]
        if tuple(cells[: len(self.heads)]) != self.heads or len(ends) != len(self.problems):
            return {}
        found: dict[int, tuple[int, int]] = {}
        start = len(self.heads) + 2 + len(self.problems)  # behind the sum, the per cent, the sums of the problems
        for number, end in zip(self.problems, ends, strict=True):
            first = start + (cells[start] == self.asked)
            found |= {first + answer: (number, answer) for answer in range((end - first) // 2)}
            start = end + 1
        return found

    def corrections(self, cells: Sequence[str]) -> dict[int, int]:
        """The columns with points given or taken by hand, with the problems they belong to."""
        ends = (column for column, cell in enumerate(cells) if cell == self.last)
        return dict(zip(ends, self.problems, strict=True))

    def own_corrections(self, cells: Sequence[str]) -> dict[int, int]:
        """The same of the worksheet that has only these, headed ``± 1``; {} for another table."""
        heads = (*self.heads, *(f"{self.last} {number}" for number in self.problems))
        return dict(enumerate(self.problems, start=len(self.heads))) if tuple(cells[: len(heads)]) == heads else {}
