"""Whether doubles can tell a motion at all: near dead and change points the last bits of the data decide what it is.

A variant near such a point is solved again with every number of the scene changed by a few roundings. What changes by
more than a few per cent then has no digits that could be trusted: its outcome is that of a dead point. This measures
the loss where it occurs, so that no bound on the angle is needed: near a dead point ``eps / sin^2``, near a change
point, where velocities stay finite, ``eps / sin^3`` of the accelerations.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import EPS
from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.scene import Scene, with_numbers

# Scaled determinant below which a variant is looked at: above it no digit that matters is lost.
_NEAR = 1e-3
_ROUNDINGS = 8.0
_KEPT = 0.04  # relative change by so many roundings beyond which fewer than two digits are right
_PATTERNS = ((1.0, -1.0), (1.0, 1.0, -1.0, -1.0))  # signs of the changes of successive numbers


def near_singular(motion: Motion) -> NDArray[np.int64]:
    """Indices of the solved variants that are near a dead or a change point."""
    return np.flatnonzero(motion.solved & (motion.transmission < _NEAR))


def decided_by_rounding(motion: Motion, again: Callable[[Scene], Motion]) -> NDArray[np.bool_]:
    """Which variants have another motion when all their numbers change by a few roundings, shape (N,).

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

    def change(number: int, value: Any, field: str) -> Any:
        nonlocal place
        place += 1
        # One is a side, a sense, or a unit: nothing that is rounded.
        rounded = np.abs(value) != 1.0
        return value * np.where(rounded, 1.0 + _ROUNDINGS * EPS * signs[place % len(signs)], 1.0)

    return with_numbers(scene, change)


def _gap(motion: Motion, moved: Motion) -> Field:
    """Largest change of velocities and accelerations, each relative to the largest of the mechanism."""
    length = motion.length_scale()
    pairs: list[tuple[Mapping[str, Any], Mapping[str, Any], Any]] = [
        (motion.v, moved.v, 1.0),
        (motion.omega, moved.omega, length),
    ]
    found = _relative(pairs)
    if motion.a:
        found = np.maximum(found, _relative([(motion.a, moved.a, 1.0), (motion.epsilon, moved.epsilon, length)]))
    return found


def _relative(tables: list[tuple[Mapping[str, Any], Mapping[str, Any], Any]]) -> Field:
    changes = [np.abs(other[name] - x) * scale for table, other, scale in tables for name, x in table.items()]
    sizes = [np.abs(x) * scale for table, _, scale in tables for x in table.values()]
    largest = np.max(sizes, axis=0)
    found: Field = np.max(changes, axis=0) / np.where(largest > 0, largest, 1.0)
    return found
