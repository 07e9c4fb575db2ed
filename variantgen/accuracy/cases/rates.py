"""Angular velocities of 1e-6 to 1e6 rad/s, with angular accelerations that oppose them."""

from __future__ import annotations

import numpy as np
from msgspec.structs import replace
from numpy.random import Generator

from variantgen.accuracy.cases._shapes import four_bars, grouped, slider_cranks
from variantgen.accuracy.computed import CaseGroup

TITLE = "slow and fast drives"
ABOUT = "Angular velocities of 1e-6 to 1e6 rad/s; epsilon is against omega, of 1e-6 to 1e6 rad/s^2."
PLACE = 7


def groups(count: int, rng: Generator) -> list[CaseGroup]:
    """A group per power of omega and mechanism."""
    powers = (-6, -4, -2, 2, 4, 6)
    each = max(1, count // len(powers))
    found = []
    for power in powers:
        for name, made in (("four-bar", four_bars(rng, each)), ("slider-crank", slider_cranks(rng, each))):
            omega = 10.0**power * np.sign(made.omega) * rng.uniform(0.3, 1.0, each)
            epsilon = -np.sign(omega) * 10 ** rng.uniform(-6, 6, each)
            changed = replace(made, omega=omega, epsilon=epsilon)
            found.append(grouped(f"{name}, 1e{power} rad/s", changed, each, omega=10.0**power))
    return found
