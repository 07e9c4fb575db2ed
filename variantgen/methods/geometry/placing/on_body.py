"""A point of a body by its place relative to two other points: two legs at right angles."""

from __future__ import annotations

from variantgen.methods.geometry.constructed_point import ConstructedPoint
from variantgen.methods.geometry.legs import Leg
from variantgen.methods.geometry.located_point import Ray


class Derivation(ConstructedPoint, frozen=True):
    """``along`` the ray ``origin`` -> ``towards`` and ``across`` it, to its left."""

    def neighbours(self) -> tuple[str, ...]:
        """The origin of the ray."""
        return (self.fields["origin"],)

    def legs(self, other: str) -> tuple[Leg, ...]:
        """Along the ray and across it; what is zero is left out."""
        line = self.geometry.form(self.fields["origin"], self.fields["towards"])
        turns = {"along": 0.0, "across": 90.0 * self.geometry.angles.sense}
        return tuple(
            Leg(self.geometry.read_length(self.fields[key]), line.turned(turn))
            for key, turn in turns.items()
            if key in self.fields and float(getattr(self.item, key)) != 0
        )

    def rays(self) -> tuple[Ray, ...]:
        """The ray itself, for a point on it."""
        legs = self.legs(self.fields["origin"])
        return (Ray(self.fields["origin"], self.point, legs[0].form),) if len(legs) == 1 else ()
