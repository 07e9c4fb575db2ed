"""A point on a straight line at a given distance from a point: places a slider."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Flags, cross, dot, line_direction
from variantgen.mechanism.component import Angle, PointName, Sense, Size
from variantgen.mechanism.outcome import Outcome


class LineCircle(Struct, frozen=True):
    """The point of a line at ``distance`` from ``centre``.

    The line passes through ``through`` in the direction ``angle`` (rad) or, where ``towards`` names a point, through
    both points. ``branch`` takes the crossing that lies ahead (+1) or behind (-1) of the foot of the perpendicular::

        z = z_foot + branch * sqrt((r - h)(r + h)) u,   h = distance of the centre from the line
    """

    through: PointName
    centre: PointName
    distance: Size
    angle: Angle = 0.0
    towards: PointName | None = None
    branch: Sense = 1.0
    either: ClassVar[tuple[tuple[str, str], ...]] = (("angle", "towards"),)
    failure: ClassVar[Outcome] = Outcome.NOT_ASSEMBLED
    chooses: ClassVar[str] = "branch"  # which number, 1 or -1, chooses between its two solutions

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """Position (m) and whether the line meets the circle."""
        start = at[self.through]
        ray, apart = line_direction(at, self.through, self.angle, self.towards)
        offset = at[self.centre] - start
        height = np.abs(cross(ray, offset))
        room = (self.distance - height) * (self.distance + height)
        meets = apart & (room >= 0)
        along_line = dot(ray, offset) + self.branch * np.sqrt(np.where(meets, room, 0.0))
        return start + along_line * ray, meets
