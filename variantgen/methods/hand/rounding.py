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
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.algebra.expression import Total, Value
from variantgen.algebra.values import in_order
from variantgen.algebra.vectorised import Operations, rounded_at
from variantgen.families.family import Form
from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.methods.choice import natural
from variantgen.methods.compose import work_out
from variantgen.methods.linkage.problem import Task, task_of
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.variants.variant import Variant, solve_variants

Table = NDArray[np.float64]
Numbers = dict[str, Table]  # printed, by parameter
Flags = NDArray[np.bool_]

DIGITS = 3  # significant digits of a careful hand calculation
_HALF_DEGREE_DIGIT = 0.05  # degrees: angles are written with one decimal
_DEVIATIONS = 3.0
_SAME = 1e-7  # relative difference within which repeated steps lead to the answers of a variant
_MODELS = 16  # variants of a form whose steps are repeated with the data of others
_OF_AXES = ("x", "y", "angle")
_TOGETHER = 64  # variants whose derivatives are computed at once


class RepeatableCalculation:
    """The computation behind a worked solution, which can be repeated with the data of other variants of its form.

    ``given`` are the names of given values by identity. A rounded value has its own place among the operations; those
    are in the order of the rows of the tables of rounded numbers.
    """

    def __init__(self, answers: Sequence[Value], given: Mapping[int, str]) -> None:
        self.operations = Operations()
        places: dict[int, int] = {}
        measures = []
        for value in in_order(answers):
            if value.expression is None:
                name = given.get(id(value))
                place = self.operations.constant(value.exact) if name is None else self.operations.named(name)
            else:
                place = self.operations.of(value.expression, places)
                if not _is_copy(value):
                    place = self.operations.rounded_at(place)
                    measures.append(value.measure)
            places[id(value)] = place
        self.answers = [places[id(answer)] for answer in answers]
        self.rounded = [place for place, (function, _) in self.operations.listed.items() if function is rounded_at]
        self._angles = [row for row, measure in enumerate(measures) if measure == "angle"]

    @staticmethod
    def of(task: Task) -> RepeatableCalculation:
        """That of a task. Raises LookupError where the methods do not lead to what is asked."""
        found = work_out(Book(task, style=natural(task)))
        # A datum in an unusual unit is converted first: the printed number is what that starts from.
        printed = {name: in_order([v])[0] if v.expression else v for name, v in task.given.items()}
        given = {id(leaf): name for name, leaf in printed.items()}
        return RepeatableCalculation([found[quantity.name] for quantity in task.asked], given)

    def repeat(self, data: Numbers) -> Table:
        """The answers for other data (printed numbers by parameter, shape (N,)), shape (answers, N)."""
        numbers = self._exact(data)
        return _rows([numbers[place] for place in self.answers], _size(data))

    def errors(self, data: Numbers, exact: Mapping[int, Table] | None = None) -> Table:
        """What rounding makes of the answers, in their units, shape (answers, N).

        ``exact`` are the numbers of answers and of what is rounded, by place, where they are known already.
        """
        size, numbers = _size(data), self._exact(data) if exact is None else exact
        right = _rows([numbers[place] for place in self.answers], size)
        rounded = _rows([numbers[place] for place in self.rounded], size)
        off = _half_units(self._angles, rounded)
        parts = [slice(start, start + _TOGETHER) for start in range(0, size, _TOGETHER)]
        return np.concatenate([self._errors(_cut(data, part), right[:, part], off[:, part]) for part in parts], axis=1)

    def _errors(self, data: Numbers, right: Table, off: Table) -> Table:
        # In row k of a table the k-th rounded value is off.
        numbers, row = self.operations.begin(data), 0
        for place, (function, operands) in self.operations.listed.items():
            if function is rounded_at:
                number = np.empty(off.shape)
                number[:] = numbers[operands[0]]
                number[row] += off[row]
                row += 1
            else:
                number = function(*[numbers[i] for i in operands])
            numbers[place] = number
        found = np.empty(right.shape)
        for place, exact, errors in zip(self.answers, right, found, strict=True):
            changes = np.abs(numbers[place] - exact)
            if changes.shape != off.shape:  # nothing before it is rounded
                changes = np.broadcast_to(changes, off.shape)
            bound, deviation = changes.sum(axis=0), np.sqrt((changes**2).sum(axis=0) / 3.0)
            np.minimum(bound, _DEVIATIONS * deviation, out=errors)
        return found

    def _exact(self, data: Numbers) -> list[Table]:
        """All numbers by place."""
        numbers = self.operations.begin(data)
        self.operations.run(numbers, self.operations.listed)
        return numbers


def _rows(rows: Sequence[Table], size: int) -> Table:
    """A table of rows, some of which are one number for all."""
    table = np.empty((len(rows), size))
    for row, numbers in zip(table, rows, strict=True):
        row[:] = numbers
    return table


def _cut(data: Numbers, chosen: Any) -> Numbers:
    """The data of chosen variants."""
    return {name: table[chosen] for name, table in data.items()}


def _size(data: Numbers) -> int:
    return next(iter(data.values())).size if data else 1


def _is_copy(value: Value) -> bool:
    """Whether a value is another one under its own name, which nobody rounds again."""
    item = value.expression
    while isinstance(item, Total) and len(item.terms) == 1:
        item = item.terms[0][1]
    return isinstance(item, Value)


def _half_units(angles: Sequence[int], numbers: Table) -> Table:
    """Half units of the last digits that are kept; nothing for a number that has no more digits.

    ``angles`` are the rows of angles.
    """
    size = np.abs(numbers)
    present = (size > 0) & np.isfinite(size)
    safe = np.where(present, size, 1.0)
    unit = 10.0 ** (np.floor(np.log10(safe) + 1e-12) - DIGITS + 1)
    unit[angles] = 2.0 * _HALF_DEGREE_DIGIT
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
        self._tried = 0  # models that have been worked out
        self._worked: list[_Model] = []
        self._common = Operations()
        for name in self._printed:
            self._common.named(name)

    def errors(self, variants: Sequence[Variant], motion: Motion, places: Sequence[int]) -> Table:
        """Absolute errors of the answers in their printed units (degrees for angles), shape (answers, N).

        ``places`` are the indices of the variants in the batch ``motion``. Infinite where no method leads to an answer.
        """
        found = np.full((len(self._asked), len(variants)), np.inf)
        length, chosen = variants[0].family.length_unit, list(places)
        exact = np.array([q.unit(length).from_si(q.value(motion)[chosen]) for q in self._asked])
        data = self._data(variants)
        numbers, left = self._common.begin(data), np.ones(len(variants), dtype=bool)
        with np.errstate(all="ignore"):
            for model in self._models():
                numbers += self._common.start[len(numbers) :]
                fits = self._matches_solver(model, numbers, exact, left)
                if fits.any():
                    found[:, fits] = model.worked.errors(_cut(data, fits), model.exact(numbers, fits))
                    left &= ~fits
                    if not left.any():
                        return found
            for i in np.flatnonzero(left).tolist():
                found[:, i] = self._alone(variants[i], motion, places[i], _cut(data, slice(i, i + 1)), exact[:, i])
        return found

    def _alone(self, variant: Variant, motion: Motion, place: int, data: Numbers, exact: Table) -> Table:
        """The errors of a variant by its own steps; infinite for an answer to which they do not lead."""
        try:
            worked = RepeatableCalculation.of(task_of(variant, motion, place, self._asked))
        except NOT_APPLICABLE:
            return np.full(len(self._asked), np.inf)
        pairs = zip(self._asked, worked.repeat(data)[:, 0], exact, strict=True)
        right = [bool(_equals_solver(quantity, found, number)) or number == 0 for quantity, found, number in pairs]
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
            return RepeatableCalculation.of(task_of(variants[number], motion, number, self._asked))
        except NOT_APPLICABLE:
            return None

    @property
    def _printed(self) -> list[str]:
        return [name for name, parameter in self._form.parameters.items() if parameter.unit is not None]

    def _data(self, variants: Sequence[Variant]) -> Numbers:
        """The printed numbers by parameter, magnitudes of rates as a solution has them."""
        found = {}
        for name in self._printed:
            column = np.array([float(variant.printed[name]) for variant in variants])
            found[name] = np.abs(column) if self._form.parameters[name].is_rate else column
        return found

    def _matches_solver(self, model: _Model, numbers: list[Any], exact: Table, left: Flags) -> Flags:
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

    def exact(self, numbers: Sequence[Table], chosen: Flags) -> dict[int, Table]:
        """The numbers of answers and of what is rounded, of chosen variants, by their places in the steps."""
        own = {place: numbers[self._places[place]] for place in (*self.worked.answers, *self.worked.rounded)}
        return {place: number[chosen] if number.ndim else number for place, number in own.items()}
