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

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from variantgen.families.family import Form
from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.methods.batch import number_of
from variantgen.methods.book import Book
from variantgen.methods.choice import natural
from variantgen.methods.compose import work_out
from variantgen.methods.expression import Total, Value
from variantgen.methods.settle import in_order
from variantgen.methods.task import Task, task_of
from variantgen.variants.variant import Variant, solve_variants

Table = NDArray[np.float64]
Numbers = dict[str, Table]  # printed, by parameter
_Key = TypeVar("_Key", int, str)

DIGITS = 3  # significant digits of a careful hand calculation
_HALF_DEGREE_DIGIT = 0.05  # degrees: angles are written with one decimal
_DEVIATIONS = 3.0
_SAME = 1e-7  # relative difference within which repeated steps lead to the answers of a variant
_MODELS = 16  # variants of a form whose steps are repeated with the data of others
_OF_AXES = ("x", "y", "angle")
_TOGETHER = 64  # variants whose derivatives are computed at once


class Worked:
    """The computation behind a worked solution, which can be repeated with the data of other variants of its form.

    Raises LookupError where the methods do not lead to what is asked.
    """

    def __init__(self, task: Task) -> None:
        found = work_out(Book(task, style=natural(task)))
        self.answers = [found[quantity.name] for quantity in task.asked]
        self._values = in_order(self.answers)
        printed = {id(leaf): name for name, value in task.given.items() for leaf in in_order([value])[:1]}
        self._leaves = {id(value): printed[id(value)] for value in self._values if id(value) in printed}
        self._rounded = [value for value in self._values if value.expression is not None and not _is_copy(value)]

    def repeat(self, data: Numbers) -> Table:
        """The answers for other data (printed numbers by parameter, shape (N,)), shape (answers, N)."""
        return np.array(list(self.in_turn(data, {})))

    def in_turn(self, data: Numbers, numbers: dict[int, Table]) -> Iterator[Table]:
        """One answer after the other for other data, shape (N,); ``numbers`` takes those of the values worked out."""
        values, shape = iter(self._values), (_size(data),)
        for answer in self.answers:
            while id(answer) not in numbers:
                value = next(values)
                numbers[id(value)] = self._of(value, data, numbers)
            yield np.broadcast_to(numbers[id(answer)], shape)

    def errors(self, data: Numbers, exact: dict[int, Table] | None = None) -> Table:
        """What rounding makes of the answers, in their units, shape (answers, N).

        ``exact`` are the numbers of all values for these data, where they are known already.
        """
        if exact is None:
            exact = {}
            for value in self._values:
                exact[id(value)] = self._of(value, data, exact)
        size = _size(data)
        parts = [slice(start, start + _TOGETHER) for start in range(0, size, _TOGETHER)]
        if len(parts) == 1:
            return self._errors(data, exact)
        return np.concatenate([self._errors(_cut(data, part), _cut(exact, part)) for part in parts], axis=1)

    def _errors(self, data: Numbers, exact: dict[int, Table]) -> Table:
        rounded = np.empty((len(self._rounded), _size(data)))
        rows = {id(value): row for row, value in enumerate(self._rounded)}
        for key, row in rows.items():
            rounded[row] = exact[key]
        off = _half_units([value.measure for value in self._rounded], rounded)
        # In row k of a table the k-th rounded value is off.
        numbers: dict[int, Table] = {}
        for value in self._values:
            key = id(value)
            number = self._of(value, data, numbers)
            if key in rows:
                table = np.empty(off.shape)
                table[:] = number
                table[rows[key]] += off[rows[key]]
                number = table
            numbers[key] = number
        found = np.empty((len(self.answers), _size(data)))
        for answer, errors in zip(self.answers, found, strict=True):
            changes = np.abs(np.broadcast_to(numbers[id(answer)] - exact[id(answer)], rounded.shape))
            bound, deviation = np.sum(changes, axis=0), np.sqrt(np.sum(changes**2, axis=0) / 3.0)
            np.minimum(bound, _DEVIATIONS * deviation, out=errors)
        return found

    def _of(self, value: Value, data: Numbers, numbers: dict[int, Table]) -> Table:
        """The number of a value from those before it."""
        if value.expression is not None:
            return number_of(value.expression, numbers)
        name = self._leaves.get(id(value))
        return np.asarray(value.exact) if name is None else data[name]


def _cut(numbers: dict[_Key, Table], chosen: Any) -> dict[_Key, Table]:
    """Those of chosen variants; a number that is the same for all of them stays."""
    return {key: table[chosen] if table.ndim else table for key, table in numbers.items()}


def _size(data: Numbers) -> int:
    return next(iter(data.values())).size if data else 1


def _is_copy(value: Value) -> bool:
    """Whether a value is another one under its own name, which nobody rounds again."""
    item = value.expression
    while isinstance(item, Total) and len(item.terms) == 1:
        item = item.terms[0][1]
    return isinstance(item, Value)


def _half_units(measures: Sequence[str], numbers: Table) -> Table:
    """Half units of the last digits that are kept, by rows; nothing for a number that has no more digits."""
    size = np.abs(numbers)
    present = (size > 0) & np.isfinite(size)
    safe = np.where(present, size, 1.0)
    unit = 10.0 ** (np.floor(np.log10(safe) + 1e-12) - DIGITS + 1)
    unit[[row for row, measure in enumerate(measures) if measure == "angle"]] = 2.0 * _HALF_DEGREE_DIGIT
    short = np.abs(np.round(safe / unit) * unit - safe) <= 1e-9 * safe
    return np.where(present & ~short, 0.5 * unit, 0.0)


class HandCalculation:
    """Errors of hand calculations of the variants of one form.

    ``models`` gives the variants whose steps are tried, always the same ones in the same order, so that what is found
    for a variant does not depend on the others of its batch. It is called when the first variant comes.
    """

    def __init__(self, form: Form, asked: Sequence[Quantity], models: Callable[[int], Sequence[Variant]]) -> None:
        self._form, self._asked, self._draw = form, tuple(asked), models
        self._drawn: tuple[Sequence[Variant], Motion | None] | None = None
        self._worked: list[Worked | None] = []

    def errors(self, variants: Sequence[Variant], motion: Motion, places: Sequence[int]) -> Table:
        """Absolute errors of the answers in their printed units (degrees for angles), shape (answers, N).

        ``places`` are the indices of the variants in the batch ``motion``. Infinite where no method leads to an answer.
        """
        found = np.full((len(self._asked), len(variants)), np.inf)
        length, chosen = variants[0].family.length_unit, list(places)
        exact = np.array([q.unit(length).from_si(q.value(motion)[chosen]) for q in self._asked])
        data = self._data(variants)
        left = np.arange(len(variants))
        with np.errstate(all="ignore"):
            for worked in self._models():
                own, numbers = _cut(data, left), dict[int, Table]()
                fits = self._leads_to(worked.in_turn(own, numbers), exact[:, left])
                if np.any(fits):
                    found[:, left[fits]] = worked.errors(_cut(own, fits), _cut(numbers, fits))
                    left = left[~fits]
                    if not left.size:
                        return found
            for i in left.tolist():
                found[:, i] = self._alone(variants[i], motion, places[i], _cut(data, slice(i, i + 1)))
        return found

    def _alone(self, variant: Variant, motion: Motion, place: int, data: Numbers) -> Table:
        """The errors of a variant by its own steps."""
        try:
            worked = Worked(task_of(variant, motion, place, self._asked))
        except LookupError:
            return np.full(len(self._asked), np.inf)
        return worked.errors(data)[:, 0]

    def _models(self) -> Iterator[Worked]:
        """The steps of the model variants, worked out one after the other as they are needed."""
        for number in range(_MODELS):
            if number == len(self._worked):
                self._worked.append(self._model(number))
            worked = self._worked[number]
            if worked is not None:
                yield worked

    def _model(self, number: int) -> Worked | None:
        if self._drawn is None:
            variants = self._draw(_MODELS)
            if not any(quantity.component in _OF_AXES for quantity in self._asked):
                # How a scene lies on paper changes no magnitude: in one pose there are fewer different solutions.
                variants = [replace(variant, sense=1, turns=0) for variant in variants]
            order = max(quantity.order for quantity in self._asked)
            self._drawn = variants, solve_variants(variants, order) if variants else None
        variants, motion = self._drawn
        if number >= len(variants):
            return None
        assert motion is not None, "there are variants"
        try:
            return Worked(task_of(variants[number], motion, number, self._asked))
        except LookupError:
            return None

    def _data(self, variants: Sequence[Variant]) -> Numbers:
        """The printed numbers by parameter, magnitudes of rates as a solution has them."""
        found = {}
        for name, parameter in self._form.parameters.items():
            if parameter.unit is not None:
                column = np.array([float(variant.printed[name]) for variant in variants])
                found[name] = np.abs(column) if parameter.is_rate else column
        return found

    def _leads_to(self, answers: Iterator[Table], exact: Table) -> NDArray[np.bool_]:
        """Whether repeated steps give the answers of the solver, but for their signs, shape (N,).

        Further answers are not worked out where none is right.
        """
        good = np.ones(exact.shape[1], dtype=bool)
        for quantity, repeated, number in zip(self._asked, answers, exact, strict=True):
            if quantity.is_angle:
                turn = np.abs((repeated - number + 180.0) % 360.0 - 180.0)
                good &= turn <= np.degrees(_SAME)
            elif quantity.component != "sense":
                size = np.abs(number)
                good &= np.abs(np.abs(repeated) - size) <= _SAME * size
            if not good.any():
                break
        return good
