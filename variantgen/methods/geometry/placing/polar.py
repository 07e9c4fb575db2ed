"""A point at a distance and a direction from another one."""

from __future__ import annotations

from collections.abc import Mapping

from variantgen.algebra.expression import Expression
from variantgen.algebra.normal_form import positive
from variantgen.methods.geometry.constructed_point import ConstructedPoint
from variantgen.methods.geometry.located_point import Ray


class Derivation(ConstructedPoint, frozen=True):
    """``z = z_origin + distance * exp(i*angle)``, the angle counted from the x axis or from a ray."""

    def neighbours(self) -> tuple[str, ...]:
        """The origin of the ray."""
        return (self.fields["origin"],)

    def rays(self) -> tuple[Ray, ...]:
        """The ray from the origin."""
        origin = self.fields["origin"]
        if self.fields.get("towards") is None:
            form = self.guide(origin)
        else:
            angles = self.geometry.angles
            form = self.guide(origin).plus(angles.relative(angles.read(self.fields.get("angle"))))
        return (Ray(origin, self.point, form if float(self.item.distance) > 0 else form.turned(180.0)),)

    def reference(self) -> tuple[str, str] | None:
        """The ray from which the angle is counted."""
        towards = self.fields.get("towards")
        return None if towards is None else (self.fields["origin"], towards)

    def lengths(self) -> Mapping[tuple[str, str], Expression]:
        """The distance, without its sign."""
        _, distance = positive(self.geometry.read_length(self.fields["distance"]))
        return {(self.fields["origin"], self.point): distance}
