"""Expressions of a solution on arrays: the numbers of many variants at once.

Expressions are flattened to lists of operations, each on the results of those before it, so that repeating them with
other data costs little more than the arithmetic.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping
from functools import reduce
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Magnitude,
    Pi,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Value,
)
from variantgen.algebra.functions import HIGHEST
from variantgen.algebra.linear import LinearSolution

Array = NDArray[np.float64]
Function = Callable[..., Array]
Places = Mapping[int, int]  # of the numbers of values, by identity

_FUNCTIONS: dict[str, Function] = {
    "cos": lambda x: np.cos(np.radians(x)),
    "sin": lambda x: np.sin(np.radians(x)),
    "tan": lambda x: np.tan(np.radians(x)),
    "arctan": lambda x: np.degrees(np.arctan(x)),
    "arcsin": lambda x: np.degrees(np.arcsin(np.minimum(np.maximum(x, -1.0), 1.0))),
    "arccos": lambda x: np.degrees(np.arccos(np.minimum(np.maximum(x, -1.0), 1.0))),
    "exp": lambda x: np.exp(np.minimum(x, HIGHEST)),
    "ln": np.log,
}


def _root(square: Array) -> Array:
    """The root; of a square that rounding has made negative, zero."""
    return np.asarray(np.sqrt(np.maximum(square, 0.0)))


def _power(exponent: int) -> Function:
    return lambda base: base**exponent


def _linear_solution(count: int, index: int) -> Function:
    """One unknown of a linear system, from right-hand sides and coefficients; not a number where that is singular."""

    def solved(*table: Array) -> Array:
        flat = np.stack(np.broadcast_arrays(*table), axis=-1)
        right, matrix = flat[..., :count, None], flat[..., count:].reshape(*flat.shape[:-1], count, count)
        try:
            return np.asarray(np.linalg.solve(matrix, right)[..., index, 0])
        except np.linalg.LinAlgError:
            regular = np.linalg.det(matrix) != 0
            safe = np.where(regular[..., None, None], matrix, np.eye(count))
            return np.where(regular, np.linalg.solve(safe, right)[..., index, 0], np.nan)

    return solved


def rounded_at(number: Array) -> Array:
    """The number itself, an array of any shape: an operation that marks where a value may be rounded."""
    return number


class Operations:
    """Operations in their order, equal ones only once.

    A number has a place. ``start`` has the constants at theirs, and room for all other numbers; ``given`` are the
    places of given numbers by name, ``listed`` what is done for each other number with those at some places.
    """

    def __init__(self) -> None:
        self.start: list[Any] = []
        self.given: dict[str, int] = {}
        self.listed: dict[int, tuple[Function, tuple[int, ...]]] = {}
        self._places: dict[Hashable, int] = {}

    def begin(self, data: Mapping[str, Array]) -> list[Any]:
        """The numbers that are known without operations, by place; ``data`` by name are scalars or of shape (N,)."""
        numbers = self.start.copy()
        for name, place in self.given.items():
            numbers[place] = data[name]
        return numbers

    def run(self, numbers: list[Any], places: Iterable[int]) -> None:
        """Work out the numbers at places that come after those that they need, where that has not been done."""
        for place in places:
            if numbers[place] is None:
                function, operands = self.listed[place]
                numbers[place] = function(*[numbers[i] for i in operands])

    def constant(self, number: float) -> int:
        """The place of a constant."""
        key = number or repr(number)  # zeros have signs
        return self._places[key] if key in self._places else self._new(key, np.asarray(number))

    def named(self, name: str) -> int:
        """The place of a given number."""
        if name not in self.given:
            self.given[name] = self._new()
        return self.given[name]

    def operation(self, function: Function, *operands: int) -> int:
        """The place of the result of an operation."""
        key = (function, operands)
        place = self._places.get(key)
        if place is None:
            place = self._new(key)
            self.listed[place] = function, operands
        return place

    def rounded_at(self, operand: int) -> int:
        """The place of a number that a value takes, which no other value shares."""
        place = self._new()
        self.listed[place] = rounded_at, (operand,)
        return place

    def of(self, item: Expression, values: Places) -> int:
        """The place of an expression, by those of values by identity."""
        return values[id(item)] if type(item) is Value else _KINDS[type(item)](self, item, values)

    def operands(self, item: Expression, values: Places) -> list[int]:
        """The places of what an expression is put together from."""
        return [self.of(operand, values) for operand in item.operands()]

    def join(self, other: Operations) -> list[int]:
        """Take over the operations of another list; returns their places here. Values are not kept apart."""
        found = [-1] * len(other.start)
        for place, number in enumerate(other.start):
            if number is not None:
                found[place] = self.constant(float(number))
        for name, place in other.given.items():
            found[place] = self.named(name)
        for place, (function, operands) in other.listed.items():
            own = [found[i] for i in operands]
            found[place] = own[0] if function is rounded_at else self.operation(function, *own)
        return found

    def _new(self, key: Hashable = None, number: Array | None = None) -> int:
        place = len(self.start)
        self.start.append(number)
        if key is not None:
            self._places[key] = place
        return place


def _total(to: Operations, item: Total, values: Places) -> int:
    found = -1
    for sign, term in item.terms:
        place = to.of(term, values)
        if found >= 0:
            found = to.operation(np.add if sign > 0 else np.subtract, found, place)
        else:
            found = place if sign > 0 else to.operation(np.negative, place)
    return to.constant(0.0) if found < 0 else found


def _times(to: Operations, item: Times, values: Places) -> int:
    return reduce(lambda first, second: to.operation(np.multiply, first, second), to.operands(item, values))


def _by(function: Function) -> Callable[[Operations, Any, Places], int]:
    """The operation of a kind of expression that is a function of its operands."""
    return lambda to, item, values: to.operation(function, *to.operands(item, values))


# How each kind of expression is put into a list; a value stands for its number.
_KINDS: dict[type, Callable[[Operations, Any, Places], int]] = {
    Constant: lambda to, item, values: to.constant(float(item.value)),
    Pi: lambda to, item, values: to.constant(np.pi),
    Total: _total,
    Times: _times,
    Ratio: _by(np.divide),
    Raised: lambda to, item, values: to.operation(_power(item.exponent), to.of(item.base, values)),
    SquareRoot: _by(_root),
    Magnitude: _by(np.abs),
    Applied: lambda to, item, values: to.operation(_FUNCTIONS[item.function], to.of(item.argument, values)),
    LinearSolution: lambda to, item, values: to.operation(
        _linear_solution(len(item.right), item.index), *to.operands(item, values)
    ),
}
