"""Polynomials through values in Chebyshev's points of an interval, many at once: their tops between the points."""

from __future__ import annotations

import numpy as np
from numpy.polynomial import chebyshev

from variantgen.mechanism.motion import Field

DEGREE = 8
NODES: Field = np.asarray(np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE), dtype=np.float64)  # from 1 to -1
TO_COEFFICIENTS: Field = np.asarray(np.linalg.inv(chebyshev.chebvander(NODES, DEGREE)), dtype=np.float64)
FINE: Field = np.linspace(-1.0, 1.0, 41, dtype=np.float64)
AT_FINE: Field = np.asarray(chebyshev.chebvander(FINE, DEGREE), dtype=np.float64)
_SLOPE = chebyshev.chebder(np.eye(DEGREE + 1), axis=1)  # what derivatives make of the coefficients
_BEND = chebyshev.chebder(_SLOPE, axis=1)
SLOPE_AT_NODES: Field = chebyshev.chebvander(NODES, DEGREE - 1) @ _SLOPE.T @ TO_COEFFICIENTS
_NEIGHBOUR = float(FINE[1] - FINE[0])


def risen(coefficients: Field, place: Field) -> Field:
    """The roots of derivatives of polynomials near ``place``, by Newton's method in steps of the table, shape (M,)."""
    slope, bend = coefficients @ _SLOPE, coefficients @ _BEND
    low, high = (np.clip(place + step, -1.0, 1.0) for step in (-_NEIGHBOUR, _NEIGHBOUR))
    found = place
    for _ in range(5):
        powers = chebyshev.chebvander(found, DEGREE - 1)
        down, curve = np.sum(powers * slope, axis=1), np.sum(powers[:, :-1] * bend, axis=1)
        step = np.where(curve < 0, down / np.where(curve < 0, curve, 1.0), 0.0)
        found = np.clip(found - step, low, high)
    return np.asarray(found)


def value_at(coefficients: Field, place: Field) -> Field:
    """The values of polynomials, shape (M, coefficients), one at each place, shape (M,)."""
    found: Field = np.sum(chebyshev.chebvander(place, DEGREE) * coefficients, axis=1)
    return found
