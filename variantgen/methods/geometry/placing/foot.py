"""The foot of a perpendicular: two legs of a right triangle."""

from __future__ import annotations

from variantgen.algebra.expression import Expression
from variantgen.algebra.normal_form import positive, summed
from variantgen.methods.geometry.constructed_point import ConstructedPoint
from variantgen.methods.geometry.located_point import Ray


class Derivation(ConstructedPoint, frozen=True):
    """The foot of the perpendicular from ``of`` to the line through ``through``."""

    def neighbours(self) -> tuple[str, ...]:
        """The point of the line, then the one above it."""
        return (self.fields["through"], self.fields["of"])

    def rays(self) -> tuple[Ray, ...]:
        """The line and the perpendicular."""
        start, of = self.neighbours()
        line = self.guide(start)
        return (Ray(start, self.point, line), Ray(of, self.point, line.turned(90.0)))

    def length(self, other: str) -> Expression:
        """The projection of the way between both points on the line, or across it."""
        start, of = self.neighbours()
        function = "cos" if other == start else "sin"
        legs = self.geometry.way(start, of, before=self.point)
        parts = self.geometry.projected(function, legs, self.guide(start))
        return positive(summed(parts))[1]
