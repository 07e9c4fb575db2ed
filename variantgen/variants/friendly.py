"""Hand-friendly answers: short decimals and simple roots, such as come out of a calculation by hand."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from variantgen.families.quantities import Quantity
from variantgen.mechanism.closed_form import TOLERANCE, root_of_fraction, square_fractions
from variantgen.mechanism.motion import Motion

_DIGITS = 3
_MOST_RADICAND, _MOST_DENOMINATOR = 100, 13


def are_hand_friendly(values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Whether values are hand-friendly, shape (N,): zero, decimals of at most three digits, or simple roots.

    A simple root is ``d sqrt(n) / k``: d a decimal of at most three digits, n up to 100, k up to 13 (``0.35 sqrt(3)``,
    ``40 sqrt(3) / 3``, ``4 / 3``); see :mod:`variantgen.mechanism.closed_form`.
    """
    found = _short(values)
    rest = np.flatnonzero(~found)
    top, under = square_fractions(values[rest])
    for i, numerator, denominator in zip(rest.tolist(), top.tolist(), under.tolist(), strict=True):
        found[i] = _simple(numerator, denominator)
    return found


def friendly_answers(motion: Motion, asked: Sequence[Quantity], length_unit: str) -> NDArray[np.bool_]:
    """Whether the answers of variants are hand-friendly in their printed units, shape (N,).

    Every velocity and angular velocity must be, and half of all that is asked: velocities of nice data are nice, while
    an acceleration is mostly the magnitude of a sum of vectors, which no choice of data makes simple.
    """
    alive = np.arange(motion.size)
    count = np.zeros(motion.size, dtype=np.int64)
    for quantity in sorted(asked, key=lambda quantity: quantity.order):
        good = are_hand_friendly(quantity.value(motion)[alive] * quantity.unit(length_unit).from_si(1.0))
        count[alive] += good
        if quantity.order == 1 and not quantity.is_angle:
            alive = alive[good]
    passed = np.zeros(motion.size, dtype=bool)
    passed[alive] = 2 * count[alive] >= len(asked)
    return passed


def _short(values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Whether values are zero or decimals of a few digits."""
    size = np.abs(values)
    ordinary = (size > 0) & np.isfinite(size)
    size = np.where(ordinary, size, 1.0)
    digits = size * 10.0 ** (_DIGITS - 1 - np.floor(np.log10(size)))
    whole = np.abs(digits - np.round(digits)) <= TOLERANCE * digits
    return np.asarray(np.where(ordinary, whole, values == 0))


@lru_cache(maxsize=50_000)
def _simple(numerator: int, denominator: int) -> bool:
    """Whether the root of a fraction (zeros: there is none) is a simple one."""
    found = root_of_fraction(numerator, denominator)
    if found is None:
        return False
    p, k, n = found
    # p / q = d / k with the factors 2 and 5 of q in the decimal d
    for factor, other in ((2, 5), (5, 2)):
        while k % factor == 0:
            k, p = k // factor, p * other
    while p % 10 == 0:
        p //= 10
    return k <= _MOST_DENOMINATOR and n <= _MOST_RADICAND and p < 10**_DIGITS
