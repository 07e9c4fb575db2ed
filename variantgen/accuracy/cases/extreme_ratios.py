"""Length ratios beyond 1e6, where the error of the solver over (kappa eps) can be larger still.

Positions are doubles in one frame. A link of 1e-9 of the others, or pivots as near as that to each other, is a small
difference of such positions, whatever is then computed from them; the largest error over (kappa eps) seen among some
2000 four-bars was 122. No family of the catalogue has such proportions.
"""

from __future__ import annotations

from numpy.random import Generator

from variantgen.accuracy.cases.length_ratios import spanned
from variantgen.accuracy.computed import CaseGroup

TITLE = "extreme length ratios"
ABOUT = "Lengths drawn evenly by their logarithm over a range of 1e8 to 1e12 (1e-6 to 1e6 m)."
PLACE = 9


def groups(count: int, rng: Generator) -> list[CaseGroup]:
    """A group per range and mechanism."""
    return spanned(count, rng, (4.0, 5.0, 6.0))
