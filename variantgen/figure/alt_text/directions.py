"""Directions on paper in words: keys of the phrases, from vectors.

A direction is exact (within a degree of an axis of the paper), slightly off an axis, or oblique: sixteen keys, named
like the points of the compass with east to the right (``e``, ``ene``, ``ne``, ``nne``, ``n``, ...).
"""

from __future__ import annotations

import cmath
import math

_AXES = ("e", "n", "w", "s")
_OBLIQUE = ("ne", "nw", "sw", "se")
_EXACT = math.radians(1.0)
_NEAR = math.radians(22.5)


def compass(vector: complex) -> str:
    """The key of a direction, one of sixteen; ``vector`` is not zero."""
    turns = cmath.phase(vector) / (math.pi / 2)
    axis = round(turns)
    off = (turns - axis) * (math.pi / 2)
    main = _AXES[axis % 4]
    if abs(off) < _EXACT:
        return main
    oblique = _OBLIQUE[axis % 4 if off > 0 else (axis - 1) % 4]
    return main + oblique if abs(off) < _NEAR else oblique


def side(vector: complex) -> str:
    """The key of a direction in steps of 45 degrees: ``e``, ``ne``, ``n``, ..."""
    step = round(cmath.phase(vector) / (math.pi / 4)) % 8
    return _OBLIQUE[step // 2] if step % 2 else _AXES[step // 2]


def line(vector: complex) -> str:
    """How a line through the paper runs: ``level``, ``upright``, ``rising`` or ``falling`` (to the right)."""
    key = compass(vector)
    if key in _AXES:
        return "level" if key in ("e", "w") else "upright"
    return "rising" if vector.real * vector.imag > 0 else "falling"


def is_parallel(first: complex, second: complex) -> bool:
    """Whether two vectors lie along one line, either way."""
    return abs((first * second.conjugate()).imag) <= 1e-6 * abs(first) * abs(second)
