"""Two points at a given distance: the ends of a rigid link."""

from __future__ import annotations

from msgspec import Struct

from variantgen.mechanism.component import PointName, Size
from variantgen.mechanism.condition import VectorProduct


class Distance(Struct, frozen=True):
    """``|z_end - z_start| = length``."""

    start: PointName
    end: PointName
    length: Size

    def product(self) -> VectorProduct:
        """``|d|^2 / (2 length) = length / 2`` with d from the start to the end."""
        way = (self.start, self.end)
        return VectorProduct(way, way, 0.5 / self.length, 0.5 * self.length)
