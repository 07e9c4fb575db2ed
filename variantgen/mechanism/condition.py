"""What a condition on points says: a product of two vectors between them has a given value.

Distances, lines and angles are all of this kind, so that what they leave is quadratic in the coordinates: their second
derivatives do not depend on where the points are.
"""

from __future__ import annotations

from typing import Protocol

from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Real


class VectorProduct(Struct, frozen=True):
    """``Re(factor conj(first) second) = value``; the vectors lead from one named point to another.

    Without a ``first`` vector the condition is linear, with 1 in its place.
    """

    first: tuple[str, str] | None
    second: tuple[str, str]
    factor: Complex
    value: Real = 0.0


class Condition(Protocol):
    """A condition (see :mod:`variantgen.mechanism.conditions`)."""

    def product(self) -> VectorProduct:
        """What it says of its points."""
        ...
