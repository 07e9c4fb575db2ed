"""A point of a line at a distance from a point beside it: the slider of a slider-crank."""

from __future__ import annotations

from collections.abc import Mapping

from variantgen.algebra.expression import Applied, Expression, Ratio, SquareRoot, Times
from variantgen.algebra.normal_form import Signed, positive, signed, summed
from variantgen.methods.geometry.angles import between
from variantgen.methods.geometry.constructed_point import ConstructedPoint
from variantgen.methods.geometry.legs import Leg
from variantgen.methods.geometry.located_point import Ray
from variantgen.methods.steps.step import triangle


class Derivation(ConstructedPoint, frozen=True):
    """The link ``centre`` - point of given length, whose end is led along a line.

    The distance h of its other end from the line gives its angle with the line, ``sin beta = h / r``, and the way along
    the line, ``r cos beta = sqrt(r^2 - h^2)``.
    """

    def neighbours(self) -> tuple[str, ...]:
        """The point of the line, then the other end of the link."""
        return (self.fields["through"], self.fields["centre"])

    def rays(self) -> tuple[Ray, ...]:
        """The line."""
        start = self.fields["through"]
        return (Ray(start, self.point, self.guide(start)),)

    def lengths(self) -> Mapping[tuple[str, str], Expression]:
        """The length of the link."""
        return {(self.fields["centre"], self.point): self.geometry.read_length(self.fields["distance"])}

    def _way(self) -> list[Leg]:
        """From the point of the line to the other end of the link."""
        start, centre = self.neighbours()
        return self.geometry.way(start, centre, before=self.point)

    def _is_ahead(self) -> bool:
        """Whether the link points along the line, not against it."""
        line = self.geometry.number(self.guide(self.fields["through"]))
        return between(self.geometry.bearing(self.fields["centre"], self.point), line) < 90.0

    def direction(self, other: str) -> Expression:
        """The direction of the line less the angle of the link with it."""
        line, geometry = self.guide(self.fields["through"]), self.geometry
        ahead = self._is_ahead()
        base = line if ahead else line.turned(180.0)
        sign, height = positive(summed(geometry.projected("sin", self._way(), line)))
        if geometry.is_nothing(height):
            return geometry.angle(base)
        beta = self._corner(Applied("arcsin", Ratio(height, geometry.length(other, self.point))), height)
        return geometry.angle(base, ((-sign if ahead else sign, beta),))

    def _corner(self, beta: Expression, height: Expression) -> Expression:
        """The angle of the link with the line: a corner of the triangle with a point of the line, or one by itself.

        The ``height`` of that triangle is a side of it, where it has a right angle, or a side times a sine.
        """
        start, centre = self.neighbours()
        shown = start not in self.geometry.task.form.figure.hidden
        ways = [self.geometry.vector(self.point, name) for name in (start, centre)]
        if shown and len(self._way()) == 1 and (ways[0].conjugate() * ways[1]).real > 0:
            corners = (self.point, start, centre)
            if self.geometry.known_corner(self.point, centre, start) is None and self.geometry.lettered.issuperset(
                corners
            ):
                shape = "sines" if isinstance(signed(height)[1], Times) else "right"
                self.geometry.say(f"triangle_{shape}", triangle=triangle(*sorted(corners)))
            return self.geometry.corner(self.point, centre, start, beta)
        ahead = self.geometry.ahead_on(start, self.guide(start)) if shown else ""
        line = "link" if ahead and ahead != self.point else "guide"
        return self.geometry.inclination(centre, self.point, line, beta, (start, ahead) if line == "link" else ())

    def length(self, other: str) -> Expression:
        """The projections of the way and of the link on the line."""
        start, centre = self.neighbours()
        line, geometry = self.guide(start), self.geometry
        way, link = self._way(), geometry.length(centre, self.point)
        parts: list[Signed] = list(geometry.projected("cos", way, line))
        if geometry.has_direction(centre, self.point):
            parts += geometry.projected("cos", [Leg(link, geometry.form(centre, self.point))], line)
        else:
            _, height = positive(summed(geometry.projected("sin", way, line)))
            flat = geometry.is_nothing(height)
            along_line = link if flat else SquareRoot(summed([(1, link**2), (-1, height**2)]))
            parts.append((1 if self._is_ahead() else -1, along_line))
        return positive(summed(parts))[1]
