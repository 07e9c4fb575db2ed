"""A point at a distance and a direction from another one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Flags, unit_towards, unit_vector
from variantgen.mechanism.component import Angle, Length, PointName
from variantgen.mechanism.outcome import Outcome


class Polar(Struct, frozen=True):
    """``z = z_origin + distance * exp(i*angle)``.

    The angle (rad, counter-clockwise) is counted from the x axis or, where ``towards`` names a point, from the ray
    origin -> towards.
    """

    origin: PointName
    distance: Length
    angle: Angle = 0.0
    towards: PointName | None = None
    failure: ClassVar[Outcome] = Outcome.DEGENERATE

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """Position (m) and whether the reference ray exists."""
        start = at[self.origin]
        if self.towards is None:
            return start + self.distance * unit_vector(self.angle), True
        ray, apart = unit_towards(start, at[self.towards])
        return start + self.distance * ray * unit_vector(self.angle), apart
