"""Answers that are right given the student's own earlier ones.

The steps of the worked solution are gone again from the student's numbers, and what follows is confirmed by a second
way (:mod:`variantgen.marking.diagnosis.consequences`). An earlier answer is taken as it is only if it is not zero, has
the sense of the right one, and is a tenth to ten times as large: nobody gains by writing numbers that make the rest
easy.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from variantgen.exam.sheets import Answer
from variantgen.families.quantities import Quantity, motion_order
from variantgen.marking.diagnosis.consequences import confirms
from variantgen.marking.key import scale
from variantgen.mechanism.motion import Motion
from variantgen.methods.hand.following import FollowingSteps
from variantgen.methods.hand.repeatable_calculation import Array
from variantgen.variants.variant import Variant, solve_variants

# A variant, the answers of the sheet, and the wrong values by the place of the answer, in its unit.
Wrong = tuple[Variant, Sequence[Answer], Mapping[int, float]]

_LEAST, _LARGEST = 0.1, 10.0
_OUTSIDE = ("angle", "sense")  # what later steps do not start from


class FollowThrough:
    """Follow-through for problems of one form that ask for the same."""

    def __init__(self, asked: Sequence[Quantity]) -> None:
        self._asked = tuple(asked)
        self._steps = FollowingSteps(asked)

    def granted(self, variant: Variant, answers: Sequence[Answer], values: Mapping[int, float]) -> dict[int, list[int]]:
        """The wrong answers that follow from earlier wrong ones: by place, the places that they follow from.

        ``values`` are the wrong values by the place of the answer, in its unit.
        """
        return self.granted_to([(variant, answers, values)])[0]

    def granted_to(self, students: Sequence[Wrong]) -> list[dict[int, list[int]]]:
        """What is granted to each of many students, whose steps are gone together."""
        used = [_used(answers, values) for _, answers, values in students]
        rows = [(k, own) for k, every in enumerate(used) for own in every]
        followed = self._steps.of_batch(
            [students[k][0] for k, _ in rows],
            [[answer.value for answer in students[k][1]] for k, _ in rows],
            [{place: students[k][2][place] for place in own} for k, own in rows],
        )
        by_student: list[dict[tuple[int, ...], Array]] = [{} for _ in students]
        for (k, own), numbers in zip(rows, followed, strict=True):
            by_student[k][own] = numbers
        return [self._granted(*student, own) for student, own in zip(students, by_student, strict=True)]

    def _granted(
        self,
        variant: Variant,
        answers: Sequence[Answer],
        values: Mapping[int, float],
        followed: Mapping[tuple[int, ...], Array],
    ) -> dict[int, list[int]]:
        motion: Motion | None = None
        found: dict[int, list[int]] = {}
        for place in sorted(values):
            for own in _subsets([other for (other, *more) in followed if not more and other < place]):
                number = float(followed[own][place])
                if not _within(answers[place], number, values[place]):
                    continue
                motion = motion or solve_variants([variant], motion_order(self._asked))
                wrong = {answers[other].quantity: _si(answers[other], values[other]) for other in own}
                if confirms(variant, motion, wrong, answers[place].quantity, _si(answers[place], number)):
                    found[place] = list(own)
                    break
        return found


def _used(answers: Sequence[Answer], values: Mapping[int, float]) -> list[tuple[int, ...]]:
    """The wrong answers that a later one of a student may have been found from, alone and all before it together."""
    usable = sorted(place for place, value in values.items() if _may_be_used(answers[place], value))
    last = max(values, default=0)
    return list(
        dict.fromkeys(own for end in range(1, len(usable) + 1) for own in _subsets(usable[:end]) if own[-1] < last)
    )


def _subsets(places: Sequence[int]) -> list[tuple[int, ...]]:
    """Which earlier answers may have been used: one, or all. More mixtures would find more by chance."""
    single: list[tuple[int, ...]] = [(place,) for place in places]
    return [*single, tuple(places)] if len(places) > 1 else single


def _may_be_used(answer: Answer, value: float) -> bool:
    """Whether a wrong answer is one that somebody could have gone on with in good faith."""
    if answer.quantity.component in _OUTSIDE or answer.quantity.is_angle or not answer.value:
        return False
    return _LEAST <= value / answer.value <= _LARGEST


def _within(answer: Answer, followed: float, value: float) -> bool:
    """Whether a value is what follows, within the relative tolerance of the answer."""
    size = scale(answer)
    if not size or not math.isfinite(followed) or not answer.tolerance:
        return False
    width = answer.tolerance if answer.quantity.is_angle else answer.tolerance * abs(followed) / size
    return abs(value - followed) <= width


def _si(answer: Answer, value: float) -> float:
    return value * answer.unit.size
