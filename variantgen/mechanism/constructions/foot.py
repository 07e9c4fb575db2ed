"""The foot of the perpendicular from a point to a straight line."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Flags, dot, line_direction
from variantgen.mechanism.component import Angle, PointName
from variantgen.mechanism.outcome import Outcome


class Foot(Struct, frozen=True):
    """``z = z_through + (u . (z_of - z_through)) u`` for the line through a point along ``angle`` or ``towards``."""

    of: PointName
    through: PointName
    angle: Angle = 0.0
    towards: PointName | None = None
    either: ClassVar[tuple[tuple[str, str], ...]] = (("angle", "towards"),)
    failure: ClassVar[Outcome] = Outcome.DEGENERATE

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """Position (m) and whether the line exists."""
        start = at[self.through]
        ray, apart = line_direction(at, self.through, self.angle, self.towards)
        return start + dot(ray, at[self.of] - start) * ray, apart
