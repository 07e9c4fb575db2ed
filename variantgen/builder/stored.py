"""The sheets of a build as its parts hold them: read when they are asked for, never all at once."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any

from variantgen.builder.jobs import PackedChunk
from variantgen.builder.unfinished import Unfinished
from variantgen.exam.exam_file import Exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet, variant_codes
from variantgen.outputs.formats import STUDENTS_PER_PART


class StoredSheets(Sequence[Sheet]):
    """The sheets in their order; to go through them in turn is best."""

    def __init__(self, exam: Exam, students: Sequence[Student], parts: Unfinished, taken: Collection[str] = ()) -> None:
        self._exam, self._students, self._parts = exam, students, parts
        self._codes = variant_codes(exam.seed, students, taken)
        self._begun = {student.group: place for place, student in reversed(list(enumerate(students)))}
        self._last: tuple[int, tuple[Sheet, ...]] = (-1, ())

    def __len__(self) -> int:
        return len(self._students)

    def __getitem__(self, place: Any) -> Any:
        """The sheet at a place, or those of a slice."""
        if isinstance(place, slice):
            return [self[i] for i in range(*place.indices(len(self)))]
        if not -len(self) <= place < len(self):
            raise IndexError(place)
        part, inside = divmod(place % len(self), STUDENTS_PER_PART)
        if self._last[0] != part:
            self._last = (part, self.packed(part).sheets(self._exam))
        return self._last[1][inside]

    def beginning(self, parts: range) -> frozenset[str]:
        """The groups whose first student is in some parts that follow each other."""
        places = range(parts.start * STUDENTS_PER_PART, parts.stop * STUDENTS_PER_PART)
        return frozenset(group for group, place in self._begun.items() if place in places)

    def packed(self, part: int) -> PackedChunk:
        """The students of a part and their packed problems."""
        chosen = slice(part * STUDENTS_PER_PART, (part + 1) * STUDENTS_PER_PART)
        return PackedChunk(
            tuple(zip(self._students[chosen], self._codes[chosen], strict=True)),
            tuple(self._parts.problem(part, problem) for problem in range(len(self._exam.tasks))),
        )
