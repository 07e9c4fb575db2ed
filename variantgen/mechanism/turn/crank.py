"""The crank of a mechanism: what turns about a fixed point and drives all else."""

from __future__ import annotations

import numpy as np
from msgspec import Struct

from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.linkage import Linkage
from variantgen.mechanism.scene import Scene


class Crank(Struct, frozen=True):
    """The body that a single driver turns about a fixed point."""

    body: str
    pivot: str


def crank_of(scene: Scene) -> Crank | None:
    """The crank of a scene; None where something else drives it."""
    if len(scene.drivers) != 1 or not isinstance(scene.drivers[0], Rotation):
        return None
    driver = scene.drivers[0]
    pivot = Linkage(scene).pivot(driver.body)
    return Crank(driver.body, pivot) if pivot is not None and driver.relative_to is None else None


def is_steady(scene: Scene) -> bool:
    """Whether the crank has no angular acceleration."""
    return all(isinstance(driver, Rotation) and not np.any(driver.epsilon) for driver in scene.drivers)
