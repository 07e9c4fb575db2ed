"""Prescribed motion of a point along a circular arc of a moving body: relative motion given."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Real, cross, dot, unit_vector
from variantgen.mechanism.component import Acceleration, BodyName, PointName, Velocity
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


class Circling(Struct, frozen=True):
    """The arc s that ``point`` covers about ``centre`` (C, a point of ``body``) changes at given rates.

    Goes with an arc slot, which keeps the radius R = |d|, d = z - z_C. With e = d/R, n = i e, s counter-clockwise (a
    mirrored scene turns the other way)::

        n.(v - v_C) - omega R = v
        n.(a - a_C) - epsilon R = a          (on the arc, where e.(v - v_C) = 0)
    """

    point: PointName
    body: BodyName
    centre: PointName
    v: Velocity
    a: Acceleration = 0.0
    belongs: ClassVar[Mapping[str, str]] = {"centre": "body"}

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the point, the centre and the body."""
        return (Shape((self.point, self.centre), (self.body,)),)

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """``sense * (n.(v - v_C) - omega R) = v``."""
        step = at.z[self.point] - at.z[self.centre]
        radius = np.abs(step)
        n = at.frame.sense * 1j * step / np.where(radius > 0, radius, 1.0)
        return (ScalarRow({self.point: n, self.centre: -n}, {self.body: -at.frame.sense * radius}),)

    def rates(self, order: int) -> tuple[Real, ...]:
        """V (m/s) or a (m/s^2)."""
        return (self.v if order == 1 else self.a,)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Nothing: the radius, which turns at the rate ``n.(v - v_C)/R``, keeps its length."""
        return (0.0,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Arc covered on the body less ``v t + a t^2 / 2`` (m)."""
        before = start.z[self.point] - start.z[self.centre]
        after = (moved.z[self.point] - moved.z[self.centre]) * np.conj(unit_vector(moved.turned[self.body]))
        angle = np.arctan2(cross(before, after), dot(before, after))
        arc = start.frame.sense * np.abs(before) * angle
        return (arc - (self.v + 0.5 * self.a * time) * time,)
