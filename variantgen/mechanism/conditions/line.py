"""A point on a straight line: a slider in its guide, a rod through a sleeve, a link of given direction."""

from __future__ import annotations

from typing import ClassVar

from msgspec import Struct

from variantgen.mechanism.arithmetic import unit_vector
from variantgen.mechanism.component import Angle, PointName
from variantgen.mechanism.condition import VectorProduct


class PointOnLine(Struct, frozen=True):
    """``u x (z_point - z_through) = 0`` with u the direction ``angle`` (rad) or through -> ``towards``."""

    point: PointName
    through: PointName
    angle: Angle = 0.0
    towards: PointName | None = None
    either: ClassVar[tuple[tuple[str, str], ...]] = (("angle", "towards"),)

    def product(self) -> VectorProduct:
        """``Re(-i conj(u) p) = 0`` with p from the line to the point and u along the line, of any length."""
        to_point = (self.through, self.point)
        if self.towards is None:
            return VectorProduct(None, to_point, -1j * unit_vector(self.angle).conjugate())
        return VectorProduct((self.through, self.towards), to_point, -1j)
