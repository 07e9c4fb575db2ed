"""Prescribed velocity and acceleration vectors of a point."""

from __future__ import annotations

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Real, dot, unit_vector
from variantgen.mechanism.component import Acceleration, Angle, PointName, Velocity
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


class VectorMotion(Struct, frozen=True):
    """``v_point = v exp(i angle)``, ``a_point = a exp(i a_angle)``: both vectors are given (angles in the scene frame).

    Takes both freedoms of the point, where :class:`~variantgen.mechanism.drivers.travel.Travel` takes one.
    """

    point: PointName
    v: Velocity = 0.0
    angle: Angle = 0.0
    a: Acceleration = 0.0
    a_angle: Angle = 0.0

    def shapes(self) -> tuple[Shape, ...]:
        """Two scalar rows on the point: its components along the axes of the scene."""
        return (Shape(points=(self.point,)), Shape(points=(self.point,)))

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """``u.v_point = Re``, ``w.v_point = Im`` with the axes u, w of the scene on paper."""
        return ScalarRow({self.point: at.frame.place(1.0)}), ScalarRow({self.point: at.frame.place(1.0j)})

    def _vector(self, order: int) -> Complex:
        return self.v * unit_vector(self.angle) if order == 1 else self.a * unit_vector(self.a_angle)

    def rates(self, order: int) -> tuple[Real, ...]:
        """Components of the velocity (m/s) or acceleration (m/s^2)."""
        vector = self._vector(order)
        return np.real(vector), np.imag(vector)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Nothing."""
        return (0.0, 0.0)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Components of the way less those of ``v t + a t^2 / 2`` (m)."""
        way = moved.z[self.point] - start.z[self.point]
        wanted = (self._vector(1) + 0.5 * self._vector(2) * time) * time
        x, y = start.frame.place(1.0), start.frame.place(1.0j)
        return dot(x, way) - np.real(wanted), dot(y, way) - np.imag(wanted)
