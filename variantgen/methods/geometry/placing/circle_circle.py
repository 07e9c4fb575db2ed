"""A point at given distances from two points: the law of cosines in their triangle, or two circles that cross."""

from __future__ import annotations

import math
from collections.abc import Mapping

from variantgen.algebra.expression import Applied, Constant, Expression, Ratio
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import squared, summed
from variantgen.methods.geometry.constructed_point import ConstructedPoint
from variantgen.methods.geometry.located_point import Pair
from variantgen.methods.steps.step import EquationLine, Point, Segment


class Derivation(ConstructedPoint):
    """The point at ``first_distance`` from ``first`` and ``second_distance`` from ``second``."""

    def neighbours(self) -> tuple[str, ...]:
        """Both centres."""
        return (self.fields["first"], self.fields["second"])

    def lengths(self) -> Mapping[tuple[str, str], Expression]:
        """Both radii."""
        return {
            (self.fields[key], self.point): self.geometry.read_length(self.fields[f"{key}_distance"])
            for key in ("first", "second")
        }

    def direction(self, other: str) -> Expression:
        """The direction of the line of centres, turned by the angle of the triangle at that centre."""
        geometry = self.geometry
        third = next(centre for centre in self.neighbours() if centre != other)
        base = geometry.length(other, third)
        own, opposite = geometry.length(other, self.point), geometry.length(third, self.point)
        corner = Applied(
            "arccos", Ratio(summed([(1, own**2), (1, base**2), (-1, opposite**2)]), Constant(2.0) * own * base)
        )
        to_third, here = geometry.vector(other, third), geometry.vector(other, self.point)
        side = 1 if (to_third.conjugate() * here).imag > 0 else -1
        named = geometry.corner(other, third, self.point, corner)
        return geometry.angle(geometry.form(other, third), ((side, named),))

    def coordinates(self) -> Pair | None:
        """The solution of the equations of both circles, unless the direction of a link is known."""
        geometry, first, second = self.geometry, self.fields["first"], self.fields["second"]
        if any(geometry.has_direction(centre, self.point) for centre in (first, second)):
            return None
        z = self._crossing()
        pair = geometry.solution(Name("x", self.point), z.real), geometry.solution(Name("y", self.point), z.imag)
        geometry.say(
            "two_circles", point=Point(self.point), first=Segment(first, self.point), second=Segment(second, self.point)
        )
        for centre in (first, second):
            squares = squared(geometry.differences(pair, geometry.coordinates(centre)))
            geometry.items.append(EquationLine(squares, geometry.length(centre, self.point) ** 2))
        geometry.say("chosen", False)
        geometry.show(pair)
        return pair

    def _crossing(self) -> complex:
        """Of the two crossings that of the figure: ``x`` along the line of centres, ``h`` across it."""
        geometry = self.geometry
        start, end = (
            complex(*(value.exact for value in geometry.coordinates(self.fields[key]))) for key in ("first", "second")
        )
        r1, r2 = (geometry.length(self.fields[key], self.point).exact for key in ("first", "second"))
        base = abs(end - start)
        x = (base + (r1 - r2) * (r1 + r2) / base) / 2
        h = math.sqrt(max((r1 - x) * (r1 + x), 0.0))  # rounding of a stretched pair of links
        side = 1 if ((end - start).conjugate() * geometry.vector(self.fields["first"], self.point)).imag > 0 else -1
        return start + complex(x, side * h) * (end - start) / base
