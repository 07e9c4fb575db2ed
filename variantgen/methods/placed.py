"""What a solution reads from the way a point was placed; one module per construction in :mod:`~.placing`.

A construction tells lengths and directions (what the statement gives), and how to work out the rest from points that
were placed before.
"""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from variantgen.methods.angles import AngleForm
from variantgen.methods.expression import Expression, Value
from variantgen.methods.legs import Leg

if TYPE_CHECKING:
    from variantgen.methods.geometry import Geometry

Pair = tuple[Value, Value]

ORIGIN = ""  # the origin of the scene, among names of points


@dataclass(frozen=True)
class Ray:
    """The ray from one point to another with its direction on paper."""

    start: str
    end: str
    form: AngleForm


@dataclass(frozen=True)
class Placed:
    """A point by its construction: ``fields`` are those of the family file."""

    geometry: Geometry
    point: str
    fields: Mapping[str, Any]
    in_system: ClassVar[bool] = False  # placed together with other points, by a system of equations

    @property
    def item(self) -> Any:
        """The construction with its numbers (SI)."""
        return self.geometry.task.scene.points[self.point]

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
        geometry = self.geometry
        return (Leg(geometry.length(other, self.point), geometry.form(other, self.point)),)

    def coordinates(self) -> Pair | None:
        """Both coordinates, where they are not found by the way from a neighbour."""
        return None

    def guide(self, start: str, angle: str = "angle", towards: str = "towards") -> AngleForm:
        """The direction on paper that the construction gives by an angle or by a second point."""
        target = self.fields.get(towards)
        if target is not None:
            return self.geometry.form(start, target)
        angles = self.geometry.angles
        return self.geometry.on_bases(angles.on_paper(angles.read(self.fields.get(angle))))


def placed(geometry: Geometry, point: str) -> Placed:
    """The point as its construction tells it; the module has the stem of the construction."""
    template = geometry.task.form.points[point]
    stem = template.component.__module__.rpartition(".")[2]
    found: Placed = importlib.import_module(f"variantgen.methods.placing.{stem}").Construction(
        geometry, point, template.fields
    )
    return found
