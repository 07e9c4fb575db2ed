"""A point that divides a segment."""

from __future__ import annotations

from variantgen.algebra.expression import Constant, Expression, Ratio, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import positive, summed
from variantgen.methods.geometry.constructed_point import ConstructedPoint
from variantgen.methods.geometry.located_point import Pair, Ray


class Derivation(ConstructedPoint, frozen=True):
    """``z = z_start + part * (z_end - z_start)``."""

    def neighbours(self) -> tuple[str, ...]:
        """The ends of the segment."""
        return (self.fields["start"], self.fields["end"])

    def rays(self) -> tuple[Ray, ...]:
        """The segment and its parts are one line."""
        start, end = self.neighbours()
        form = self.geometry.form(start, end)
        return (Ray(start, self.point, form), Ray(self.point, end, form))

    def coordinates(self) -> Pair | None:
        """The means of the coordinates of the ends, where the direction of the segment is not known."""
        start, end = self.neighbours()
        if self.geometry.has_direction(start, end) or float(self.item.part) != 0.5:
            return None
        ends = zip(self.geometry.coordinates(start), self.geometry.coordinates(end), strict=True)
        x, y = (_mean(*pair) for pair in ends)
        pair = self.geometry.located(Name("x", self.point), x), self.geometry.located(Name("y", self.point), y)
        self.geometry.show(pair)
        return pair

    def share(self, other: str) -> Expression | None:
        """Its share of the segment."""
        start, end = self.neighbours()
        if other not in (start, end):
            return None
        whole = self.geometry.length(start, end)
        if float(self.item.part) == 0.5:
            return Ratio(whole, Constant(2.0))
        field = self.fields["part"]
        part = self.geometry.task.expressed(field) or Constant(float(self.item.part))
        _, share = positive(part if other == start else summed([(1, Constant(1.0)), (-1, part)]))
        return share * whole


def _mean(first: Value, second: Value) -> Expression:
    return Ratio(summed((1, value) for value in (first, second) if value.exact != 0), Constant(2.0))
