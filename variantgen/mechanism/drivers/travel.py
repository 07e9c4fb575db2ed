"""Prescribed motion of a point along a fixed direction."""

from __future__ import annotations

from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Real, dot
from variantgen.mechanism.component import Acceleration, Angle, PointName, Velocity
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


class Travel(Struct, frozen=True):
    """``u.v_point = v``, ``u.a_point = a`` with u the fixed direction ``angle`` (rad, scene frame)."""

    point: PointName
    v: Velocity
    a: Acceleration = 0.0
    angle: Angle = 0.0

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the point."""
        return (Shape(points=(self.point,)),)

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """``u.v_point = v``."""
        return (ScalarRow({self.point: at.frame.direction(self.angle)}),)

    def rates(self, order: int) -> tuple[Real, ...]:
        """V (m/s) or a (m/s^2)."""
        return (self.v if order == 1 else self.a,)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Nothing."""
        return (0.0,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Way along u less ``v t + a t^2 / 2`` (m)."""
        way = dot(start.frame.direction(self.angle), moved.z[self.point] - start.z[self.point])
        return (way - (self.v + 0.5 * self.a * time) * time,)
