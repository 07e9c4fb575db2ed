"""The solver of this program: positions by constructions, velocities and accelerations block by block."""

from __future__ import annotations

from collections.abc import Callable

from variantgen.accuracy.computed import CaseGroup, Computed
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.solving.structure import Plan, analyse

TITLE = "production: constructions and blocks"
SHORT = "production"
DOUBLE = True
BATCH = 10_000


def applies(group: CaseGroup) -> str:
    """Always."""
    return ""


def prepare(group: CaseGroup) -> Callable[[], Computed]:
    """The structure is analysed once for all batches, as it is for a family."""
    plan = analyse(group.scene)
    return lambda: solved(group.scene, plan)


def solved(scene: Scene, plan: Plan) -> Computed:
    """What the solver finds."""
    motion: Motion = solve(scene, 2, plan)
    return Computed(motion.z, motion.v, motion.a, motion.omega, motion.epsilon, refused=~motion.solved)
