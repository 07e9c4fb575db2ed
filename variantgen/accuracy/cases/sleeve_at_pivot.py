"""The sleeve of a rocker passes through the rocker's pivot, at a distance of 1e-1 to 1e-8 m."""

from __future__ import annotations

import numpy as np
from numpy.random import Generator

from variantgen.accuracy.cases._shapes import rates
from variantgen.accuracy.computed import CaseGroup
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.scene import Scene

TITLE = "sleeve through its pivot"
ABOUT = "A crank's pin slides in a slotted rocker and passes the rocker's pivot at 1e-1 to 1e-8 of the crank's length."
PLACE = 4


def groups(count: int, rng: Generator) -> list[CaseGroup]:
    """A group per distance."""
    gaps = [10.0**-k for k in range(1, 9)]
    each = max(1, count // len(gaps))
    return [CaseGroup(f"{gap:.0e} of the crank", _scene(rng, gap, each), each, notes={"gap": gap}) for gap in gaps]


def _scene(rng: Generator, gap: float, count: int) -> Scene:
    a = rng.uniform(0.2, 1.0, count)
    omega, epsilon = rates(rng, count)
    return Scene(
        {
            "O": Coordinates(0.0, 0.0),
            "C": Coordinates(a * (1 + gap * rng.uniform(0.5, 1.0, count)), 0.0),
            "A": Polar("O", a, gap * rng.uniform(-1.0, 1.0, count)),
            "D": Polar("C", np.full(count, 0.7), np.zeros(count), "A"),
        },
        {"OA": ("O", "A"), "CD": ("C", "D")},
        (Pivot("O"), Pivot("C"), Slot("A", "CD", ("C", "D"))),
        (Rotation("OA", omega, epsilon),),
    )
