"""What a careful hand calculation with three significant digits makes of the answers of a solution.

Every intermediate result x_j is rounded by at most half a unit u_j of its third digit (0.05 degrees for an angle); a
result that has no more digits is not rounded at all. To first order the error of an answer y is

    dy = sum_j (dy/dx_j) r_j,   |r_j| <= u_j

The printed data are exact, since the key is computed from them. With independent r_j that are uniform on their
intervals the standard deviation is ``sqrt(sum (dy/dx_j u_j)^2 / 3)``; an answer is given three of these, but no more
than the bound ``sum |dy/dx_j u_j|`` that rounding cannot pass.

The steps are those of the written solution. As most variants of a form have the same steps, those of a few are repeated
with the data of the others, on arrays; a variant to whose answers none of them leads gets steps of its own.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.algebra.vectorised import Operations
from variantgen.families.family import Form
from variantgen.families.quantities import Quantity, motion_order
from variantgen.mechanism.motion import Motion
from variantgen.methods.hand.repeatable_calculation import Array, RepeatableCalculation, cut, printed_data
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.variants.variant import Variant, solve_variants

Flags = NDArray[np.bool_]

_SAME = 1e-7  # relative difference within which repeated steps lead to the answers of a variant
_MODELS = 16  # variants of a form whose steps are repeated with the data of others


class HandCalculation:
    """Errors of hand calculations of the variants of one form.

    ``models`` gives the variants whose steps are tried, always the same ones in the same order, so that what is found
    for a variant does not depend on the others of its batch. It is called when the first variant comes.
    """

    def __init__(self, form: Form, asked: Sequence[Quantity], models: Callable[[int], Sequence[Variant]]) -> None:
        self._form, self._asked, self._draw = form, tuple(asked), models
        self._drawn: tuple[Sequence[Variant], Motion | None] | None = None
        self._tried = 0  # models that have been worked out
        self._worked: list[_Model] = []
        self._common = Operations()
        for name, parameter in form.parameters.items():
            if parameter.unit is not None:
                self._common.named(name)

    def errors(self, variants: Sequence[Variant], motion: Motion, places: Sequence[int]) -> Array:
        """Absolute errors of the answers in their printed units (degrees for angles), shape (answers, N).

        ``places`` are the indices of the variants in the batch ``motion``. Infinite where no method leads to an answer.
        """
        found = np.full((len(self._asked), len(variants)), np.inf)
        length, chosen = variants[0].family.length_unit, list(places)
        exact = np.array([q.own_unit(length).from_si(q.value(motion)[chosen]) for q in self._asked])
        data = printed_data(self._form, variants)
        numbers, left = self._common.begin(data), np.ones(len(variants), dtype=bool)
        with np.errstate(all="ignore"):
            for model in self._models():
                numbers += self._common.start[len(numbers) :]
                fits = self._matches_solver(model, numbers, exact, left)
                if fits.any():
                    found[:, fits] = model.worked.errors(cut(data, fits), model.exact(numbers, fits))
                    left &= ~fits
                    if not left.any():
                        return found
            for i in np.flatnonzero(left).tolist():
                found[:, i] = self.own_errors(variants[i], motion, places[i])
        return found

    def own_errors(self, variant: Variant, motion: Motion, place: int) -> Array:
        """The errors of one variant by its own steps, shape (answers,); infinite where these lead to another answer."""
        try:
            worked = RepeatableCalculation.of(task_of(variant, motion, place, self._asked))
        except NOT_APPLICABLE:
            return np.full(len(self._asked), np.inf)
        length, data = variant.family.length_unit, printed_data(self._form, [variant])
        with np.errstate(all="ignore"):
            right = []
            for quantity, found in zip(self._asked, worked.repeat(data)[:, 0], strict=True):
                exact = quantity.own_unit(length).from_si(quantity.value(motion)[place])
                right.append(bool(_equals_solver(quantity, found, exact)) or exact == 0)
            return np.where(right, worked.errors(data)[:, 0], np.inf)

    def _models(self) -> Iterator[_Model]:
        """The steps of the model variants, worked out one after the other as they are needed.

        A model with the answers of an earlier one is left out, as nothing is left for it.
        """
        yield from self._worked
        while self._tried < _MODELS:
            worked = self._model(self._tried)
            self._tried += 1
            if worked is not None:
                model = _Model(worked, self._common)
                if all(model.answers != other.answers for other in self._worked):
                    self._worked.append(model)
                    yield model

    def _model(self, number: int) -> RepeatableCalculation | None:
        if self._drawn is None:
            variants = self._draw(_MODELS)
            if not any(quantity.refers_to_axes for quantity in self._asked):
                # How a scene lies on paper changes no magnitude: in one pose there are fewer different solutions.
                variants = [replace(variant, sense=1, turns=0) for variant in variants]
            order = motion_order(self._asked)
            self._drawn = variants, solve_variants(variants, order) if variants else None
        variants, motion = self._drawn
        if number >= len(variants):
            return None
        assert motion is not None, "there are variants"
        try:
            return RepeatableCalculation.of(task_of(variants[number], motion, number, self._asked))
        except NOT_APPLICABLE:
            return None

    def _matches_solver(self, model: _Model, numbers: list[Any], exact: Array, left: Flags) -> Flags:
        """Which of the variants that are ``left`` the steps of a model lead to the answers of the solver, but for their
        signs.

        Further answers are not worked out where none is right.
        """
        good = left
        for quantity, place, steps, number in zip(self._asked, model.answers, model.steps, exact, strict=True):
            self._common.run(numbers, steps)
            good = good & _equals_solver(quantity, numbers[place], number)
            if not good.any():
                break
        return good


def _equals_solver(quantity: Quantity, found: Any, exact: Any) -> Any:
    """Whether numbers are those of the solver, but for their signs."""
    if quantity.component == "sense":
        return np.True_
    if quantity.is_angle:
        return np.abs((found - exact + 180.0) % 360.0 - 180.0) <= np.degrees(_SAME)
    return np.abs(np.abs(found) - np.abs(exact)) <= _SAME * np.abs(exact)


class _Model:
    """Steps that are tried on all variants, with places of their numbers among those that all models share.

    ``steps`` are the places of what each answer needs besides those before it.
    """

    def __init__(self, worked: RepeatableCalculation, common: Operations) -> None:
        self.worked, self._places = worked, common.join(worked.operations)
        self.answers = [self._places[place] for place in worked.answers]
        own, self.steps, done = list(worked.operations.listed), list[list[int]](), 0
        for place in worked.answers:
            end = max(done, bisect_right(own, place))
            self.steps.append([self._places[i] for i in own[done:end]])
            done = end

    def exact(self, numbers: Sequence[Array], chosen: Flags) -> dict[int, Array]:
        """The numbers of answers and of what is rounded, of chosen variants, by their places in the steps."""
        own = {place: numbers[self._places[place]] for place in (*self.worked.answers, *self.worked.rounded)}
        return {place: number[chosen] if number.ndim else number for place, number in own.items()}
