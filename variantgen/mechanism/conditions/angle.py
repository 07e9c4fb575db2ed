"""Two links at a given angle: the instant at which one is perpendicular to another, or parallel to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from variantgen.mechanism.arithmetic import Complex, Real, cross, unit_vector
from variantgen.mechanism.component import Angle, PointName


@dataclass(frozen=True)
class LinkAngle:
    """``(exp(i size) f) x s = 0`` with f the first link, from its first named point to its second, and s the second.

    The angle, from the first to the second, counts counter-clockwise (rad). The equation holds for the opposite
    direction of the second link too; the picture from which the points are placed decides.
    """

    first: tuple[PointName, PointName]
    second: tuple[PointName, PointName]
    size: Angle

    def _links(self, at: Mapping[str, Complex]) -> tuple[Complex, Real, Complex]:
        """Direction of the second link as the first gives it (of any length), that length, and the second link."""
        way = np.asarray(at[self.first[1]] - at[self.first[0]])
        length = np.abs(way)
        safe = np.where(length > 0, way, 1.0)
        return unit_vector(self.size) * safe, np.where(length > 0, length, 1.0), at[self.second[1]] - at[self.second[0]]

    def value(self, at: Mapping[str, Complex]) -> Real:
        """Distance of the second link's end from the direction that the first gives it, positive on its left (m)."""
        way, length, link = self._links(at)
        return cross(way, link) / length

    def gradient(self, at: Mapping[str, Complex]) -> dict[str, Complex]:
        """By the product rule; the change of 1/length stands before the value, which vanishes at the solution."""
        way, length, link = self._links(at)
        normal = 1j * way / length
        turning = -1j * unit_vector(-np.asarray(self.size)) * link / length
        found: dict[str, Complex] = {}
        for name, part in zip((*self.second, *self.first), (-normal, normal, -turning, turning), strict=True):
            found[name] = found.get(name, 0.0) + part
        return found
