"""A point of a body, by its place relative to two other points of that body."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Flags, unit_towards
from variantgen.mechanism.component import Length, PointName
from variantgen.mechanism.outcome import Outcome


class OnBody(Struct, frozen=True):
    """``z = z_origin + (along + i*across) * u`` with u the unit vector origin -> towards; across counts to its left."""

    origin: PointName
    towards: PointName
    along: Length
    across: Length = 0.0
    failure: ClassVar[Outcome] = Outcome.DEGENERATE

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """Position (m) and whether the reference ray exists."""
        ray, apart = unit_towards(at[self.origin], at[self.towards])
        return at[self.origin] + (self.along + 1j * self.across) * ray, apart
