"""The computation behind a worked solution, repeated with other data: its answers, and what rounding makes of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.algebra.expression import Total, Value
from variantgen.algebra.values import in_order
from variantgen.algebra.vectorised import Operations, rounded_at
from variantgen.families.family import Form
from variantgen.methods.choice import natural
from variantgen.methods.linkage.problem import Task
from variantgen.methods.natural_answers import work_out
from variantgen.methods.solution.book import Book
from variantgen.variants.variant import Variant

Array = NDArray[np.float64]
Numbers = dict[str, Array]  # printed, by parameter

DIGITS = 3  # significant digits of a careful hand calculation
_HALF_DEGREE_DIGIT = 0.05  # degrees: angles are written with one decimal
_DEVIATIONS = 3.0
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
            name = given.get(id(value))
            if value.expression is None or name is not None:  # an instant that is found is kept with all its digits
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
    def of(task: Task, answers: Mapping[str, Value] | None = None) -> RepeatableCalculation:
        """That of a task, with its ``answers`` by the names of the quantities or else group by group the usual way.

        Raises one of NOT_APPLICABLE where the methods do not lead to what is asked.
        """
        found = work_out(Book(task, style=replace(natural(task), shortcuts=False))) if answers is None else answers
        # A datum in an unusual unit is converted first: the printed number is what that starts from.
        printed = {name: in_order([v])[0] if v.expression else v for name, v in task.given.items()}
        given = {id(leaf): name for name, leaf in printed.items()}
        return RepeatableCalculation([found[quantity.name] for quantity in task.asked], given)

    def repeat(self, data: Numbers) -> Array:
        """The answers for other data (printed numbers by parameter, shape (N,)), shape (answers, N)."""
        numbers = self._exact(data)
        return _rows([numbers[place] for place in self.answers], _size(data))

    def errors(self, data: Numbers, exact: Mapping[int, Array] | None = None) -> Array:
        """The errors of the answers by rounding, in their units, shape (answers, N).

        ``exact`` are the numbers of answers and of what is rounded, by place, where they are known already.
        """
        size, numbers = _size(data), self._exact(data) if exact is None else exact
        right = _rows([numbers[place] for place in self.answers], size)
        rounded = _rows([numbers[place] for place in self.rounded], size)
        off = _half_units(self._angles, rounded)
        parts = [slice(start, start + _TOGETHER) for start in range(0, size, _TOGETHER)]
        return np.concatenate([self._errors(cut(data, part), right[:, part], off[:, part]) for part in parts], axis=1)

    def _errors(self, data: Numbers, right: Array, off: Array) -> Array:
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

    def _exact(self, data: Numbers) -> list[Array]:
        """All numbers by place."""
        numbers = self.operations.begin(data)
        self.operations.run(numbers, self.operations.listed)
        return numbers


def printed_data(form: Form, variants: Sequence[Variant]) -> Numbers:
    """The printed numbers by parameter, shape (N,), magnitudes of rates as a solution has them."""
    found = {}
    for name, parameter in form.parameters.items():
        if parameter.unit is not None:
            column = np.array([float(variant.printed[name]) for variant in variants])
            found[name] = np.abs(column) if parameter.is_rate else column
    return found


def _rows(rows: Sequence[Array], size: int) -> Array:
    """A table of rows, some of which are one number for all."""
    table = np.empty((len(rows), size))
    for row, numbers in zip(table, rows, strict=True):
        row[:] = numbers
    return table


def cut(data: Numbers, chosen: Any) -> Numbers:
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


def _half_units(angles: Sequence[int], numbers: Array) -> Array:
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
