"""The crossing of two lines: the sine rule in the triangle of the crossing and a point of each line."""

from __future__ import annotations

from variantgen.algebra.expression import Expression, Ratio
from variantgen.algebra.normal_form import positive, summed
from variantgen.methods.geometry.angles import AngleForm
from variantgen.methods.geometry.constructed_point import ConstructedPoint
from variantgen.methods.geometry.located_point import Ray


class Derivation(ConstructedPoint, frozen=True):
    """The crossing of the line through ``first`` and the line through ``second``."""

    def neighbours(self) -> tuple[str, ...]:
        """A point of each line."""
        return (self.fields["first"], self.fields["second"])

    def _lines(self) -> tuple[AngleForm, AngleForm]:
        first, second = self.neighbours()
        return (
            self.guide(first, "first_angle", "first_towards"),
            self.guide(second, "second_angle", "second_towards"),
        )

    def rays(self) -> tuple[Ray, ...]:
        """Both lines."""
        return tuple(Ray(start, self.point, form) for start, form in zip(self.neighbours(), self._lines(), strict=True))

    def length(self, other: str) -> Expression:
        """The distance of the point of one line from the other line, by the sine of the angle between the lines."""
        first, second = self.neighbours()
        lines = self._lines()
        across = lines[1] if other == first else lines[0]
        legs = self.geometry.way(first, second, before=self.point)
        _, height = positive(summed(self.geometry.projected("sin", legs, across)))
        _, sine = self.geometry.trigonometric("sin", lines[0].minus(lines[1]))
        return height if sine is None else Ratio(height, positive(sine)[1])
