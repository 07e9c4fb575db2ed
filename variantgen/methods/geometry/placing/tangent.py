"""The point where a thread leaves a drum: the radius there is across the thread."""

from __future__ import annotations

from collections.abc import Mapping

from variantgen.algebra.expression import Applied, Constant, Expression, Ratio
from variantgen.algebra.normal_form import Signed, positive, summed
from variantgen.methods.geometry.constructed_point import ConstructedPoint


class Derivation(ConstructedPoint, frozen=True):
    """The tangent point on the drum (``centre``, ``radius``) of a thread to the drum (``to``, ``to_radius``)."""

    def neighbours(self) -> tuple[str, ...]:
        """The centre of the drum."""
        return (self.fields["centre"],)

    def lengths(self) -> Mapping[tuple[str, str], Expression]:
        """The radius."""
        return {(self.fields["centre"], self.point): self.geometry.read_length(self.fields["radius"])}

    def direction(self, other: str) -> Expression:
        """The line of centres, turned by the acute or obtuse angle at the centre: ``cos = (r -+ r') / d``."""
        geometry, item = self.geometry, self.item
        side = round(float(item.side)) * geometry.angles.sense
        parts: list[Signed] = [(1, geometry.length(other, self.point))]
        if float(item.to_radius) > 0:
            same_side = float(item.side) * float(item.to_side) > 0
            parts.append((-1 if same_side else 1, geometry.read_length(self.fields["to_radius"])))
        to = self.fields["to"]
        sign, offset = positive(summed(parts))
        line = geometry.form(other, to)
        if geometry.is_nothing(offset):
            return geometry.angle(line.turned(90.0 * side))
        corner = Applied("arccos", Ratio(offset, geometry.length(other, to)))
        whole = corner if sign > 0 else Constant(180.0, "angle") - corner
        return geometry.angle(line, ((side, geometry.corner(other, to, self.point, whole)),))
