"""Rolling without slip on a fixed straight line."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from variantgen.mechanism.arithmetic import Complex, Real
from variantgen.mechanism.component import BodyName, PointName
from variantgen.mechanism.rows import Joint, Placement, Shape, Speeds, VectorRow


@dataclass(frozen=True)
class Rolling(Joint):
    """A wheel rolls on the fixed straight line that touches it at ``contact``.

    The point of the wheel at the contact is at rest, and the radius to the contact keeps its direction in space;
    with ``w = z_centre - z_contact`` (constant)::

        z_centre - z_centre_start = i w (phi - phi_start),   v_centre = i w omega,   a_centre = i w epsilon
    """

    body: BodyName
    centre: PointName
    contact: PointName

    def shapes(self) -> tuple[Shape, ...]:
        """One vector row: the centre by the angular velocity."""
        return (Shape(points=(self.centre,), bodies=(self.body,), lead=self.centre),)

    def rows(self, at: Placement) -> tuple[VectorRow, ...]:
        """``v_centre = i w omega``."""
        return (VectorRow(self.centre, {self.body: 1j * (at.z[self.centre] - at.z[self.contact])}),)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Nothing: the line is straight, so w does not turn."""
        return (0.0,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Slip along the line and distance from it (m)."""
        w = start.z[self.centre] - start.z[self.contact]
        slip = moved.z[self.centre] - start.z[self.centre] - 1j * w * moved.turned[self.body]
        return np.real(slip), np.imag(slip)
