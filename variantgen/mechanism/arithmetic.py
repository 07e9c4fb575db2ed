"""Number types of the core and the few operations in which rounding needs care.

A planar point is one complex number (metres, x right, y up). Every number may be a scalar or an array with one
batch axis of length N (one entry per variant); scalars broadcast.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np

# A scalar or an array of shape (N,). The stubs of numpy cannot say "scalar in, scalar out; array in, array out", so
# the type checker is told nothing here; arrays that must be arrays are typed as such (see motion.Field).
Real: TypeAlias = Any  # float or NDArray[np.float64]
Complex: TypeAlias = Any  # complex or NDArray[np.complex128]
Flags: TypeAlias = Any  # bool or NDArray[np.bool_]

EPS = float(np.finfo(np.float64).eps)
# A sum smaller than this many rounding errors of its largest terms cannot be distinguished from zero: positions carry a
# few roundings each, and a closed chain multiplies several of them.
_ZERO_ULPS = 16.0


def rounding(x: Real) -> float:
    """Machine epsilon of the numbers of an array: that of doubles, or less where the scene is given in more digits."""
    kind = np.result_type(x)
    return EPS if kind.kind not in "fc" else float(np.finfo(kind).eps)


def unit_vector(angle: Real) -> Complex:
    """Unit vector ``exp(i*angle)`` (rad), exact at multiples of a right angle.

    The double nearest to pi/2 is not pi/2, so cos(pi/2) evaluates to 6e-17. A component below four roundings cannot be
    distinguished from zero and is set to zero. An angle that is no floating-point number (a truncated series over
    numbers of many digits, say) is taken as it is.
    """
    cos, sin = np.cos(angle), np.sin(angle)
    if hasattr(cos, "dtype"):
        limit = 4 * rounding(cos)
        cos = np.where(np.abs(cos) < limit, 0.0, cos)
        sin = np.where(np.abs(sin) < limit, 0.0, sin)
    return from_parts(cos, sin)


def from_parts(x: Real, y: Real) -> Complex:
    """``x + i y`` of two numbers or arrays of one shape."""
    if isinstance(x, np.ndarray) and x.shape == np.shape(y) and x.dtype == np.result_type(y):
        z = np.empty(x.shape, dtype=np.result_type(x, np.complex64))
        z.real, z.imag = x, y
        return z
    # Of two numbers of a recording (see mechanism.program), which are no arrays and stand for arrays.
    result: Complex = x.joined(y) if hasattr(x, "joined") and hasattr(y, "joined") else x + 1j * y
    return result


def dot(a: Complex, b: Complex) -> Real:
    """Scalar product ``Re(conj(a) b)`` of two vectors."""
    result: Real = np.real(a) * np.real(b) + np.imag(a) * np.imag(b)
    return result


def cross(a: Complex, b: Complex) -> Real:
    """Vector product ``Im(conj(a) b)``: positive when b lies to the left of a."""
    result: Real = np.real(a) * np.imag(b) - np.imag(a) * np.real(b)
    return result


def unit_towards(start: Complex, end: Complex) -> tuple[Complex, Flags]:
    """Unit vector from start to end, and whether it exists (the points are apart)."""
    step = end - start
    length = np.abs(step)
    apart = length > 4 * EPS * (np.abs(start) + np.abs(end))
    return np.where(apart, step, 1.0) / np.where(apart, length, 1.0), apart


def line_direction(at: Mapping[str, Complex], through: str, angle: Real, towards: str | None) -> tuple[Complex, Flags]:
    """Unit vector of the line through a point along an angle (rad) or, if named, towards a point; whether it exists."""
    return (unit_vector(angle), True) if towards is None else unit_towards(at[through], at[towards])


def snap_to_zero(total: Real, magnitude: Real) -> Real:
    """A sum, with exact zero where cancellation has left nothing but rounding.

    ``magnitude`` is the sum of the absolute values of the terms. This makes an instantaneous translation come out
    with an angular velocity of exactly 0.0 and not of 1e-17.
    """
    result: Real = np.where(np.abs(total) <= _ZERO_ULPS * rounding(total) * magnitude, 0.0, total)
    return result
