"""Two motions of one solver, for data that differ in a known way: what the second must be by the first.

Each function gives the largest difference for each variant, shape (N,), relative to the largest position, velocity or
acceleration; infinite where only one of the two is solved.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from msgspec.structs import replace

from variantgen.mechanism.motion import Field, Motion, largest_change


def scaling(one: Motion, other: Motion, length: float = 1.0, time: float = 1.0) -> Field:
    """How far ``other`` is from ``one`` with all lengths and times multiplied, shape (N,).

    Positions change by ``length``, velocities by ``length / time``, accelerations by ``length / time^2``, rotations by
    ``1 / time`` and ``1 / time^2``.
    """
    speed, acceleration = length / time, length / time**2
    return _difference(
        replace(
            one,
            z=_times(one.z, length),
            v=_times(one.v, speed),
            a=_times(one.a, acceleration),
            omega=_times(one.omega, 1 / time),
            epsilon=_times(one.epsilon, 1 / time**2),
        ),
        other,
    )


def time_reversal(one: Motion, other: Motion) -> Field:
    """How far ``other`` is from ``one`` run backwards, shape (N,): velocities change their sign, accelerations stay."""
    return scaling(one, other, time=-1.0)


def mirror(one: Motion, other: Motion, axis: float = 0.0) -> Field:
    """How far ``other`` is from ``one`` seen in a mirror along a line through the origin, shape (N,).

    ``axis`` is the angle of the line from the x axis (rad). All vectors are mirrored, rotations change their sign.
    """

    def seen(table: Mapping[str, Any]) -> dict[str, Any]:
        return {name: np.exp(2j * axis) * np.conj(x) for name, x in table.items()}

    image = replace(one, z=seen(one.z), v=seen(one.v), a=seen(one.a))
    return _difference(replace(image, omega=_times(one.omega, -1.0), epsilon=_times(one.epsilon, -1.0)), other)


def _times(table: Mapping[str, Any], factor: float) -> dict[str, Any]:
    return {name: factor * x for name, x in table.items()}


def _difference(expected: Motion, found: Motion) -> Field:
    """The largest difference of two motions; raises ValueError where they are not of the same points and bodies."""
    for name in ("z", "v", "a", "omega", "epsilon"):
        first, second = getattr(expected, name), getattr(found, name)
        if first.keys() != second.keys():
            raise ValueError(
                f"{name} is known of {', '.join(first)} in one motion, of {', '.join(second)} in the other"
            )
    length = expected.length_scale()
    least = np.where(length > 0, length, 1.0)
    none: dict[str, Field] = {}
    gaps = [
        largest_change(expected.z, found.z, none, none, length, least),
        largest_change(expected.v, found.v, expected.omega, found.omega, length),
        largest_change(expected.a, found.a, expected.epsilon, found.epsilon, length),
    ]
    worst = np.where(expected.solved & found.solved, np.max(gaps, axis=0), 0.0)
    return np.asarray(np.where(expected.solved == found.solved, worst, np.inf))
