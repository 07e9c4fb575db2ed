"""The sheet of one student of an exam, without building the exam: what the class would see."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from variantgen.errors import InputError
from variantgen.exam.allocation import DrawRequest, ProblemSampler, next_draws_of, resolve_duplicates
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet, variant_codes
from variantgen.variants.draw import check_room
from variantgen.variants.similarity import Traits
from variantgen.variants.variant import Variant


def one_sheet(exam: Exam, students: Sequence[Student], place: int = 0) -> Sheet:
    """The sheet of the student at a place in the class, as a build for the whole class would make it.

    Nobody has the variant of another: all are drawn for it. Raises InputError where a problem leaves too few variants,
    VerificationError where two computations of one disagree.
    """
    return DrawnClass(exam, students).sheet(place)


class DrawnClass:
    """The problems of a whole class, drawn so that nobody has the variant of another, for the sheets of some of them.

    Raises InputError and VerificationError, as its sheets do.
    """

    def __init__(self, exam: Exam, students: Sequence[Student]) -> None:
        self._exam, self._students = exam, students
        self._drawer = drawer = ProblemSampler(exam)
        self._codes = variant_codes(exam.seed, students)
        self._requests = requests = [
            DrawRequest(each, problem) for each in students for problem in range(len(exam.tasks))
        ]

        def more(owners: Sequence[int], used: Sequence[int]) -> Traits:
            again = [replace(requests[i], used=done) for i, done in zip(owners, used, strict=True)]
            return drawer.traits(again, drawer.variants(again))

        try:
            check_room([drawer.drawing(request) for request in requests])
            first = drawer.traits(requests, drawer.variants(requests))
            self._changed = next_draws_of(requests, resolve_duplicates(drawer, requests, first, more))
        except InputError as error:
            raise error.located(str(exam.path)) from None

    def variants(self) -> list[Variant]:
        """The variants of the class, student by student. Raises InputError."""
        return self._drawer.variants([self._changed.get(i, request) for i, request in enumerate(self._requests)])

    def sheet(self, place: int) -> Sheet:
        """The sheet of the student at a place in the class. Raises InputError."""
        start = place * len(self._exam.tasks)
        own = [self._changed.get(i, self._requests[i]) for i in range(start, start + len(self._exam.tasks))]
        try:
            items = self._drawer.items(own, self._drawer.variants(own))
        except InputError as error:
            raise error.located(str(self._exam.path)) from None
        return Sheet(self._students[place], self._codes[place], tuple(items))
