"""Near change points: a parallelogram or an antiparallelogram about to fold, where both branches meet."""

from __future__ import annotations

import numpy as np
from numpy.random import Generator

from variantgen.accuracy.cases._shapes import grouped, rates, sides
from variantgen.accuracy.computed import CaseGroup
from variantgen.accuracy.textbook.four_bar import FourBar

TITLE = "near change points"
ABOUT = "Parallelograms and antiparallelograms (a = c, b = d) and kites (a = d, b = c), 1e-1 to 1e-8 rad from folding."
PLACE = 2


def groups(count: int, rng: Generator) -> list[CaseGroup]:
    """A group per angle."""
    angles = [10.0**-k for k in range(1, 9)]
    each = max(1, count // len(angles))
    found = []
    for angle in angles:
        a, b = rng.uniform(0.2, 0.4, each), rng.uniform(0.5, 1.0, each)
        # Both ways of folding: the crank along the base, or against it; the angle is exact only about zero.
        phi = angle * sides(rng, each)
        textbook = FourBar(a, b, a, b, phi, *rates(rng, each), sides(rng, each))
        found.append(grouped(f"parallelogram, {angle:.0e} rad", textbook, each, angle=angle))
        stretched = FourBar(a, b, a, b, np.pi + phi, *rates(rng, each), sides(rng, each))
        found.append(grouped(f"parallelogram against the base, {angle:.0e} rad", stretched, each, angle=angle))
        kite = FourBar(b, a, a, b, phi, *rates(rng, each), sides(rng, each))
        found.append(grouped(f"kite, {angle:.0e} rad", kite, each, angle=angle))
    return found
