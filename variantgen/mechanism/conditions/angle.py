"""Two links at a given angle: the instant at which one is perpendicular to another, or parallel to it."""

from __future__ import annotations

from msgspec import Struct

from variantgen.mechanism.arithmetic import unit_vector
from variantgen.mechanism.component import Angle, PointName
from variantgen.mechanism.condition import VectorProduct


class LinkAngle(Struct, frozen=True):
    """``(exp(i size) f) x s = 0`` with f the first link, from its first named point to its second, and s the second.

    The angle, from the first to the second, counts counter-clockwise (rad). The equation holds for the opposite
    direction of the second link too; the picture from which the points are placed decides.
    """

    first: tuple[PointName, PointName]
    second: tuple[PointName, PointName]
    size: Angle

    def product(self) -> VectorProduct:
        """``Re(-i exp(-i size) conj(f) s) = 0``."""
        return VectorProduct(self.first, self.second, -1j * unit_vector(self.size).conjugate())
