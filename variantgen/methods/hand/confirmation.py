"""Answers confirmed by the steps that a solution would print, signs included, for a batch of variants of a form.

The steps of one variant are repeated with the data of the others that have the same choices and senses; where they do
not lead to the answers of a variant, that one has steps of its own, which must. A sense that steps read off the figure
is that of the variant whose steps they are: its sign is confirmed there, and for the others by the independent
computation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.methods.hand.repeatable_calculation import Array, RepeatableCalculation, cut, printed_data
from variantgen.methods.linkage.problem import AGREES, task_of
from variantgen.methods.natural_answers import natural_answers
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.variants.attempts import VerificationError
from variantgen.variants.variant import Variant

_MOST = 64  # steps that are kept for variants to come
_SAME_ANGLE = 1e-7  # radians
_ROUNDING = 16 * float(np.finfo(float).eps)  # of a coordinate
_NOTHING = 1e-12  # of the size: points of one place, but for rounding


class UnconfirmedError(VerificationError):
    """The steps of a solution lead to other answers of this variant than the solver."""

    def __init__(self, message: str, variant: Variant) -> None:
        super().__init__(message)
        self.variant = variant


def confirm_answers(
    variants: Sequence[Variant],
    asked: Sequence[Quantity],
    motion: Motion,
    places: Sequence[int],
    worked_out: Array | None = None,
) -> None:
    """Raise UnconfirmedError for the first variant to whose answers its steps do not lead.

    ``places`` are the indices of the variants, which share one form, in the batch ``motion``; ``worked_out`` is to
    which answers their steps lead as far as that is known, shape (answers, N). A variant to which no method applies
    stands on the independent computation alone, and so does an extreme of a turn. The form remembers steps for variants
    to come.
    """
    form = variants[0].form
    steady = [not quantity.is_extreme for quantity in asked]
    asked = [quantity for quantity in asked if not quantity.is_extreme]
    if not asked:
        return
    batch = _Batch(variants, asked, motion, places)
    known: list[tuple[Variant, RepeatableCalculation]] = form.remembered.setdefault(
        ("confirmed by", batch.family, tuple(asked)), []
    )
    with np.errstate(all="ignore"):
        if worked_out is not None:
            batch.strike(batch.left, worked_out[steady], np.ones(len(variants)))
        for model, steps in known:
            batch.confirm(model, steps)
        while batch.left:
            i = batch.left[0]
            task = task_of(variants[i], motion, places[i], asked)
            try:
                steps = RepeatableCalculation.of(task, natural_answers(task))
            except NOT_APPLICABLE:
                batch.left.pop(0)
                continue
            batch.confirm(variants[i], steps)
            if i in batch.left:
                raise _error(variants[i])
            if len(known) < _MOST:
                known.append((variants[i], steps))


def _error(variant: Variant) -> UnconfirmedError:
    data = ", ".join(f"{name}={value}" for name, value in variant.printed.items())
    what = f"{variant.family.name}: the steps of its solution lead to other answers than the solver"
    return UnconfirmedError(what + (f" for {data}" if data else ""), variant)


class _Batch:
    """The answers of the solver for variants of a form; ``left`` are the indices of those that are not confirmed."""

    def __init__(
        self, variants: Sequence[Variant], asked: Sequence[Quantity], motion: Motion, places: Sequence[int]
    ) -> None:
        self._form, self.family, self._asked = variants[0].form, variants[0].family.name, asked
        self._lies_as_drawn = any(quantity.refers_to_axes for quantity in asked)
        self._kinds = [self._kind(variant) for variant in variants]
        self._senses = [variant.sense for variant in variants]
        self._data, self._places = printed_data(self._form, variants), list(places)
        length = variants[0].family.length_unit
        self._right = [quantity.own_unit(length).from_si(quantity.value(motion)[self._places]) for quantity in asked]
        self._shortest = _shortest(motion)[self._places]
        self._near = [self._tolerance(quantity, motion, length) for quantity in asked]
        self.left = list(range(len(variants)))

    def confirm(self, model: Variant, steps: RepeatableCalculation) -> None:
        """Strike those to whose answers the steps of one of them lead."""
        kind = self._kind(model)
        chosen = [i for i in self.left if self._kinds[i] == kind]
        if not chosen:
            return
        mirrored = np.array([1 if self._lies_as_drawn else model.sense * self._senses[i] for i in chosen])
        self.strike(chosen, steps.repeat(cut(self._data, chosen)), mirrored)

    def strike(self, chosen: Sequence[int], found: Array, mirrored: Array) -> None:
        """Strike those of the chosen whose answers were found, of themselves or, where ``mirrored`` is -1, mirrored."""
        good = np.ones(len(chosen), dtype=bool)
        for quantity, numbers, right, near in zip(self._asked, found, self._right, self._near, strict=True):
            answers = numbers
            if quantity.turns_with_mirror:
                answers = numbers * mirrored
            gap = answers - right[chosen]
            if quantity.is_angle:
                gap = np.remainder(gap + 180.0, 360.0) - 180.0
            good &= (np.abs(gap) <= near[chosen]) | (answers == right[chosen])
        done = {i for i, is_good in zip(chosen, good.tolist(), strict=True) if is_good}
        self.left = [i for i in self.left if i not in done]

    def _kind(self, variant: Variant) -> tuple[float, ...]:
        """Choices, signs of rates, and where axes matter the pose: what the signs of answers depend on.

        A mirrored scene turns the other way, and nothing else changes in it.
        """
        signs = []
        for name, parameter in self._form.parameters.items():
            number = float(variant.printed[name])
            if parameter.unit is None or parameter.is_rate:
                signs.append(number if parameter.unit is None else float(np.sign(number)))
        return (*signs, *((variant.sense, variant.turns) if self._lies_as_drawn else ()))

    def _largest(self, vectors: Mapping[str, ComplexField], rates: Mapping[str, Field], size: Field) -> Array:
        """The fastest of points and rims, shape (N,): where only wheels turn, no named point may move at all."""
        found = [np.abs(vector)[self._places] for vector in vectors.values()]
        found += [np.abs(rate)[self._places] * size for rate in rates.values()]
        return np.asarray(np.max(found, axis=0))

    def _tolerance(self, quantity: Quantity, motion: Motion, length: str) -> Array:
        """What rounding of the arithmetic may change in an answer, in its printed unit (degrees), shape (N,)."""
        size = motion.length_scale()[self._places]
        largest = self._largest(motion.v, motion.omega, size)
        if quantity.order == 2:  # a steady motion along lines has only what rounding leaves of accelerations
            largest = np.maximum(largest**2 / size, self._largest(motion.a, motion.epsilon, size))
        value = np.abs(quantity.whole.value(motion)[self._places])
        scale = (
            largest / size
            if quantity.is_rotation
            else size * (1.0 + value / size) ** 2
            if quantity.is_length
            else np.maximum(1.0, value)
            if quantity.group in ("ratio", "turn")
            else largest
        )
        if quantity.component in ("angle", "sense"):  # nothing has neither
            return np.where(value <= AGREES * scale, np.inf, np.degrees(_SAME_ANGLE) if quantity.is_angle else 0.0)
        if quantity.is_angle:
            return np.full(len(self._places), np.degrees(_SAME_ANGLE))
        far = size / self._shortest  # also a rate is of the smallest body, not of the size
        agrees = np.maximum(AGREES, _ROUNDING * far * (far if quantity.is_rotation else 1.0))
        return np.asarray(quantity.own_unit(length).from_si(agrees * scale))


def _shortest(motion: Motion) -> Array:
    """The extent of the smallest body (m), shape (N,): to it, the rounding of large coordinates is largest."""
    found: Array = motion.length_scale()
    least = _NOTHING * found
    for points in motion.scene.bodies.values():
        places = np.array([motion.z[point] for point in points])
        extent = np.max(np.abs(places - places[0]), axis=0)
        found = np.where(extent > least, np.minimum(found, extent), found)
    return found
