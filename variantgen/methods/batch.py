"""Expressions of a solution on arrays: the numbers of many variants at once."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from operator import mul
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.methods.expression import (
    Applied,
    Constant,
    Expression,
    LinearSolution,
    Magnitude,
    Pi,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Value,
)

Table = NDArray[np.float64]

_FUNCTIONS: dict[str, Callable[[Table], Table]] = {
    "cos": lambda x: np.cos(np.radians(x)),
    "sin": lambda x: np.sin(np.radians(x)),
    "tan": lambda x: np.tan(np.radians(x)),
    "arctan": lambda x: np.degrees(np.arctan(x)),
    "arcsin": lambda x: np.degrees(np.arcsin(np.minimum(np.maximum(x, -1.0), 1.0))),
    "arccos": lambda x: np.degrees(np.arccos(np.minimum(np.maximum(x, -1.0), 1.0))),
}


def number_of(item: Expression, numbers: dict[int, Table]) -> Table:
    """An expression on arrays (the like of :meth:`Expression.number`)."""
    return numbers[id(item)] if type(item) is Value else _NUMBERS[type(item)](item, numbers)


def _total(item: Total, numbers: dict[int, Table]) -> Table:
    found: Table | None = None
    for sign, term in item.terms:
        number = number_of(term, numbers)
        if found is None:
            found = number if sign > 0 else -number
        else:
            found = found + number if sign > 0 else found - number
    return found if found is not None else np.zeros(())


def _times(item: Times, numbers: dict[int, Table]) -> Table:
    return reduce(mul, [number_of(factor, numbers) for factor in item.factors])


def _linear_solution(item: LinearSolution, numbers: dict[int, Table]) -> Table:
    """One unknown of a linear system; not a number where that is singular."""
    table = [number_of(operand, numbers) for operand in item.operands()]
    count = len(item.right)
    flat = np.stack(np.broadcast_arrays(*table), axis=-1)
    right, matrix = flat[..., :count, None], flat[..., count:].reshape(*flat.shape[:-1], count, count)
    try:
        return np.asarray(np.linalg.solve(matrix, right)[..., item.index, 0])
    except np.linalg.LinAlgError:
        regular = np.linalg.det(matrix) != 0
        safe = np.where(regular[..., None, None], matrix, np.eye(count))
        return np.where(regular, np.linalg.solve(safe, right)[..., item.index, 0], np.nan)


# By kind of expression; a value stands for its number.
_NUMBERS: dict[type, Callable[[Any, dict[int, Table]], Table]] = {
    Constant: lambda item, numbers: np.asarray(item.value),
    Pi: lambda item, numbers: np.asarray(np.pi),
    Total: _total,
    Times: _times,
    Ratio: lambda item, numbers: number_of(item.above, numbers) / number_of(item.below, numbers),
    Raised: lambda item, numbers: number_of(item.base, numbers) ** item.exponent,
    SquareRoot: lambda item, numbers: np.sqrt(np.maximum(number_of(item.inner, numbers), 0.0)),
    Magnitude: lambda item, numbers: np.abs(number_of(item.inner, numbers)),
    Applied: lambda item, numbers: _FUNCTIONS[item.function](number_of(item.argument, numbers)),
    LinearSolution: _linear_solution,
}
