"""A point on a straight line: a slider in its guide, a rod through a sleeve, a link of given direction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from variantgen.mechanism.arithmetic import Complex, Real, cross, unit_vector
from variantgen.mechanism.component import Angle, PointName


@dataclass(frozen=True)
class PointOnLine:
    """``u x (z_point - z_through) = 0`` with u the direction ``angle`` (rad) or through -> ``towards``."""

    point: PointName
    through: PointName
    angle: Angle = 0.0
    towards: PointName | None = None
    either: ClassVar[tuple[tuple[str, str], ...]] = (("angle", "towards"),)

    def _way(self, at: Mapping[str, Complex]) -> tuple[Complex, Real]:
        if self.towards is None:
            return unit_vector(self.angle), 1.0
        way = np.asarray(at[self.towards] - at[self.through])
        length = np.abs(way)
        return np.where(length > 0, way, 1.0), np.where(length > 0, length, 1.0)

    def value(self, at: Mapping[str, Complex]) -> Real:
        """Distance from the line, positive on its left (m)."""
        way, length = self._way(at)
        return cross(way, at[self.point] - at[self.through]) / length

    def gradient(self, at: Mapping[str, Complex]) -> dict[str, Complex]:
        """The normal of the line for the point; for the ends of the line by the product rule.

        The change of 1/length is left out: it stands before the value, which vanishes at the solution.
        """
        way, length = self._way(at)
        normal = 1j * way / length
        found = {self.point: normal, self.through: -normal}
        if self.towards is not None:
            turning = -1j * (at[self.point] - at[self.through]) / length
            found[self.through] = found[self.through] - turning
            found[self.towards] = found.get(self.towards, 0.0) + turning
        return found
