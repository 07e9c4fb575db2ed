"""Small systems on whole arrays, held against LAPACK and many digits."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from variantgen.mechanism.small_matrices import inverse, solved
from variantgen.mechanism.solving.linear import ScaledEquation, solve_block


@pytest.mark.parametrize("count", [1, 3, 4, 6])
def test_systems_of_any_condition_against_lapack(count: int) -> None:
    """The error grows as the condition number does, up to matrices that are singular to all digits."""
    random = np.random.default_rng(count)
    turns = [np.linalg.qr(random.normal(size=(500, count, count)))[0] for _ in range(2)]
    sizes = np.sort(10.0 ** -random.uniform(0, 12, size=(500, count)), axis=1)[:, ::-1]
    matrix = np.einsum("nij,nj,njk->nik", turns[0], sizes, turns[1])
    right = random.normal(size=(500, count, 2))
    x, regular = solved(np.moveaxis(matrix, 0, -1), np.moveaxis(right, 0, -1))
    assert regular.all()
    known = np.linalg.solve(matrix, right)
    error = np.max(np.abs(np.moveaxis(x, -1, 0) - known), axis=(1, 2)) / np.max(np.abs(known), axis=(1, 2))
    assert np.all(error < 200 * np.finfo(float).eps * sizes[:, 0] / sizes[:, -1])


def test_zeros_on_the_diagonal_and_a_needle() -> None:
    """Rows are exchanged where they must be; of nearly equal rows what is left after cancellation counts."""
    tiny = 2.0**-40
    tables = [
        [[0.0, 0.0, 2.0], [0.0, -4.0, 1.0], [1.0, 0.0, 0.0]],
        [[1.0, 1.0, 1.0], [1.0, 1.0 + tiny, 1.0], [1.0, 1.0, 1.0 - 4 * tiny]],
        [[1e-9, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1e9]],
    ]
    found, regular = inverse(np.moveaxis(np.array(tables), 0, -1))
    assert regular.all()
    with mpmath.workdps(50):
        for i, table in enumerate(tables):
            known = np.array((mpmath.matrix(table) ** -1).tolist(), dtype=float)
            assert np.max(np.abs(found[..., i] - known)) < 1e-14 * np.max(np.abs(known))


def test_singular_matrices_are_told_and_leave_numbers_finite() -> None:
    tables = np.array([np.ones((3, 3)), np.zeros((3, 3)), np.eye(3), np.diag([1.0, 1e-17, 1.0])])
    found, regular = inverse(np.moveaxis(tables, 0, -1))
    assert regular.tolist() == [False, False, True, False]
    assert np.isfinite(found).all()


def test_a_matrix_has_the_same_inverse_alone_and_in_a_batch() -> None:
    matrix = np.random.default_rng(1).normal(size=(6, 6, 300))
    together, _ = inverse(matrix)
    for i in (0, 7, 299):
        assert np.array_equal(inverse(matrix[..., i : i + 1])[0][..., 0], together[..., i])


def test_a_block_of_four_equations_against_lapack() -> None:
    """Its unknowns, and the smallest singular value of the matrix with columns, then rows, of largest entry one."""
    random = np.random.default_rng(4)
    tables = random.normal(size=(4, 4, 200)) * 10.0 ** random.uniform(-3, 3, size=(4, 1, 200))
    tables[3] = tables[2] + tables[3] * 10.0 ** -random.uniform(0, 8, size=200)
    right = random.normal(size=(4, 200))
    sizes = np.abs(tables)
    equations = [
        ScaledEquation(dict(enumerate(row)), dict(enumerate(size))) for row, size in zip(tables, sizes, strict=True)
    ]
    found, sine = solve_block(equations, range(4), [(side, np.abs(side)) for side in right])
    again, _ = solve_block(equations, range(4), [(2 * side, np.abs(side)) for side in right], sine)
    matrix = np.moveaxis(tables, -1, 0)
    scaled = matrix / np.max(np.abs(matrix), axis=1, keepdims=True)
    scaled = scaled / np.max(np.abs(scaled), axis=2, keepdims=True)
    singular = np.linalg.svd(scaled, compute_uv=False)
    assert np.all(np.abs(np.asarray(sine.value) - np.minimum(singular[:, -1], 1.0)) < 1e-13)
    regular = singular[:, -1] > 1e-9
    assert np.array_equal(sine.regular, regular)
    assert 0.8 < np.mean(regular) < 1.0
    columns = np.max(np.abs(matrix), axis=1)
    known = np.linalg.solve(matrix, right.T[..., None])[..., 0] * columns
    for u in range(4):
        error = np.abs(found[u] * columns[:, u] - known[:, u]) / np.max(np.abs(known), axis=1)
        assert np.all(error[regular] < 1e-14 / singular[regular, -1])
        assert np.array_equal(again[u], 2 * found[u])
