"""A point at given distances from two points: the law of cosines in their triangle, or two circles that cross."""

from __future__ import annotations

import math
from collections.abc import Mapping

from variantgen.algebra.expression import Applied, Constant, Expression, Ratio, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import squared, summed
from variantgen.methods.geometry import trigonometry
from variantgen.methods.geometry.constructed_point import ConstructedPoint
from variantgen.methods.geometry.located_point import Pair
from variantgen.methods.geometry.which_root import on_side
from variantgen.methods.steps.step import EquationLine, Fact, Point, Segment, triangle

_SIDES = 2  # of a triangle on the line of centres
_NEAR = 1e-9  # relative difference of two lengths that are one


class Derivation(ConstructedPoint, frozen=True):
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
        to_third, here = geometry.vector(other, third), geometry.vector(other, self.point)
        side = 1 if (to_third.conjugate() * here).imag > 0 else -1
        geometry.length(other, third)  # its lines come before what is said of the triangle
        known = geometry.known_corner(third, other, self.point)
        key, corner = self._by_height(other, third, known) if known is not None else self._by_sides(other, third)
        centres = self.neighbours()
        if key:
            corners = triangle(*sorted((self.point, *centres)))
            said = f"triangle_{key}" if key != "sides" else on_side(geometry, "triangle_sides", self.point, *centres)
            geometry.say(said, False, triangle=corners, point=Point(self.point), base=Segment(*centres))
        named = geometry.corner(other, third, self.point, corner)
        return geometry.angle(geometry.form(other, third), ((side, named),))

    def _sides(self, other: str, third: str) -> tuple[Value, Value, Value]:
        """The line of centres, the link from a centre, and that from the other one."""
        ends = ((other, third), (other, self.point), (third, self.point))
        base, own, opposite = (self.geometry.length(*pair) for pair in ends)
        return base, own, opposite

    def _by_height(self, other: str, third: str, known: Value) -> tuple[str, Expression]:
        """The second angle at the line of centres; of an isosceles triangle it is the first."""
        _, own, opposite = self._sides(other, third)
        if _same(own, opposite):
            return "", known
        return "height", trigonometry.by_height(*self._sides(other, third), known)

    def _by_sides(self, other: str, third: str) -> tuple[str, Expression]:
        """The angle at a centre by the three sides, as the shape of the triangle has it."""
        two = Constant(2.0)
        base, own, opposite = self._sides(other, third)
        if _same(base, own) and _same(own, opposite):
            return "" if base is own is opposite else "equilateral", Constant(60.0, "angle")
        if _same(own, opposite):
            return "isosceles", Applied("arccos", Ratio(base, two * own))
        if _same(base, opposite):
            return "isosceles", Applied("arccos", Ratio(own, two * base))
        if _same(base, own):
            return "isosceles", two * Applied("arcsin", Ratio(opposite, two * own))
        if _are_legs(base, own, opposite):
            return "right", Constant(90.0, "angle")
        for leg, whole in ((own, base), (base, own)):
            if _are_legs(leg, opposite, whole):
                return "right", Applied("arccos", Ratio(leg, whole))
        squares = summed([(1, own**2), (1, base**2), (-1, opposite**2)])
        return "sides", Applied("arccos", Ratio(squares, two * own * base))

    def coordinates(self) -> Pair | None:
        """The solution of the equations of both circles, unless the direction of a link follows from a triangle."""
        geometry, first, second = self.geometry, self.fields["first"], self.fields["second"]
        if any(geometry.has_direction(centre, self.point) for centre in (first, second)):
            return None
        if len(geometry.way(first, second, before=self.point)) <= _SIDES:
            geometry.direction(second, self.point)
            return None
        z = self._crossing()
        pair = geometry.solution(Name("x", self.point), z.real), geometry.solution(Name("y", self.point), z.imag)
        geometry.say(
            "two_circles", point=Point(self.point), first=Segment(first, self.point), second=Segment(second, self.point)
        )
        for centre in (first, second):
            squares = squared(geometry.differences(pair, geometry.coordinates(centre)))
            geometry.items.append(EquationLine(squares, geometry.length(centre, self.point) ** 2))
        facts: dict[str, Fact] = {"point": Point(self.point), "segment": Segment(first, second)}
        geometry.say(on_side(geometry, "chosen", self.point, first, second), False, **facts)
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


def _same(first: Value, second: Value) -> bool:
    """Whether two lengths are equal."""
    return abs(first.exact - second.exact) <= _NEAR * first.exact


def _are_legs(first: Value, second: Value, whole: Value) -> bool:
    """Whether two lengths are legs of a right triangle with that hypotenuse."""
    return abs(first.exact**2 + second.exact**2 - whole.exact**2) <= _NEAR * whole.exact**2
