"""The crossing of two straight lines."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import EPS, Complex, Flags, cross, line_direction
from variantgen.mechanism.component import Angle, PointName
from variantgen.mechanism.outcome import Outcome


class LineLine(Struct, frozen=True):
    """The crossing of the line through ``first`` and the line through ``second``.

    Each line has the direction of its angle (rad) or passes through a second point (``first_towards``,
    ``second_towards``). With unit vectors u, w and the step s between the points: ``z = z_first + (s x w)/(u x w) u``.
    """

    first: PointName
    second: PointName
    first_angle: Angle = 0.0
    second_angle: Angle = 0.0
    first_towards: PointName | None = None
    second_towards: PointName | None = None
    either: ClassVar[tuple[tuple[str, str], ...]] = (
        ("first_angle", "first_towards"),
        ("second_angle", "second_towards"),
    )
    failure: ClassVar[Outcome] = Outcome.DEGENERATE

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """Position (m) and whether the lines cross."""
        u, u_exists = line_direction(at, self.first, self.first_angle, self.first_towards)
        w, w_exists = line_direction(at, self.second, self.second_angle, self.second_towards)
        sine = cross(u, w)
        crosses = u_exists & w_exists & (np.abs(sine) > 16 * EPS)
        along_line = cross(at[self.second] - at[self.first], w) / np.where(crosses, sine, 1.0)
        return at[self.first] + along_line * u, crosses
