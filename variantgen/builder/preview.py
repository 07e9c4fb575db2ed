"""The sheet of one student of an exam, without building the exam: what the class would see."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from variantgen.errors import InputError
from variantgen.exam.allocation import DrawRequest, ProblemSampler, next_draws_of, resolve_duplicates
from variantgen.exam.exam_file import Exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet, variant_codes
from variantgen.variants.draw import check_room
from variantgen.variants.similarity import Traits


def one_sheet(exam: Exam, students: Sequence[Student], place: int = 0) -> Sheet:
    """The sheet of the student at a place in the class, as a build for the whole class would make it.

    Nobody has the variant of another: all are drawn for it. Raises InputError where a problem leaves too few variants,
    VerificationError where two computations of one disagree.
    """
    requests = [DrawRequest(student, problem) for student in students for problem in range(len(exam.tasks))]
    try:
        drawer = ProblemSampler(exam)
        check_room([drawer.drawing(request) for request in requests])
        first = drawer.traits(requests, drawer.variants(requests))

        def more(owners: Sequence[int], used: Sequence[int]) -> Traits:
            again = [replace(requests[i], used=done) for i, done in zip(owners, used, strict=True)]
            return drawer.traits(again, drawer.variants(again))

        changed = next_draws_of(requests, resolve_duplicates(drawer, requests, first, more))
        start = place * len(exam.tasks)
        own = [changed.get(i, requests[i]) for i in range(start, start + len(exam.tasks))]
        items = drawer.items(own, drawer.variants(own))
    except InputError as error:
        raise error.located(str(exam.path)) from None
    return Sheet(students[place], variant_codes(exam.seed, students)[place], tuple(items))
