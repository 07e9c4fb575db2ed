"""Gear mesh, external or internal; the centres may be fixed or ride on a carrier."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from variantgen.mechanism.arithmetic import Complex, Flags, Real, cross
from variantgen.mechanism.component import BodyName, PointName, Size
from variantgen.mechanism.joint import BodyContact, Joint, JointCircle
from variantgen.mechanism.pitch import can_touch, line_of_centres, other_radius
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


class Gears(Joint, frozen=True):
    """The pitch circle of ``body`` (``centre`` A, ``radius`` r) rolls on that of ``other`` (``other_centre`` C).

    ``inside``: the first gear meshes with a ring gear from inside. Without ``other`` the second gear is fixed. What
    holds the centres at their distance d = z_A - z_C (pivots, a carrier) is said by other joints; the second radius is
    |d| - r or, inside, |d| + r. Two gears on one shaft are two meshes of one body. With ``k = r/|d|`` (outside) or
    ``-r/|d|`` (inside) and W, W' the angular velocity and acceleration of the line of centres (Willis)::

        k omega + (1 - k) Omega = W,   W |d| = n.(v_A - v_C),   n = i d/|d|
        k epsilon + (1 - k) E = W',    W' |d| = n.(a_A - a_C)
    """

    body: BodyName
    centre: PointName
    radius: Size
    other_centre: PointName
    other: BodyName | None = None
    inside: bool = False
    belongs: ClassVar[Mapping[str, str]] = {"centre": "body", "other_centre": "other"}

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the centres and the gears."""
        if self.other is None:
            return (Shape((self.centre,), (self.body,)),)
        return (Shape((self.centre, self.other_centre), (self.body, self.other)),)

    def resting(self) -> tuple[str, ...]:
        """The centre of a fixed gear."""
        return (self.other_centre,) if self.other is None else ()

    def ratio(self, at: Placement) -> tuple[Complex, Real]:
        """The vector d and the number k of the class docstring."""
        return line_of_centres(at.z[self.centre], at.z[self.other_centre], self.radius, self.inside)

    def sound(self, at: Placement) -> Flags:
        """The centres are apart, and two circles that touch from outside are each smaller than their distance."""
        return can_touch(self.ratio(at)[1], self.inside)

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """The velocity row of the class docstring, times -|d|."""
        d, k = self.ratio(at)
        distance = np.abs(d)
        n = 1j * d / np.where(distance > 0, distance, 1.0)
        points, turning = {self.centre: n}, {self.body: -k * distance}
        if self.other is not None:
            points[self.other_centre] = -n
            turning[self.other] = -(1.0 - k) * distance
        return (ScalarRow(points, turning),)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Nothing: the distance of the centres does not change."""
        return (0.0,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Way of the line of centres less that of the pitch circles (m)."""
        d, k = self.ratio(start)
        turn = k * moved.turned[self.body]
        centre = start.z[self.other_centre]
        if self.other is not None:
            turn = turn + (1.0 - k) * moved.turned[self.other]
            centre = moved.z[self.other_centre]
        now = moved.z[self.centre] - centre
        swung = np.arctan2(cross(d, now), np.real(d) * np.real(now) + np.imag(d) * np.imag(now))
        return (np.abs(d) * (swung - turn),)

    def circles(self, at: Placement) -> tuple[JointCircle, ...]:
        """Both pitch circles."""
        distance = np.abs(at.z[self.centre] - at.z[self.other_centre])
        second = other_radius(distance, self.radius, self.inside)
        return (
            JointCircle(self.centre, self.radius, self.body),
            JointCircle(self.other_centre, second, self.other or ""),
        )

    def contact_at(self, at: Placement) -> BodyContact:
        """The pitch point."""
        d, k = self.ratio(at)
        other = None if self.other is None else (self.other, self.other_centre)
        return BodyContact(at.z[self.centre] - k * d, (self.body, self.centre), other)
