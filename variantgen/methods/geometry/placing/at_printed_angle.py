"""The end of a link whose angle with another one is printed, because the position follows from equations only."""

from __future__ import annotations

from collections.abc import Mapping

from variantgen.algebra.expression import Expression
from variantgen.methods.geometry.constructed_point import ConstructedPoint


class Derivation(ConstructedPoint, frozen=True):
    """The point at a ``distance`` from ``origin``; the printed angle gives the direction of the link."""

    def neighbours(self) -> tuple[str, ...]:
        """The other end of the link."""
        return (self.fields["origin"],)

    def lengths(self) -> Mapping[tuple[str, str], Expression]:
        """The length of the link."""
        return {(self.fields["origin"], self.point): self.geometry.read_length(self.fields["distance"])}
