"""How fast answers change with the numbers of a file: all changes of all variants as one batch."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from functools import partial
from itertools import product

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.algebra.expression import Expression, Variable
from variantgen.check.form_numbers import SI, FileNumber, with_numbers
from variantgen.families.family import Form
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.units import UNITS
from variantgen.families.quantities import Quantity, motion_order
from variantgen.mechanism.outcome import Outcome
from variantgen.variants.variant import Variant, solve_variants

Numbers = NDArray[np.float64]

CHANGE = 1e-3  # relative: so much a number is changed
_NOTHING = 1e-6  # relative: what rounding changes in an answer
_ROUNDING = 1e-9  # relative to the largest answer in the same unit


class AnswerRates:
    """How fast the answers of variants change with numbers of the file, relative to these.

    A number that is zero is changed by parts of the size of the mechanism, ``sizes`` (m), shape (variants,).
    """

    def __init__(self, variants: Sequence[Variant], left_out: frozenset[str], asked: Sequence[Quantity]) -> None:
        self._variants, self._left_out, self._asked = variants, left_out, asked
        motion = solve_variants(variants, motion_order(asked))
        self.sizes: Numbers = np.asarray(motion.length_scale(), dtype=float)
        values = [np.abs(np.asarray(q.value(motion), dtype=float)) for q in asked]
        values = [np.where(np.isfinite(value), value, 0.0) for value in values]
        units = [q.unit("m").name for q in asked]
        largest: dict[str, float] = {}
        for name, value in zip(units, values, strict=True):
            largest[name] = max(largest.get(name, 0.0), float(np.max(value)))
        rounding = [_NOTHING * value + _ROUNDING * largest[name] for name, value in zip(units, values, strict=True)]
        # Slower than this is rounding, beside large answers in the same unit too; shape (asked, variants).
        self.least: Numbers = np.array(rounding) / CHANGE

    def of(self, numbers: Sequence[FileNumber]) -> tuple[Numbers, NDArray[np.bool_]]:
        """The rates, shape (asked, numbers, variants), zero where nothing has a value, and what of it is solved.

        All changes are solved as one batch, in which the numbers are parameters.
        """
        form, values = self._with_parameters({place for number in numbers for place in number.places})
        batch: list[Variant] = []
        for sign, number in product((1, -1), numbers):
            for variant, size in zip(self._variants, self.sizes.tolist(), strict=True):
                moved = self._moved(values, number, sign, size)
                batch.append(replace(variant, form=form, printed={**variant.printed, **values, **moved}))
        motion = solve_variants(batch, motion_order(self._asked))
        shape = (2, len(numbers), len(self._variants))
        solved = (motion.outcome == Outcome.SOLVED).reshape(shape).all(axis=0)
        rates = []
        for quantity in self._asked:
            ahead, behind = np.reshape(quantity.value(motion), shape)
            with np.errstate(invalid="ignore"):  # what has no value is infinite, ahead and behind
                gap = ahead - behind
                gap = np.angle(np.exp(1j * gap)) if quantity.is_angle else gap
            rates.append(np.where(solved & np.isfinite(gap), gap, 0.0) / (2 * CHANGE))
        return np.array(rates), solved

    def _with_parameters(self, places: set[int]) -> tuple[Form, dict[str, Decimal]]:
        """The form with its numbers as further parameters, and their values."""
        form, values, parameters = self._variants[0].form, dict[str, Decimal](), dict[str, Parameter]()

        def named(place: int, value: float, measures: str) -> Expression:
            name = _name(place)
            values[name] = Decimal(repr(value))
            parameters[name] = Parameter(name, UNITS[SI.get(measures, "1")], (values[name],), symbol=name)
            return Variable(name)

        changed = with_numbers(form, self._left_out, {place: partial(named, place) for place in places})
        return replace(changed, parameters={**form.parameters, **parameters}), values

    @staticmethod
    def _moved(values: Mapping[str, Decimal], number: FileNumber, sign: int, size: float) -> dict[str, Decimal]:
        step = Decimal(repr(sign * CHANGE))
        names = [_name(place) for place in number.places]
        return {name: values[name] + step * (values[name] or Decimal(repr(size))) for name in names}


def _name(place: int) -> str:
    return f"number {place}"  # no name of a file has a space
