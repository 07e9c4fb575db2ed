"""Hand-friendly answers: short decimals and simple roots, such as come out of a calculation by hand."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.solving.closed_form import TOLERANCE, is_simple, root_of_fraction, square_fractions

_DIGITS = 3


def are_hand_friendly(values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Whether values are hand-friendly, shape (N,): zero, decimals of at most three digits, or simple roots.

    Simple are the roots and thirds that are printed beside their decimals (``40 sqrt(3) / 3``, ``4 / 3``); see
    :func:`variantgen.mechanism.solving.closed_form.is_simple`.
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
    an acceleration is mostly the magnitude of a sum of vectors, which no choice of data makes simple. Values of an
    interval of time do not count, since no calculation by hand leads to them.
    """
    asked = [quantity for quantity in asked if not quantity.is_of_interval]
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
    return found is not None and is_simple(*found)
