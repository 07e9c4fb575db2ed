"""The path of a point at an instant: tangential and normal acceleration, radius of curvature."""

from __future__ import annotations

import numpy as np

from variantgen.mechanism.arithmetic import cross, dot
from variantgen.mechanism.motion import Field, Motion

_AT_REST = 1e-12  # of the largest velocity or acceleration: a smaller one is none but for rounding
_STRAIGHT = 1e-12  # sine between velocity and acceleration within which they are parallel but for rounding


def tangential_acceleration(motion: Motion, point: str) -> Field:
    """``a_t = a . v / |v|`` (m/s^2), shape (N,): positive where the point speeds up; infinite where it is at rest."""
    return _ratio(np.asarray(dot(motion.v[point], motion.a[point])), _speed(motion, point))


def normal_acceleration(motion: Motion, point: str) -> Field:
    """``a_n = |v x a| / |v|`` (m/s^2), shape (N,): towards the centre of curvature; infinite for a point at rest."""
    return _ratio(_turning(motion, point), _speed(motion, point))


def curvature_radius(motion: Motion, point: str) -> Field:
    """``rho = |v|^3 / |v x a|`` (m), shape (N,); infinite where the path is straight, or the point at rest."""
    speed = _speed(motion, point)
    return _ratio(speed**3, np.where(speed > 0, _turning(motion, point), 0.0))


def _speed(motion: Motion, point: str) -> Field:
    """``|v|``; zero for a point that is at rest but for rounding."""
    speed = np.abs(motion.v[point])
    largest = np.max([np.abs(v) for v in motion.v.values()], axis=0)
    found: Field = np.where(speed > _AT_REST * largest, speed, 0.0)
    return found


def _turning(motion: Motion, point: str) -> Field:
    """``|v x a|``; zero where nothing but rounding is left of it."""
    v, a = motion.v[point], motion.a[point]
    size = np.abs(np.asarray(cross(v, a)))
    largest = np.max([np.abs(other) for other in motion.a.values()], axis=0)
    is_some = np.abs(a) > _AT_REST * largest
    found: Field = np.where(is_some & (size > _STRAIGHT * np.abs(v) * np.abs(a)), size, 0.0)
    return found


def _ratio(above: Field, below: Field) -> Field:
    """A quotient, infinite where it has no value."""
    found: Field = np.where(below != 0, above / np.where(below != 0, below, 1.0), np.inf)
    return found
