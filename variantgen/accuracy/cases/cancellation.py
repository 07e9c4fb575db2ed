"""Normal and tangential parts that nearly cancel: the given epsilon makes a wanted acceleration vanish."""

from __future__ import annotations

import numpy as np
from msgspec.structs import replace
from numpy.random import Generator

from variantgen.accuracy.cases._shapes import four_bars, grouped, slider_cranks
from variantgen.accuracy.computed import CaseGroup
from variantgen.mechanism.solving.solve import solve

TITLE = "cancelling accelerations"
ABOUT = "Epsilon is such that the slider's acceleration, or the rocker's angular one, vanishes but for 1e-2 to 1e-14."
PLACE = 8


def groups(count: int, rng: Generator) -> list[CaseGroup]:
    """A group per remainder and mechanism."""
    remainders = (1e-2, 1e-5, 1e-8, 1e-11, 1e-14)
    each = max(1, count // len(remainders))
    found = []
    for remainder in remainders:
        bar, crank = four_bars(rng, each), slider_cranks(rng, each)
        # The acceleration is linear in epsilon: two solutions give its root.
        for name, made, result in (("four-bar", bar, "BC"), ("slider-crank", crank, "B")):
            zero, one = (_acceleration(replace(made, epsilon=np.full(each, x)), result) for x in (0.0, 1.0))
            root = -zero / (one - zero)
            changed = replace(made, epsilon=root * (1 + remainder))
            found.append(grouped(f"{name}, {remainder:.0e}", changed, each, remainder=remainder))
    return found


def _acceleration(made: object, result: str) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    motion = solve(made.scene())  # type: ignore[attr-defined]  # either of the two
    return motion.epsilon[result] if result in motion.epsilon else np.real(motion.a[result])
