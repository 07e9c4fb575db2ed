"""Central differences of second order of the positions."""

from __future__ import annotations

from collections.abc import Callable

from variantgen.accuracy.algorithms._differences import Stencil, differentiated
from variantgen.accuracy.computed import CaseGroup, Computed

TITLE = "central differences of order 2"
SHORT = "central differences, order 2"
DOUBLE = True
BATCH = 100

# The step balances truncation h^2 and rounding eps/h^2 of the second derivative.
_STENCIL = Stencil((-1.0, 1.0), (-0.5, 0.5), (1.0, 1.0), 1.2e-4)


def applies(group: CaseGroup) -> str:
    """Always."""
    return ""


def prepare(group: CaseGroup) -> Callable[[], Computed]:
    """See :func:`~._differences.differentiated`."""
    return differentiated(group, _STENCIL)
