"""The same code in extended double precision (80 bits on x86 processors)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from variantgen.accuracy.algorithms.production import solved
from variantgen.accuracy.computed import CaseGroup, Computed
from variantgen.accuracy.reference.exact_scene import wide_scene
from variantgen.mechanism.solving.structure import analyse

TITLE = "production in extended precision"
SHORT = "production, 80 bits"
DOUBLE = False
BATCH = 2000


def applies(group: CaseGroup) -> str:
    """Not to groups that no dyad opens: their matrices are solved by LAPACK, which has doubles only."""
    if np.finfo(np.longdouble).eps >= np.finfo(np.float64).eps:
        return "the machine has no extended precision"
    if group.scene.conditions or any(len(block.unknowns) > 2 for block in analyse(group.scene).blocks):
        return "LAPACK has no extended precision"
    return ""


def prepare(group: CaseGroup) -> Callable[[], Computed]:
    """The doubles are converted before."""
    plan, scene = analyse(group.scene), wide_scene(group.scene)
    return lambda: solved(scene, plan)
