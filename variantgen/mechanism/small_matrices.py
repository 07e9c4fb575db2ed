"""Systems of a few equations for many variants at once, as arithmetic on whole arrays; the batch is the last axis.

LAPACK takes such systems one by one, which costs several times as much as their arithmetic. Every number is worked out
from those of its own variant in a fixed order, so that it does not depend on which others are in the batch.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import EPS

Array = NDArray[np.float64]

# A row is exchanged where its pivot is smaller than this share of the largest in its column, and there is no pivot left
# where the largest is smaller than a few roundings of all numbers.
_SMALL, _ROUNDINGS = 0.25, 4 * EPS


def solved(matrix: Array, right: Array) -> tuple[Array, NDArray[np.bool_]]:
    """The solution of ``matrix @ x = right`` and whether there is one; shapes (n, n, N), (n, m, N), (N,).

    Gauss and Jordan's elimination; rows are exchanged only for the variants that need it. Where the matrix is
    singular, the numbers are finite and without meaning.
    """
    count = len(matrix)
    table = np.concatenate([matrix, right], axis=1)
    least = _ROUNDINGS * np.abs(matrix).max(axis=(0, 1))
    regular = np.ones(matrix.shape[2], dtype=bool)
    for k in range(count):
        column = np.abs(table[k:, k])
        largest = column.max(axis=0)
        few = (column[0] < _SMALL * largest).nonzero()[0]
        if few.size:
            other = k + column[:, few].argmax(axis=0)
            row = table[k][:, few].T
            table[k][:, few], table[other, :, few] = table[other, :, few].T, row
        regular &= largest > least
        table[k, k + 1 :] /= np.where(regular, table[k, k], 1.0)
        shares = table[:, k].copy()
        shares[k] = 0.0
        table[:, k + 1 :] -= shares[:, None] * table[k, k + 1 :]
    return table[:, count:], regular


def inverse(matrix: Array) -> tuple[Array, NDArray[np.bool_]]:
    """The inverse and whether there is one; shapes (n, n, N) and (N,). See :func:`solved`."""
    return solved(matrix, np.repeat(np.eye(len(matrix))[..., None], matrix.shape[2], axis=-1))
