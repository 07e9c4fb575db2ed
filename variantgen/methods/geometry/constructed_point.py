"""What a solution reads from the way a point was placed; one module per construction in :mod:`~.placing`.

A construction tells lengths and directions (what the statement gives), and how to work out the rest from points that
were placed before.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from variantgen.methods.geometry.angles import AngleForm
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.geometry.legs import Leg
from variantgen.methods.geometry.located_point import LocatedPoint


class ConstructedPoint(LocatedPoint, frozen=True):
    """A point by its construction: ``fields`` are those of the family file."""

    geometry: Geometry
    point: str
    fields: Mapping[str, Any]

    @property
    def item(self) -> Any:
        """The construction with its numbers (SI)."""
        return self.geometry.task.scene.points[self.point]

    def legs(self, other: str) -> tuple[Leg, ...]:
        """The way from a neighbour here."""
        geometry = self.geometry
        return (Leg(geometry.length(other, self.point), geometry.form(other, self.point)),)

    def guide(self, start: str, angle: str = "angle", towards: str = "towards") -> AngleForm:
        """The direction on paper that the construction gives by an angle or by a second point."""
        target = self.fields.get(towards)
        if target is not None:
            return self.geometry.form(start, target)
        angles = self.geometry.angles
        return self.geometry.on_bases(angles.on_paper(angles.read(self.fields.get(angle))))
