"""Whether a link can revolve: a crank goes full circle, a rocker does not (for four bars: Grashof's condition)."""

from __future__ import annotations

import numpy as np
from msgspec.structs import replace

from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.rows import Constraint
from variantgen.mechanism.turn.continuation import Continuation


def can_revolve(motion: Motion, body: str) -> bool:
    """Whether a body can be turned full circle while the lengths and guides of its mechanism stay what they are.

    The body is the driver; where the mechanism has several, the others are held. Links are as long as they need be:
    the ends of rods and slots stop nothing. Raises ValueError for more than one variant, and for a body that cannot
    drive (its rotation does not determine the motion).
    """
    if motion.size != 1 or not motion.solved[0]:
        raise ValueError("one solved variant is turned")
    for number in _order(motion.scene.drivers, body):
        drivers = list(motion.scene.drivers)
        drivers[number] = Rotation(body, 1.0)
        rates = [np.ones(1) if k == number else np.zeros(len(d.rates(1))) for k, d in enumerate(drivers)]
        driven = replace(motion, scene=replace(motion.scene, drivers=tuple(drivers)))
        try:
            continuation = Continuation(driven, np.concatenate(rates))
        except np.linalg.LinAlgError:
            continue
        return all(continuation.run(end)[1] is None for end in (np.pi, -np.pi))
    raise ValueError(f"{body} cannot drive")


def _order(drivers: tuple[Constraint, ...], body: str) -> list[int]:
    """The drivers that the rotation of a body may replace: the one that gives it, or else each."""
    own = [k for k, driver in enumerate(drivers) if isinstance(driver, Rotation) and driver.body == body]
    return own or list(range(len(drivers)))
