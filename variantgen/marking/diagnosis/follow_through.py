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
from variantgen.variants.variant import Variant, solve_variants

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
        usable = [place for place, value in values.items() if _may_be_used(answers[place], value)]
        if not usable or len(values) < 2:
            return {}
        motion: Motion | None = None
        right = [answer.value for answer in answers]
        found: dict[int, list[int]] = {}
        for place in sorted(values):
            earlier = [other for other in usable if other < place]
            for own in _subsets(earlier):
                followed = self._steps.answers(variant, right, {other: values[other] for other in own})[place]
                if not _within(answers[place], followed, values[place]):
                    continue
                motion = motion or solve_variants([variant], motion_order(self._asked))
                wrong = {answers[other].quantity: _si(answers[other], values[other]) for other in own}
                if confirms(variant, motion, wrong, answers[place].quantity, _si(answers[place], float(followed))):
                    found[place] = own
                    break
        return found


def _subsets(places: Sequence[int]) -> list[list[int]]:
    """Which earlier answers may have been used: one, or all. More mixtures would find more by chance."""
    single = [[place] for place in places]
    return [*single, list(places)] if len(places) > 1 else single


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
