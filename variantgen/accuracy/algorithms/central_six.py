"""Central differences of sixth order of the positions: the independent verification of every variant."""

from __future__ import annotations

from collections.abc import Callable

from variantgen.accuracy.algorithms._differences import Stencil, differentiated
from variantgen.accuracy.computed import CaseGroup, Computed

TITLE = "central differences of order 6"
SHORT = "central differences, order 6"
DOUBLE = True
BATCH = 100

_STENCIL = Stencil(
    (-3.0, -2.0, -1.0, 1.0, 2.0, 3.0),
    tuple(x / 60 for x in (-1.0, 9.0, -45.0, 45.0, -9.0, 1.0)),
    tuple(x / 180 for x in (2.0, -27.0, 270.0, 270.0, -27.0, 2.0)),
    0.004,
)


def applies(group: CaseGroup) -> str:
    """Always."""
    return ""


def prepare(group: CaseGroup) -> Callable[[], Computed]:
    """See :func:`~._differences.differentiated`."""
    return differentiated(group, _STENCIL)
