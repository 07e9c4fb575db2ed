"""Positions by constructions, then one linear system per variant for all velocities, one for all accelerations."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from variantgen.accuracy.computed import CaseGroup, Computed
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.solving.dense import DenseSystem
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.solving.structure import analyse

TITLE = "one dense linear system"
SHORT = "dense linear system"
DOUBLE = True
BATCH = 1000


def applies(group: CaseGroup) -> str:
    """Always."""
    return ""


def prepare(group: CaseGroup) -> Callable[[], Computed]:
    """The structure is only used to place the points."""
    plan = analyse(group.scene)
    return lambda: from_places(solve(group.scene, 0, plan))


def from_places(motion: Motion, lost: np.ndarray[tuple[int], np.dtype[np.bool_]] | None = None) -> Computed:
    """Velocities and accelerations for places that are known."""
    system = DenseSystem(motion)
    velocities = system.solve(1)
    accelerations = system.solve(2, velocities)
    return Computed(
        motion.z,
        velocities.points,
        accelerations.points,
        velocities.bodies,
        accelerations.bodies,
        refused=~motion.solved,
        lost=lost,
    )
