"""Rolling without slip on a circle: outside or inside, fixed or belonging to a moving body."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from variantgen.mechanism.arithmetic import Complex, Flags, Real, unit_vector
from variantgen.mechanism.component import BodyName, PointName, Size
from variantgen.mechanism.joint import BodyContact, GroundWheel, Joint, JointCircle
from variantgen.mechanism.pitch import can_touch, line_of_centres, other_radius
from variantgen.mechanism.rows import Placement, Shape, Speeds, VectorRow


class RollingOnCircle(Joint, frozen=True):
    """A wheel (centre O, ``radius`` r) rolls on the circle about the point ``around`` (C), outside it or ``inside``.

    The radius of the circle follows from the distance d = z_O - z_C: |d| - r outside, |d| + r inside. The circle is at
    rest (then C stays too) or belongs to the body ``on``, of which C is a point. With ``k = r/|d|`` (outside) or
    ``k = -r/|d|`` (inside) the contact is K = O - k d, and the line of centres turns at the rate W::

        v_O = v_C + i W d,   W = k omega + (1 - k) Omega
        a_O = a_C + i (k epsilon + (1 - k) E) d - W^2 d

    where Omega, E belong to ``on`` and are zero for a circle at rest.
    """

    body: BodyName
    centre: PointName
    radius: Size
    around: PointName
    inside: bool = False
    on: BodyName | None = None
    belongs: ClassVar[Mapping[str, str]] = {"centre": "body", "around": "on"}

    def shapes(self) -> tuple[Shape, ...]:
        """One vector row: the centre by that of the circle and the angular velocities."""
        if self.on is None:
            return (Shape((self.centre,), (self.body,), given_point=self.centre),)
        return (Shape((self.centre, self.around), (self.body, self.on), given_point=self.centre, pole=self.around),)

    def on_ground(self) -> GroundWheel | None:
        """The wheel, where the circle is at rest."""
        return GroundWheel(self.body, self.centre, around=self.around) if self.on is None else None

    def when_surplus(self) -> str:
        """A joint that leaves the centre to what leads it."""
        meshed = f'gears = {{ body = "{self.body}", centre = "{self.centre}", other_centre = "{self.around}", ... }}'
        return (
            f"rolling_on_circle by itself leads {self.centre} round {self.around}; where a crank or guide leads it,"
            f" write {meshed} in its place, or leave out the driver of the crank and drive the wheel"
        )

    def landmarks(self) -> tuple[str, ...]:
        """The centre of a fixed circle."""
        return (self.around,) if self.on is None else ()

    def ratio(self, at: Placement) -> tuple[Complex, Real]:
        """The vector d and the number k of the class docstring."""
        return line_of_centres(at.z[self.centre], at.z[self.around], self.radius, self.inside)

    def sound(self, at: Placement) -> Flags:
        """The centres are apart, and two circles that touch from outside are each smaller than their distance."""
        return can_touch(self.ratio(at)[1], self.inside)

    def rows(self, at: Placement) -> tuple[VectorRow, ...]:
        """The velocity row of the class docstring."""
        d, k = self.ratio(at)
        turning = {self.body: 1j * k * d}
        if self.on is not None:
            turning[self.on] = 1j * (1.0 - k) * d
        return (VectorRow(self.centre, turning),)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """``-W^2 d``: the centre goes round the centre of the circle."""
        d, k = self.ratio(at)
        rate = k * speeds.omega[self.body]
        if self.on is not None:
            rate = rate + (1.0 - k) * speeds.omega[self.on]
        return (-rate * rate * d,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """The centre's place (m) less the place that the rotations give it: ``d = d_start exp(i turn)``."""
        d, k = self.ratio(start)
        turn = k * moved.turned[self.body]
        pole = start.z[self.around]
        if self.on is not None:
            turn = turn + (1.0 - k) * moved.turned[self.on]
            pole = moved.z[self.around]
        gap = moved.z[self.centre] - pole - d * unit_vector(turn)
        return np.real(gap), np.imag(gap)

    def circles(self, at: Placement) -> tuple[JointCircle, ...]:
        """The wheel and the circle that it rolls on."""
        second = other_radius(np.abs(at.z[self.centre] - at.z[self.around]), self.radius, self.inside)
        return (JointCircle(self.centre, self.radius, self.body), JointCircle(self.around, second, self.on or ""))

    def contact_at(self, at: Placement) -> BodyContact:
        """The contact of wheel and circle."""
        d, k = self.ratio(at)
        other = None if self.on is None else (self.on, self.around)
        return BodyContact(at.z[self.centre] - k * d, (self.body, self.centre), other)
