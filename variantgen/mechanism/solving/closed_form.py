"""Numbers of the form (p/q) sqrt(n) with small whole p, q, n, recognised among computed ones.

The square of such a number is a fraction P/Q, which is sought among the convergents of its continued fraction. It is
one of them, and no other fits: fractions with P Q <= H differ from each other by at least 1/H of themselves, and H is
4e9, while what fits within the relative tolerance 2 T of a square differs by 4 T = 4e-12 at most. Of the fractions
found only those count whose root is ``p/q sqrt(n)`` within the bounds below. There are at most 2.1e5 such roots in any
decade, so a number that has nothing to do with roots (evenly spread over the decade by its logarithm) is taken for one
with a probability of ``2.1e5 * 2 T / ln 10 = 1.8e-7`` (the tests count them).
"""

from __future__ import annotations

from math import gcd, isfinite, isqrt

import numpy as np
from numpy.typing import NDArray

TOLERANCE = 1e-12  # T, relative
MOST_NUMERATOR, MOST_DENOMINATOR, MOST_RADICAND = 5_000, 60, 500  # p, q, n
MOST_PRODUCT = 60_000  # p q n: a large whole number goes with small ones only

# What a reader takes for simple: sqrt(2) to sqrt(7) over at most 4, a third of a whole number.
_SIMPLE_RADICANDS, _SIMPLE_DENOMINATOR = (2, 3, 5, 6, 7), 4
_SIMPLE_NUMERATOR = 100  # below this, zeros at the end of the factor of a root apart: 45 sqrt(2), 120 sqrt(3)

# P Q = (p q)^2 n = (p q n)^2 / n
_MOST_HEIGHT = MOST_PRODUCT**2
# The squares of roots within the bounds lie between these, with room.
_LOWEST, _HIGHEST = 0.5 / MOST_DENOMINATOR**2, 2.0 * _MOST_HEIGHT
_SQUARE_FREE = [n for n in range(1, MOST_RADICAND + 1) if all(n % k**2 for k in range(2, isqrt(n) + 1))]


def closed_form(value: float) -> tuple[int, int, int] | None:
    """The whole numbers (p, q, n) of ``value = p/q sqrt(n)``, or None.

    q is above 0 and has no divisor in common with p, n is square-free; p has the sign of the value.
    """
    square = value * value
    if not isfinite(square) or not _LOWEST < square < _HIGHEST:
        return None
    rest = square
    before, numerator, under_before, denominator = 0, 1, 1, 0
    while True:
        whole = int(rest)
        before, numerator = numerator, whole * numerator + before
        under_before, denominator = denominator, whole * denominator + under_before
        if numerator * denominator > _MOST_HEIGHT:
            return None
        if abs(numerator - square * denominator) <= 2 * TOLERANCE * numerator:
            break
        if rest == whole:
            return None
        rest = 1.0 / (rest - whole)
    found = root_of_fraction(numerator, denominator)
    return (-found[0], *found[1:]) if found and value < 0 else found


def square_fractions(values: NDArray[np.float64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The fractions P/Q of the squares of many values at once, zeros where there is none; shapes (N,).

    What remains to be asked of a fraction is :func:`root_of_fraction`.
    """
    squares = np.asarray(values, dtype=float) ** 2
    top, under = np.zeros(squares.size, dtype=np.int64), np.zeros(squares.size, dtype=np.int64)
    place = np.flatnonzero((squares > _LOWEST) & (squares < _HIGHEST))
    square = rest = squares[place]
    # The last two convergents: numerators in the first row, denominators in the second.
    before, last = (np.repeat([[a], [b]], place.size, axis=1) for a, b in ((0.0, 1.0), (1.0, 0.0)))
    while place.size:
        whole = np.floor(rest)
        before, last = last, whole * last + before
        small = last[0] * last[1] <= _MOST_HEIGHT
        fits = small & (np.abs(last[0] - square * last[1]) <= 2 * TOLERANCE * last[0])
        top[place[fits]], under[place[fits]] = last[:, fits].astype(np.int64)
        on = small & ~fits & (rest > whole)
        place, square, rest, before, last = place[on], square[on], rest[on] - whole[on], before[:, on], last[:, on]
        rest = 1.0 / rest
    return top, under


def root_of_fraction(numerator: int, denominator: int) -> tuple[int, int, int] | None:
    """(p, q, n) of the square root of a fraction in lowest terms, or None beyond the bounds of this module."""
    product = numerator * denominator
    if not product:
        return None
    for n in _SQUARE_FREE:
        # sqrt(P/Q) = sqrt(P Q)/Q, and P Q = n k^2
        square, remainder = divmod(product, n)
        k = isqrt(square)
        if remainder or k * k != square:
            continue
        common = gcd(k, denominator)
        p, q = k // common, denominator // common
        within = p <= MOST_NUMERATOR and q <= MOST_DENOMINATOR and p * q * n <= MOST_PRODUCT
        return (p, q, n) if within else None
    return None


def is_simple(numerator: int, denominator: int, radicand: int) -> bool:
    """Whether p/q sqrt(n) is a form that a reader would write beside its decimal: 120 sqrt(3), 5 sqrt(2)/4, 4/3.

    Roots of 2, 3, 5, 6, 7 over at most 4, and thirds; numerators below 100, that of a root without zeros at its end.
    Forms like 135 sqrt(3)/8, sqrt(194)/26 and 400/3 help nobody; halves and quarters without a root are decimals.
    This is what `nice` variants are drawn for and what is printed.
    """
    numerator = abs(numerator)
    if radicand == 1:
        return denominator == 3 and numerator < _SIMPLE_NUMERATOR
    while numerator and numerator % 10 == 0:
        numerator //= 10
    return radicand in _SIMPLE_RADICANDS and denominator <= _SIMPLE_DENOMINATOR and 0 < numerator < _SIMPLE_NUMERATOR
