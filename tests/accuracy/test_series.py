"""Truncated series against derivatives of the whole expression by mpmath."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from variantgen.accuracy.precise import exact_number, many_digits
from variantgen.accuracy.reference.series import Series, series
from variantgen.mechanism.arithmetic import unit_vector

X = (0.7, 1.3, -0.4)
Y = (-1.1, 0.6, 0.9)

EXPRESSIONS = {
    "sum and product": (lambda x, y: (x + y) * (x - 2.5) * y - 3, lambda x, y: (x + y) * (x - mpmath.mpf(2.5)) * y - 3),
    "quotient": (lambda x, y: (1 + x) / (y * y + 2) / x, lambda x, y: (1 + x) / (y * y + 2) / x),
    "reciprocal": (lambda x, y: 2.0 / y, lambda x, y: 2 / y),
    "root": (lambda x, y: np.sqrt(x * x + y**2), lambda x, y: mpmath.sqrt(x * x + y**2)),
    "circle": (lambda x, y: np.cos(x) * np.sin(y), lambda x, y: mpmath.cos(x) * mpmath.sin(y)),
    "exponential": (lambda x, y: np.real(np.exp(1j * x) * y), lambda x, y: mpmath.re(mpmath.expj(x) * y)),
    "unit vector": (lambda x, y: np.imag(unit_vector(x)), lambda x, y: mpmath.sin(x)),
    "angle": (lambda x, y: np.arctan2(y, x), lambda x, y: mpmath.atan2(y, x)),
    "size": (lambda x, y: np.abs(x + 1j * y), lambda x, y: mpmath.sqrt(x * x + y * y)),
    "size of a real number": (lambda x, y: np.abs(y), lambda x, y: -y),
    "conjugate": (lambda x, y: np.real(np.conj(x + 1j * y) * (y + 1j * x)), lambda x, y: 2 * x * y),
}


def at(terms: tuple[float, ...], t: mpmath.mpf) -> mpmath.mpf:
    return sum(mpmath.mpf(c) * t**k for k, c in enumerate(terms))


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_series_have_the_derivatives_of_the_expression(name: str) -> None:
    by_numpy, by_mpmath = EXPRESSIONS[name]
    with many_digits():
        x, y = (Series(tuple(exact_number(c) for c in terms)) for terms in (X, Y))
        found = series(by_numpy(x, y))
        wanted = mpmath.taylor(lambda t: by_mpmath(at(X, t), at(Y, t)), 0, 2)
        for order in range(3):
            assert abs(found.term(order) - wanted[order]) < mpmath.mpf(10) ** -25


def test_series_compare_by_value() -> None:
    with many_digits():
        small, large = series(0.5), Series((exact_number(2.0), exact_number(-9.0)))
        assert small < large
        assert large > 1.0
        assert small <= 0.5 <= small
        assert np.where(large > 0, large, 1.0) / 2.0 > small


def test_numbers_are_taken_for_exact() -> None:
    with many_digits():
        assert exact_number(0.1) != mpmath.mpf("0.1")
        third = np.longdouble(1) / 3
        assert abs(exact_number(third) - mpmath.mpf(1) / 3) < float(np.finfo(np.longdouble).eps)
