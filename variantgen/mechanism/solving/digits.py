"""Whether doubles can tell a motion at all: near dead and change points the last bits of the data decide what it is.

A variant near such a point is solved again with every number of the scene changed by a few roundings. What changes by
more than a few per cent then has no digits that could be trusted: its outcome is that of a dead point. This measures
the loss where it occurs, so that no bound on the angle is needed: near a dead point ``eps / sin^2``, near a change
point, where velocities stay finite, ``eps / sin^3`` of the accelerations.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import EPS
from variantgen.mechanism.component import FieldSpec
from variantgen.mechanism.motion import Field, Motion, largest_change
from variantgen.mechanism.scene import Scene, with_numbers

# Scaled determinant below which a variant is looked at: above it no digit that matters is lost.
_NEAR = 1e-3
_ROUNDINGS = 8.0
_KEPT = 0.04  # relative change by so many roundings beyond which fewer than two digits are right
_PATTERNS = ((1.0, -1.0), (1.0, 1.0, -1.0, -1.0))  # signs of the changes of successive numbers


def near_singular(motion: Motion) -> NDArray[np.int64]:
    """Indices of the solved variants that are near a dead or a change point, shape (K,)."""
    return np.flatnonzero(motion.solved & (motion.transmission < _NEAR))


def decided_by_rounding(motion: Motion, again: Callable[[Scene], Motion]) -> NDArray[np.bool_]:
    """Whether a variant has another motion when all its numbers change by a few roundings, shape (N,).

    ``again`` solves a changed scene to the orders of the motion.
    """
    lost = np.zeros(motion.size, dtype=bool)
    for signs in _PATTERNS:
        moved = again(_changed(motion.scene, signs))
        # Written so that what is not a number counts as lost.
        lost |= ~(moved.solved & (_gap(motion, moved) <= _KEPT))
    return lost


def _changed(scene: Scene, signs: tuple[float, ...]) -> Scene:
    """The scene with every number, but for sides and senses, changed by roundings of these signs in turn."""
    place = -1

    def change(number: int, value: Any, _: FieldSpec) -> Any:
        nonlocal place
        place += 1
        # One is a side, a sense, or a unit: nothing that is rounded.
        rounded = np.abs(value) != 1.0
        return value * np.where(rounded, 1.0 + _ROUNDINGS * EPS * signs[place % len(signs)], 1.0)

    return with_numbers(scene, change)


def _gap(motion: Motion, moved: Motion) -> Field:
    """Largest change of velocities and accelerations, each relative to the largest of the mechanism."""
    length = motion.length_scale()
    of_velocities = largest_change(motion.v, moved.v, motion.omega, moved.omega, length)
    of_accelerations = largest_change(motion.a, moved.a, motion.epsilon, moved.epsilon, length)
    return np.maximum(of_velocities, of_accelerations)
