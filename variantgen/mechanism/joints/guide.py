"""Guide: a point moves along a fixed straight line (the hinge of a slider)."""

from __future__ import annotations

from variantgen.mechanism.arithmetic import Complex, Real, cross
from variantgen.mechanism.component import Angle, PointName
from variantgen.mechanism.joint import Joint
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


class Guide(Joint, frozen=True):
    """The point stays on the line through its place in the direction ``angle`` (rad, scene frame).

    With n the normal of the line: ``n.(z - z_start) = 0``, ``n.v = 0``, ``n.a = 0``.
    """

    point: PointName
    angle: Angle = 0.0

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the point."""
        return (Shape(points=(self.point,)),)

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """``n.v = 0`` with ``n = i u``."""
        return (ScalarRow({self.point: 1j * at.frame.direction(self.angle)}),)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Nothing: the line is straight and fixed."""
        return (0.0,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Distance from the line (m)."""
        shift = moved.z[self.point] - start.z[self.point]
        return (cross(start.frame.direction(self.angle), shift),)
