"""A point as the geometry of a solution sees it: what is known of its place, whatever construction it has."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping
from functools import cache
from typing import ClassVar

from msgspec import Struct

from variantgen.algebra.expression import Expression, Value
from variantgen.methods.geometry.angles import AngleForm
from variantgen.methods.geometry.legs import Leg

Pair = tuple[Value, Value]

ORIGIN = ""  # the origin of the scene, among names of points


class Ray(Struct, frozen=True):
    """The ray from one point to another with its direction on paper."""

    start: str
    end: str
    form: AngleForm


class LocatedPoint(Struct, frozen=True):
    """A point that was placed after others; by default its construction gives nothing but the way here."""

    in_system: ClassVar[bool] = False  # placed together with other points, by a system of equations

    def neighbours(self) -> tuple[str, ...]:
        """Points (or the origin) from which the way here is known or can be worked out, the plainest first."""
        return ()

    def rays(self) -> tuple[Ray, ...]:
        """Segments of which the construction gives the direction."""
        return ()

    def reference(self) -> tuple[str, str] | None:
        """The ray from which the construction counts its angle, if that is one of the mechanism."""
        return None

    def lengths(self) -> Mapping[tuple[str, str], Expression]:
        """Distances that the construction gives."""
        return {}

    def direction(self, other: str) -> Expression | None:
        """The direction of the ray from a neighbour here (degrees), where it has to be worked out."""
        return None

    def share(self, other: str) -> Expression | None:
        """The distance from a neighbour as a part of a given segment."""
        return None

    def length(self, other: str) -> Expression | None:
        """The distance from a neighbour, where it has to be worked out."""
        return None

    def legs(self, other: str) -> tuple[Leg, ...]:
        """The way from a neighbour here."""
        raise NotImplementedError

    def coordinates(self) -> Pair | None:
        """Both coordinates, where they are not found by the way from a neighbour."""
        return None


@cache
def derivation(stem: str) -> Callable[..., LocatedPoint]:
    """How a point is located, by the module of its construction: ``(geometry, point, fields)`` to the located point."""
    found: Callable[..., LocatedPoint]
    found = importlib.import_module(f"variantgen.methods.geometry.placing.{stem}").Derivation
    return found
