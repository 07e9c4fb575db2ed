"""Prescribed change of the distance of two points: a hydraulic cylinder, a telescopic link, a hauled rope."""

from __future__ import annotations

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Real, dot
from variantgen.mechanism.component import Acceleration, PointName, Velocity
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


class Extension(Struct, frozen=True):
    """The distance d of two points grows at the rate v, which grows at the rate a; e is the unit vector start -> end::

    e.(v_end - v_start) = v
    e.(a_end - a_start) + (n.(v_end - v_start))^2 / d = a,   n = i e
    """

    start: PointName
    end: PointName
    v: Velocity
    a: Acceleration = 0.0

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the two points."""
        return (Shape(points=(self.start, self.end)),)

    def _ray(self, at: Placement) -> tuple[Complex, Real]:
        step = at.z[self.end] - at.z[self.start]
        length = np.abs(step)
        safe = np.where(length > 0, length, 1.0)
        return step / safe, safe

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """``e.(v_end - v_start) = v``."""
        ray, _ = self._ray(at)
        return (ScalarRow({self.start: -ray, self.end: ray}),)

    def rates(self, order: int) -> tuple[Real, ...]:
        """V (m/s) or a (m/s^2)."""
        return (self.v if order == 1 else self.a,)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """``(n.(v_end - v_start))^2 / d``."""
        ray, length = self._ray(at)
        swing = dot(1j * ray, speeds.v[self.end] - speeds.v[self.start])
        return (swing * swing / length,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Growth of the distance less ``v t + a t^2 / 2`` (m)."""
        grown = np.abs(moved.z[self.end] - moved.z[self.start]) - np.abs(start.z[self.end] - start.z[self.start])
        return (grown - (self.v + 0.5 * self.a * time) * time,)
