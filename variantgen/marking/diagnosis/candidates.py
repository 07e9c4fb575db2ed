"""Lists of what a vector or a rate may be, as arrays of complex numbers, shape (K,)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

_MOST = 80  # candidates of one quantity
_ALIKE = 10  # digits by which candidates are told apart
SMALL = 1e-9  # relative: nothing but rounding
_LARGEST = 1e3  # times the right one, more than anybody is granted

Candidates = NDArray[np.complex128]


def without_noise(vectors: Mapping[str, NDArray[np.complex128]]) -> dict[str, complex]:
    """Vectors of points from arrays of shape (1,), those that are nothing but rounding as zero."""
    found = {name: complex(vector[0]) for name, vector in vectors.items()}
    least = SMALL * max(map(abs, found.values()), default=0.0)
    return {name: vector if abs(vector) > least else 0j for name, vector in found.items()}


def each(function: np.ufunc, first: Candidates, second: Candidates) -> Candidates:
    """A function of each candidate of one with each of another, shape (K,)."""
    found: Candidates = np.ravel(function.outer(first, second))
    return found


def projecting(direction: complex, r: complex, other: Candidates) -> Candidates:
    """The vectors of a direction whose projection on r is that of others, shape (K,); none where it is across r."""
    cosine = (direction * np.conj(r)).real
    if abs(cosine) <= SMALL * abs(direction) * abs(r):
        return np.empty(0, dtype=np.complex128)
    found: Candidates = direction * (other * np.conj(r)).real / cosine
    return found


def few(found: Sequence[Candidates]) -> Candidates:
    """The first of all that are different, shape (K,)."""
    every = np.concatenate(found)
    size = abs(every[0]) or float(np.max(np.abs(every), initial=0.0, where=np.isfinite(every))) or 1.0
    every = every[np.isfinite(every) & (np.abs(every) < _LARGEST * size)]  # the first one is right
    _, first = np.unique(np.round(every / size, _ALIKE), return_index=True)
    return every[np.sort(first)[:_MOST]]
