"""The sheets of a build as its parts hold them: read when they are asked for, never all at once."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Collection, Iterator, Sequence
from typing import Any

from variantgen.builder.jobs import PackedChunk
from variantgen.builder.unfinished import Unfinished
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Item, Sheet, variant_codes
from variantgen.outputs.formats import STUDENTS_PER_PART


class StoredSheets(Sequence[Sheet]):
    """The sheets in their order; to go through them in turn is best. Names and codes are there without reading."""

    def __init__(self, exam: Exam, students: Sequence[Student], parts: Unfinished, taken: Collection[str] = ()) -> None:
        self._exam, self._students, self._parts = exam, students, parts
        self._codes = variant_codes(exam.seed, students, taken)
        begun = {student.group: place for place, student in reversed(list(enumerate(students)))}
        self._begun = sorted((place, group) for group, place in begun.items())
        self._last: tuple[int, tuple[Sheet, ...]] = (-1, ())

    def __len__(self) -> int:
        return len(self._students)

    def __getitem__(self, place: Any) -> Any:
        """The sheet at a place, or those of a slice."""
        if isinstance(place, slice):
            return [self[i] for i in range(*place.indices(len(self)))]
        if not -len(self) <= place < len(self):
            raise IndexError(place)
        place %= len(self)
        return Sheet(self._students[place], self._codes[place], _StoredProblems(self, place))

    def problems(self, place: int) -> Sequence[Item]:
        """The problems of the sheet at a place; those of its part are kept until others are asked for."""
        part, inside = divmod(place, STUDENTS_PER_PART)
        if self._last[0] != part:
            self._last = (part, self.packed(part).sheets(self._exam))
        return self._last[1][inside].items

    def beginning(self, parts: range) -> frozenset[str]:
        """The groups whose first student is in some parts that follow each other."""
        first, behind = (bisect_left(self._begun, (end * STUDENTS_PER_PART, "")) for end in (parts.start, parts.stop))
        return frozenset(group for _, group in self._begun[first:behind])

    def packed(self, part: int, where_kept: bool = False) -> PackedChunk:
        """The students of a part and their packed problems, or where these are kept."""
        chosen = slice(part * STUDENTS_PER_PART, (part + 1) * STUDENTS_PER_PART)
        found = self._parts.kept_problem if where_kept else self._parts.problem
        return PackedChunk(
            tuple(zip(self._students[chosen], self._codes[chosen], strict=True)),
            tuple(found(part, problem) for problem in range(len(self._exam.tasks))),
        )


class _StoredProblems(Sequence[Item]):
    """The problems of a sheet, read when somebody asks for them: to join pages and to name files needs none."""

    def __init__(self, sheets: StoredSheets, place: int) -> None:
        self._sheets, self._place = sheets, place

    def __len__(self) -> int:
        return len(self._sheets.problems(self._place))

    def __getitem__(self, number: Any) -> Any:
        return self._sheets.problems(self._place)[number]

    def __iter__(self) -> Iterator[Item]:
        return iter(self._sheets.problems(self._place))
