"""Where links cross in some variants of a mechanism though its draft is clear."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from variantgen.synthesis.crowding.clearances import clearances
from variantgen.synthesis.crowding.seen import Seen
from variantgen.synthesis.crowding.segments import cross, off
from variantgen.synthesis.draft import Draft

_STILL_MARKED = 0.2  # of the whole, between the corners of two marked angles
_OFF_RIM = 0.02  # of the whole: what the rim of a wheel keeps from foreign links


def crossed(draft: Draft, z: Mapping[str, NDArray[np.complex128]]) -> NDArray[np.bool_]:
    """On which of N variants of a draft two links cross that nothing joins, or one a guide or a wheel, or something
    slides where there is no room to show it; ``z`` has its points, in cm, shape (N,) each.
    """
    seen = Seen(draft)
    found = np.zeros(next(iter(z.values())).shape, dtype=bool)
    places = np.array([z[name] for name in seen.visible])
    size = np.maximum(np.ptp(places.real, axis=0), np.ptp(places.imag, axis=0))
    for one, other in seen.corners():
        found |= np.abs(z[one] - z[other]) < _STILL_MARKED * size
    for point, bar in seen.near_guides():
        found |= cross(seen.with_guide(z, point, size), ("start", "end"), bar)
    for clearance in clearances(seen):
        found |= clearance.measured(z, size) < clearance.still
    for wheel in draft.wheels:
        for bar in seen.off_wheel(wheel):
            found |= off(z, wheel.centre, bar) < wheel.largest + _OFF_RIM * size
    for first, second in combinations(draft.bars, 2):
        if not seen.joined(first, second):
            found |= cross(z, first, second)
    return found
