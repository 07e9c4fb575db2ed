"""A point given by coordinates: two legs along the axes of the scene."""

from __future__ import annotations

from variantgen.methods.geometry.angles import AngleForm
from variantgen.methods.geometry.constructed_point import ConstructedPoint
from variantgen.methods.geometry.legs import Leg
from variantgen.methods.geometry.located_point import ORIGIN


class Derivation(ConstructedPoint, frozen=True):
    """``z = x + i y`` in the scene, laid on paper."""

    def neighbours(self) -> tuple[str, ...]:
        """The origin of the scene."""
        return (ORIGIN,)

    def legs(self, other: str) -> tuple[Leg, ...]:
        """Along the axes of the scene."""
        angles = self.geometry.angles
        return tuple(
            Leg(self.geometry.read_length(self.fields[key]), angles.on_paper(AngleForm((), turn)))
            for key, turn in (("x", 0.0), ("y", 90.0))
        )
