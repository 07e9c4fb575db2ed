"""Fixed pivot: a point that does not move."""

from __future__ import annotations

import numpy as np

from variantgen.mechanism.arithmetic import Complex, Real
from variantgen.mechanism.component import PointName
from variantgen.mechanism.joint import Joint
from variantgen.mechanism.rows import Placement, Shape, Speeds, VectorRow


class Pivot(Joint, frozen=True):
    """``z_P = const``, ``v_P = 0``, ``a_P = 0``."""

    point: PointName

    def shapes(self) -> tuple[Shape, ...]:
        """One vector row for the point, without bodies."""
        return (Shape(points=(self.point,), given_point=self.point),)

    def rows(self, at: Placement) -> tuple[VectorRow, ...]:
        """``v_P = 0``."""
        return (VectorRow(self.point),)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Nothing: the point stays."""
        return (0.0,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Both components of the displacement (m)."""
        shift = moved.z[self.point] - start.z[self.point]
        return np.real(shift), np.imag(shift)
