"""The steps of a solution gone again from an answer that somebody else has found: what follows from it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from variantgen.families.quantities import Quantity, motion_order
from variantgen.methods.hand.repeatable_calculation import Array, Numbers, RepeatableCalculation, cut, printed_data
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.variants.variant import Variant, solve_variants

Rows = NDArray[np.intp]

_SAME = 1e-7  # relative difference within which repeated steps lead to the answers of a variant
_MOST = 32  # steps that are kept for variants to come


class FollowingSteps:
    """The steps of solutions of one form, asked for the same quantities; those of one variant serve others too."""

    def __init__(self, asked: Sequence[Quantity]) -> None:
        self._asked = tuple(asked)
        self._known: list[RepeatableCalculation] = []

    def answers(self, variant: Variant, right: Sequence[float], pinned: Mapping[int, float]) -> Array:
        """The answers that follow where those at the places ``pinned`` are the numbers given, shape (answers,)."""
        found: Array = self.of_batch([variant], [right], [pinned])[0]
        return found

    def of_batch(
        self, variants: Sequence[Variant], right: Sequence[Sequence[float]], pinned: Sequence[Mapping[int, float]]
    ) -> Array:
        """The answers that follow in many cases, shape (N, answers).

        All in printed units, magnitudes without a sign; ``right`` are the answers of the variants. Not a number where
        the steps of no method lead to the right answers, and where nothing can be put in the place of an answer alone.
        """
        found = np.full((len(variants), len(self._asked)), np.nan)
        if not len(variants):
            return found
        data = printed_data(variants[0].form, variants)
        with np.errstate(all="ignore"):
            for steps, rows, signs in self._serving(variants, data, np.array(right).T):
                alike: dict[tuple[int, ...], list[int]] = defaultdict(list)
                for k, row in enumerate(rows):
                    alike[tuple(pinned[row])].append(k)
                for places, members in alike.items():
                    own, sign = rows[members], signs[:, members]
                    numbers = {place: sign[place] * [pinned[row][place] for row in own] for place in places}
                    found[own] = (sign * _followed(steps, cut(data, own), numbers)).T
        return np.where([quantity.is_magnitude for quantity in self._asked], np.abs(found), found)

    def _serving(
        self, variants: Sequence[Variant], data: Numbers, right: Array
    ) -> Iterator[tuple[RepeatableCalculation, Rows, Array]]:
        """Steps that lead to the answers of variants but for their signs, the rows of these, and the signs.

        A mirrored mechanism has the same steps and turns the other way; the signs have the shape (answers, rows).
        Variants that no steps serve are left out.
        """
        left = np.arange(len(variants))
        for known in self._known:
            left, own, signs = _served(known, data, right, left)
            yield known, own, signs
        while left.size:
            first = variants[int(left[0])]
            steps = self._steps_of(first)
            if steps is not None:
                left, own, signs = _served(steps, data, right, left)
                if own.size:
                    self._known = [*self._known[1 - _MOST :], steps]
                    yield steps, own, signs
            left = np.array([row for row in left.tolist() if variants[row] is not first], dtype=np.intp)

    def _steps_of(self, variant: Variant) -> RepeatableCalculation | None:
        """The steps of the solution of a variant; None where no method leads to what is asked."""
        motion = solve_variants([variant], motion_order(self._asked))
        try:
            return RepeatableCalculation.of(task_of(variant, motion, 0, self._asked))
        except NOT_APPLICABLE:
            return None


def _served(steps: RepeatableCalculation, data: Numbers, right: Array, rows: Rows) -> tuple[Rows, Rows, Array]:
    """The rows whose answers steps do not lead to, those that they serve, and the signs of these."""
    wanted = right[:, rows]
    found = steps.repeat(cut(data, rows))
    good = np.all(np.abs(np.abs(found) - np.abs(wanted)) <= _SAME * np.abs(wanted), axis=0)
    return rows[~good], rows[good], np.where(found * wanted < 0, -1.0, 1.0)[:, good]


def _followed(steps: RepeatableCalculation, data: Numbers, pinned: Mapping[int, Array]) -> Array:
    """The answers with numbers put in the places of some of them, shape (answers, N)."""
    operations = steps.operations
    numbers = operations.begin(data)
    size = next(iter(data.values())).size
    found_at = [_first_place(steps, answer) for answer in range(len(steps.answers))]
    for answer, number in pinned.items():
        place, sign = found_at[answer]
        is_shared = any(found_at[other][0] == place for other in range(answer) if other not in pinned)
        if place not in operations.listed or is_shared:  # an answer before it would change as well
            return np.full((len(steps.answers), size), np.nan)
        numbers[place] = sign * number
    operations.run(numbers, operations.listed)
    return np.array([np.broadcast_to(numbers[place], (size,)) for place in steps.answers])


def _first_place(steps: RepeatableCalculation, answer: int) -> tuple[int, float]:
    """Where an answer is found but for its sign, which is what later steps use; and that sign."""
    listed = steps.operations.listed
    place, sign = steps.answers[answer], 1.0
    while place in listed and listed[place][0] is np.negative:
        place, sign = listed[place][1][0], -sign
    return place, sign
