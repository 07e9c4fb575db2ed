"""Small linear systems, vectorised over the batch: the blocks of the velocity and acceleration equations."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import Flags, Real, snap_to_zero
from variantgen.mechanism.small_matrices import inverse

# Below this scaled determinant a double has no digits left for the accelerations (they lose its square).
SINGULAR = 1e-9


class ScaledEquation(Struct, frozen=True):
    """One equation: coefficient by unknown, and the size of each before cancellation (for scaling)."""

    coefficients: dict[int, Real]
    sizes: dict[int, Real]


class ScaledDeterminant(Struct, frozen=True):
    """Scaled determinant of a block, 0 to 1 but for rounding, and whether it is far enough from 0 to divide by."""

    value: Real
    regular: Flags


class ScaledInverse(ScaledDeterminant, frozen=True):
    """Of a block of more than two equations: the smallest singular value of its scaled matrix in place of the
    determinant, the inverse of that, shape (n, n, N), and the scales of rows and columns, shape (n, N).
    """

    inverse: NDArray[np.float64]
    rows: NDArray[np.float64]
    columns: NDArray[np.float64]


def solve_block(
    equations: Sequence[ScaledEquation],
    unknowns: Sequence[int],
    sides: Sequence[tuple[Real, Real]],
    known: ScaledDeterminant | None = None,
) -> tuple[dict[int, Real], ScaledDeterminant]:
    """Solve a block of any size; ``sides`` are right-hand sides with the sizes of their terms.

    ``known`` is what an earlier solution with the same coefficients said of them.
    """
    if len(unknowns) == 1:
        return _solve_one(equations[0], unknowns[0], sides[0], known)
    if len(unknowns) == 2:
        return _solve_two(equations, unknowns, sides, known)
    return _solve_many(equations, unknowns, sides, known)


def _scaled_determinant(determinant: Real, scale: Real) -> ScaledDeterminant:
    # Without a scale there is no determinant either, and zero is left.
    value = np.abs(determinant) / np.where(scale > 0, scale, 1.0)
    return ScaledDeterminant(value, value > SINGULAR)


def _solve_one(
    equation: ScaledEquation, unknown: int, side: tuple[Real, Real], known: ScaledDeterminant | None
) -> tuple[dict[int, Real], ScaledDeterminant]:
    a = equation.coefficients[unknown]
    sine = known or _scaled_determinant(a, equation.sizes[unknown])
    # Adding 0.0 turns a negative zero into zero.
    return {unknown: snap_to_zero(*side) / np.where(sine.regular, a, 1.0) + 0.0}, sine


def _solve_two(
    equations: Sequence[ScaledEquation],
    unknowns: Sequence[int],
    sides: Sequence[tuple[Real, Real]],
    known: ScaledDeterminant | None,
) -> tuple[dict[int, Real], ScaledDeterminant]:
    """Cramer's rule; numerators that are nothing but rounding become exact zeros."""
    first, second = equations
    j, k = unknowns
    a, b = first.coefficients.get(j, 0.0), first.coefficients.get(k, 0.0)
    c, d = second.coefficients.get(j, 0.0), second.coefficients.get(k, 0.0)
    determinant = a * d - b * c
    sine = known or _scaled_determinant(determinant, _scale(equations, unknowns))
    determinant = np.where(sine.regular, determinant, 1.0)
    (p, p_size), (q, q_size) = sides
    x = snap_to_zero(p * d - q * b, p_size * np.abs(d) + q_size * np.abs(b)) / determinant
    y = snap_to_zero(q * a - p * c, q_size * np.abs(a) + p_size * np.abs(c)) / determinant
    return {j: x + 0.0, k: y + 0.0}, sine


def _scale(equations: Sequence[ScaledEquation], unknowns: Sequence[int]) -> Real:
    """Product of the column sizes and of the row sizes that remain after the columns are scaled to one."""
    columns = [_largest([e.sizes.get(u, 0.0) for e in equations]) for u in unknowns]
    result: Real = reduce(np.multiply, columns)
    for equation in equations:
        relative = [
            equation.sizes[u] / np.where(column > 0, column, 1.0)
            for u, column in zip(unknowns, columns, strict=True)
            if u in equation.sizes
        ]
        result = result * _largest(relative)
    return result


def _largest(values: Sequence[Real]) -> Real:
    result: Real = values[0]
    for value in values[1:]:
        result = np.maximum(result, value)
    return result


def _solve_many(
    equations: Sequence[ScaledEquation],
    unknowns: Sequence[int],
    sides: Sequence[tuple[Real, Real]],
    known: ScaledDeterminant | None,
) -> tuple[dict[int, Real], ScaledDeterminant]:
    """By the inverse of the scaled matrix, for groups of links that no dyad opens."""
    sine = known if isinstance(known, ScaledInverse) else _inverted(equations, unknowns)
    right = [side / scale for (side, _), scale in zip(sides, sine.rows, strict=True)]
    x = [reduce(np.add, (a * b for a, b in zip(row, right, strict=True))) for row in sine.inverse]
    return {u: value / scale for u, value, scale in zip(unknowns, x, sine.columns, strict=True)}, sine


def _inverted(equations: Sequence[ScaledEquation], unknowns: Sequence[int]) -> ScaledInverse:
    """The inverse of a block's matrix whose columns, then rows, are scaled to one, and its smallest singular value."""
    tables = [[getattr(e, name).get(u, 0.0) for u in unknowns] for e in equations for name in ("coefficients", "sizes")]
    shape = np.broadcast_shapes((1,), *(np.shape(x) for row in tables for x in row))
    both = np.array([[np.broadcast_to(x, shape) for x in row] for row in tables])
    matrix, size = both[0::2], both[1::2]
    columns = np.max(size, axis=0)
    rows = np.max(size / columns, axis=1)
    inverted, found = inverse(matrix / columns / rows[:, None])
    # The largest eigenvalue has all its digits, and costs half of what the singular values of the matrix do.
    square = np.einsum("ikn,jkn->nij", inverted, inverted)
    smallest = np.where(found, 1.0 / np.sqrt(np.linalg.eigvalsh(square)[:, -1]), 0.0)
    regular = smallest > SINGULAR
    return ScaledInverse(smallest, regular, np.where(regular, inverted, 0.0), rows, columns)
