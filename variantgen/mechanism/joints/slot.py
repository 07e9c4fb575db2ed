"""Slot or sleeve on a moving body: a point slides along a straight line of the body."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from variantgen.mechanism.arithmetic import Complex, Flags, Real, cross, dot, unit_towards, unit_vector
from variantgen.mechanism.component import BodyName, PointName
from variantgen.mechanism.joint import Joint, Sliding
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


class Slot(Joint, frozen=True):
    """``point`` slides along the line of ``body`` through the two body points ``along``.

    With u the unit vector along the line (it turns with the body), n = i u, A the first point of the line and
    d = z - z_A::

        n.d = const
        n.(v - v_A) - omega (u.d) = 0
        n.(a - a_A) - epsilon (u.d) - 2 omega u.(v - v_A) - omega^2 (n.d) = 0

    The sleeve swivels on its pin unless ``sleeve`` names the body it is fixed to; then that body keeps its
    orientation relative to ``body``, and the two have the same omega and epsilon.
    """

    point: PointName
    body: BodyName
    along: tuple[PointName, PointName]
    sleeve: BodyName | None = None
    belongs: ClassVar[Mapping[str, str]] = {"along": "body"}

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row; a second one where the sleeve does not swivel."""
        line = Shape(points=(self.point, self.along[0]), bodies=(self.body,))
        return (line,) if self.sleeve is None else (line, Shape(bodies=(self.body, self.sleeve)))

    def sound(self, at: Placement) -> Flags:
        """The two points of the line are apart."""
        return unit_towards(at.z[self.along[0]], at.z[self.along[1]])[1]

    def sliding(self) -> Sliding:
        """The point slides on the body along its line."""
        return Sliding(self.point, self.body, self.along)

    def locked(self) -> tuple[str, str] | None:
        """The sleeve and the body of the line, where the sleeve does not swivel."""
        return None if self.sleeve is None else (self.sleeve, self.body)

    def direction(self, at: Placement) -> Complex:
        """Unit vector of the line, from the first towards the second of its points."""
        return unit_towards(at.z[self.along[0]], at.z[self.along[1]])[0]

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """The velocity rows of the class docstring."""
        u = self.direction(at)
        along_line = dot(u, at.z[self.point] - at.z[self.along[0]])
        line = ScalarRow({self.point: 1j * u, self.along[0]: -1j * u}, {self.body: -along_line})
        if self.sleeve is None:
            return (line,)
        return line, ScalarRow({}, {self.body: 1.0, self.sleeve: -1.0})

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """``-2 omega u.(v - v_A) - omega^2 n.d``: the Coriolis term and, for an offset line, a normal one."""
        u = self.direction(at)
        d = at.z[self.point] - at.z[self.along[0]]
        omega = speeds.omega[self.body]
        relative = dot(u, speeds.v[self.point] - speeds.v[self.along[0]])
        term = -omega * (omega * cross(u, d) + 2.0 * relative)
        return (term,) if self.sleeve is None else (term, 0.0)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Distance from the line (m); where the sleeve does not swivel, also the relative rotation (rad)."""
        u = self.direction(start)
        before = cross(u, start.z[self.point] - start.z[self.along[0]])
        turned = u * unit_vector(moved.turned[self.body])
        after = cross(turned, moved.z[self.point] - moved.z[self.along[0]])
        if self.sleeve is None:
            return (after - before,)
        return after - before, moved.turned[self.body] - moved.turned[self.sleeve]
