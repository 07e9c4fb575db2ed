"""A point that divides a segment in a given ratio; a half is the midpoint."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Flags
from variantgen.mechanism.component import PointName, Ratio
from variantgen.mechanism.outcome import Outcome


class SegmentFraction(Struct, frozen=True):
    """``z = z_start + part * (z_end - z_start)``; part 0.5 is the middle."""

    start: PointName
    end: PointName
    part: Ratio = 0.5
    failure: ClassVar[Outcome] = Outcome.DEGENERATE

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """Position (m) and whether it exists (always)."""
        start = at[self.start]
        return start + self.part * (at[self.end] - start), True
