"""Rolling without slip on a straight line, fixed or moving (ground, rail, rack, belt, plank)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from variantgen.mechanism.arithmetic import Complex, Flags, Real, dot, unit_vector
from variantgen.mechanism.component import BodyName, PointName
from variantgen.mechanism.joint import BodyContact, GroundWheel, Joint, JointCircle
from variantgen.mechanism.rows import Placement, Row, ScalarRow, Shape, Speeds, VectorRow


class Rolling(Joint, frozen=True):
    """A wheel rolls on the straight line that touches it at ``contact``.

    The line is at rest, or belongs to the body ``on``, of which ``on_point`` (Q) is any point. The two material points
    at the contact K have the same velocity, and the radius to the contact turns with the line. With
    ``w = z_centre - z_contact`` and Omega, E the angular velocity and acceleration of ``on``::

        v_centre = v_Q + i Omega (z_K - z_Q) + i omega w
        a_centre = a_Q + i E (z_K - z_Q) + i epsilon w + i Omega (v_centre - v_Q) + Omega (Omega - omega) w

    For a line at rest ``v_centre = i omega w``, ``a_centre = i epsilon w``. Where other joints keep the centre at its
    distance from the line (the axle of a pinion, a second rack), ``axle_held`` leaves the components along the line.
    """

    body: BodyName
    centre: PointName
    contact: PointName
    on: BodyName | None = None
    on_point: PointName | None = None
    axle_held: bool = False
    belongs: ClassVar[Mapping[str, str]] = {"centre": "body", "on_point": "on"}

    def shapes(self) -> tuple[Shape, ...]:
        """One vector row, the centre by the point of the line's body and the angular velocities; or a scalar row."""
        points: tuple[str, ...] = (self.centre,)
        bodies: tuple[str, ...] = (self.body,)
        if self.on is not None and self.on_point is not None:
            points, bodies = (self.centre, self.on_point), (self.body, self.on)
        return (Shape(points, bodies) if self.axle_held else Shape(points, bodies, self.centre, self.on_point),)

    def on_ground(self) -> GroundWheel | None:
        """The wheel, where the line is at rest."""
        return GroundWheel(self.body, self.centre, contact=self.contact) if self.on is None else None

    def when_surplus(self) -> str:
        """A second line or a guide holds the axle: the wheel then needs one condition, along the line."""
        if self.axle_held:
            return ""
        return (
            f"rolling by itself keeps {self.centre} at its distance from the line; where another belt, rack or guide"
            f" does that, write axle_held = true in one of the joints rolling of {self.body}"
        )

    def sound(self, at: Placement) -> Flags:
        """The wheel has a radius."""
        return np.abs(at.z[self.centre] - at.z[self.contact]) > 0

    def mistake(self) -> str:
        """A moving line needs its body and a point of it."""
        if (self.on is None) != (self.on_point is None):
            return "on (the body that carries the line) and on_point (one of its points) go together"
        return ""

    def _turning(self, at: Placement) -> dict[str, Complex]:
        """Coefficients of the angular velocities in the velocity of the centre."""
        found = {self.body: 1j * (at.z[self.centre] - at.z[self.contact])}
        if self.on is not None and self.on_point is not None:
            found[self.on] = 1j * (at.z[self.contact] - at.z[self.on_point])
        return found

    def _line(self, at: Placement) -> Complex:
        """Unit vector along the line."""
        w = at.z[self.centre] - at.z[self.contact]
        radius = np.abs(w)
        # A wheel without a radius is not sound. Both are taken as arrays: the reference of many digits brings series.
        return np.where(radius > 0, 1j * w, 0.0) / np.where(radius > 0, radius, 1.0)

    def rows(self, at: Placement) -> tuple[Row, ...]:
        """The velocity row of the class docstring."""
        turning = self._turning(at)
        if not self.axle_held:
            return (VectorRow(self.centre, turning),)
        u = self._line(at)
        points = {self.centre: u}
        if self.on_point is not None:
            points[self.on_point] = -u
        return (ScalarRow(points, {body: -dot(u, c) for body, c in turning.items()}),)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """``i Omega (v_centre - v_Q) + Omega (Omega - omega) w``: nothing if the line does not turn."""
        if self.on is None or self.on_point is None:
            return (0.0,)
        turn, w = speeds.omega[self.on], at.z[self.centre] - at.z[self.contact]
        shift = speeds.v[self.centre] - speeds.v[self.on_point]
        extra = 1j * turn * shift + turn * (turn - speeds.omega[self.body]) * w
        return (-dot(self._line(at), extra) if self.axle_held else extra,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Slip along the line and distance from it (m), seen from the line."""
        w = start.z[self.centre] - start.z[self.contact]
        if self.on is None or self.on_point is None:
            slip = moved.z[self.centre] - start.z[self.centre] - 1j * w * moved.turned[self.body]
        else:
            turn = moved.turned[self.on]
            before = start.z[self.centre] - start.z[self.on_point]
            after = (moved.z[self.centre] - moved.z[self.on_point]) * np.conj(unit_vector(turn))
            slip = after - before - 1j * w * (moved.turned[self.body] - turn)
        if self.axle_held:
            return (dot(self._line(start), slip),)
        return np.real(slip), np.imag(slip)

    def marked(self, moved: Placement, start: Placement) -> Mapping[str, Complex]:
        """The contact: the radius to it turns with the line."""
        radius = start.z[self.contact] - start.z[self.centre]
        turn = unit_vector(moved.turned[self.on]) if self.on is not None else 1.0
        return {self.contact: moved.z[self.centre] + radius * turn}

    def circles(self, at: Placement) -> tuple[JointCircle, ...]:
        """The wheel."""
        return (JointCircle(self.centre, np.abs(at.z[self.centre] - at.z[self.contact]), self.body),)

    def contact_at(self, at: Placement) -> BodyContact:
        """The contact of wheel and line."""
        other = None if self.on is None or self.on_point is None else (self.on, self.on_point)
        return BodyContact(at.z[self.contact], (self.body, self.centre), other)
