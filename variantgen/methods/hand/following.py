"""The steps of a solution gone again from an answer that somebody else has found: what follows from it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from variantgen.families.quantities import Quantity, motion_order
from variantgen.methods.hand.repeatable_calculation import Array, Numbers, RepeatableCalculation, printed_data
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.variants.variant import Variant, solve_variants

_SAME = 1e-7  # relative difference within which repeated steps lead to the answers of a variant
_MOST = 32  # steps that are kept for variants to come


class FollowingSteps:
    """The steps of solutions of one form, asked for the same quantities; those of one variant serve others too."""

    def __init__(self, asked: Sequence[Quantity]) -> None:
        self._asked = tuple(asked)
        self._known: list[RepeatableCalculation] = []

    def answers(self, variant: Variant, right: Sequence[float], pinned: Mapping[int, float]) -> Array:
        """The answers that follow where those at the places ``pinned`` are the numbers given, shape (answers,).

        All in printed units, magnitudes without a sign; ``right`` are the answers of the variant. Not a number where
        the steps of no method lead to the right answers, and where nothing can be put in the place of an answer alone.
        """
        data = printed_data(variant.form, [variant])
        found = self._steps(variant, data, np.array(right))
        if found is None:
            return np.full(len(self._asked), np.nan)
        steps, signs = found
        with np.errstate(all="ignore"):
            own = signs * _followed(steps, data, {place: signs[place] * number for place, number in pinned.items()})
        return np.where([quantity.is_magnitude for quantity in self._asked], np.abs(own), own)

    def _steps(self, variant: Variant, data: Numbers, right: Array) -> tuple[RepeatableCalculation, Array] | None:
        """Steps that lead to the answers of a variant but for their signs, and the signs, shape (answers,).

        A mirrored mechanism has the same steps and turns the other way. Those that served last are tried first.
        """
        for i, known in enumerate(self._known):
            signs = _signs(known, data, right)
            if signs is not None:
                self._known.insert(0, self._known.pop(i))
                return known, signs
        motion = solve_variants([variant], motion_order(self._asked))
        try:
            own = RepeatableCalculation.of(task_of(variant, motion, 0, self._asked))
        except NOT_APPLICABLE:
            return None
        signs = _signs(own, data, right)
        if signs is None:
            return None
        self._known = [own, *self._known[: _MOST - 1]]
        return own, signs


def _signs(steps: RepeatableCalculation, data: Numbers, right: Array) -> Array | None:
    """The signs by which the answers of steps differ from the right ones, shape (answers,); None for other answers."""
    with np.errstate(all="ignore"):
        found = steps.repeat(data)[:, 0]
    if not np.all(np.abs(np.abs(found) - np.abs(right)) <= _SAME * np.abs(right)):
        return None
    return np.where(found * right < 0, -1.0, 1.0)


def _followed(steps: RepeatableCalculation, data: Numbers, pinned: Mapping[int, float]) -> Array:
    """The answers with numbers put in the places of some of them."""
    operations = steps.operations
    numbers = operations.begin(data)
    found_at = [_first_place(steps, answer) for answer in range(len(steps.answers))]
    for answer, number in pinned.items():
        place, sign = found_at[answer]
        is_shared = any(found_at[other][0] == place for other in range(answer) if other not in pinned)
        if place not in operations.listed or is_shared:  # an answer before it would change as well
            return np.full(len(steps.answers), np.nan)
        numbers[place] = np.array([sign * number])
    operations.run(numbers, operations.listed)
    return np.array([float(np.ravel(numbers[place])[0]) for place in steps.answers])


def _first_place(steps: RepeatableCalculation, answer: int) -> tuple[int, float]:
    """Where an answer is found but for its sign, which is what later steps use; and that sign."""
    listed = steps.operations.listed
    place, sign = steps.answers[answer], 1.0
    while place in listed and listed[place][0] is np.negative:
        place, sign = listed[place][1][0], -sign
    return place, sign
