"""Prescribed motion of a point along a straight line of a moving body: relative motion given."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Real, cross, dot, unit_towards, unit_vector
from variantgen.mechanism.component import Acceleration, BodyName, PointName, Velocity
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


class RelativeTravel(Struct, frozen=True):
    """The coordinate s of ``point`` along the line of ``body`` through the points ``along`` changes at given rates.

    With u the unit vector of the line (towards its second point), A its first point, n = i u, d = z - z_A, h = n.d::

        u.(v - v_A) + omega h = v
        u.(a - a_A) + epsilon h + 2 omega n.(v - v_A) - omega^2 u.d = a
    """

    point: PointName
    body: BodyName
    along: tuple[PointName, PointName]
    v: Velocity
    a: Acceleration = 0.0
    belongs: ClassVar[Mapping[str, str]] = {"along": "body"}

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the point, the first point of the line and the body."""
        return (Shape((self.point, self.along[0]), (self.body,)),)

    def direction(self, at: Placement) -> Complex:
        """Unit vector of the line, from the first towards the second of its points."""
        return unit_towards(at.z[self.along[0]], at.z[self.along[1]])[0]

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """``u.(v - v_A) + omega h = v``."""
        u = self.direction(at)
        aside = cross(u, at.z[self.point] - at.z[self.along[0]])
        return (ScalarRow({self.point: u, self.along[0]: -u}, {self.body: aside}),)

    def rates(self, order: int) -> tuple[Real, ...]:
        """V (m/s) or a (m/s^2)."""
        return (self.v if order == 1 else self.a,)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """``2 omega n.(v - v_A) - omega^2 u.d``."""
        u, omega = self.direction(at), speeds.omega[self.body]
        shift = speeds.v[self.point] - speeds.v[self.along[0]]
        along_line = dot(u, at.z[self.point] - at.z[self.along[0]])
        return (omega * (2.0 * cross(u, shift) - omega * along_line),)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Way along the line less ``v t + a t^2 / 2`` (m)."""
        u = self.direction(start)
        turned = u * unit_vector(moved.turned[self.body])
        before = dot(u, start.z[self.point] - start.z[self.along[0]])
        after = dot(turned, moved.z[self.point] - moved.z[self.along[0]])
        return (after - before - (self.v + 0.5 * self.a * time) * time,)
