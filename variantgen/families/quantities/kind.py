"""A kind of quantities: what it needs of the motion, what it measures, how it is computed."""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct

from variantgen.mechanism.motion import Field, Motion

MAX, MIN, MEAN = "max_", "min_", "mean_"  # before a kind: what is asked of a turn of the crank or an interval of time
WITH_EXTREMES = ("v", "a", "omega", "epsilon", "x", "y", "angle", "distance")

Computed = Callable[[Motion, str, str], Field]  # of a motion, a target and what is asked of it, in SI


class Kind(Struct, frozen=True):
    """A kind of quantities: ``group`` tells how it is named and read, ``measure`` is that of its value.

    ``order`` is 0 if positions are enough to know it, 1 if velocities are needed, 2 if accelerations. ``of`` is the
    kind of which an extreme, a mean value or a zero over a turn of the crank or an interval of time is taken.
    """

    group: str
    order: int
    measure: str
    value: Computed
    of: str = ""
