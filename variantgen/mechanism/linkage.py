"""A mechanism as a reader of its figure sees it: what rests, what only translates, what turns about a fixed point.

Solutions, figures and their descriptions ask the same object. The solver, its verification and the reference of the
accuracy report do not: they work with the equations of joints alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import cross
from variantgen.mechanism.joint import Sliding
from variantgen.mechanism.rows import Constraint, Placement, ScalarRow, Shape
from variantgen.mechanism.scene import Scene, fixed_points

_ASLANT = 1e-6  # sine of the angle of a rope with a guide: less is rounding


class Linkage(Struct, frozen=True, dict=True):
    """The reading of a scene; it depends on names and joints, but for the directions of guides not on numbers."""

    scene: Scene

    @cached_property
    def hinged(self) -> frozenset[str]:
        """Fixed hinges: points that a joint holds in place by itself."""
        return frozenset(fixed_points(self.scene))

    @cached_property
    def resting(self) -> frozenset[str]:
        """Points at rest: fixed hinges, and what joints say to rest besides, as centres of fixed circles."""
        return self.hinged | {name for joint in self.scene.joints for name in joint.resting()}

    @cached_property
    def translating(self) -> frozenset[str]:
        """Bodies that a single joint keeps from turning, and sleeves on one of them that do not swivel."""
        shapes = [shape for joint in self.scene.joints for shape in joint.shapes() if not shape.points]
        held = {body for shape in shapes if len(shape.bodies) == 1 for body in shape.bodies}
        sleeves = [pair for joint in self.scene.joints if (pair := joint.locked())]
        return frozenset(held | {sleeve for sleeve, body in sleeves if body in held})

    @cached_property
    def cranks(self) -> dict[str, list[tuple[str, str]]]:
        """By body the points that another body leads round a point at rest, with that point: two of them or more."""
        bodies, found = self.scene.bodies, dict[str, list[tuple[str, str]]]()
        for body, own in bodies.items():
            ends = [
                (point, pivot)
                for point in own
                for other, members in bodies.items()
                if other != body and point in members and point not in self.resting
                for pivot in members
                if pivot in self.resting
            ]
            if len(ends) > 1:
                found[body] = ends
        return found

    def owners(self, point: str) -> list[str]:
        """Bodies that a point belongs to, in the order of the scene."""
        return [body for body, members in self.scene.bodies.items() if point in members]

    def pivot(self, body: str) -> str | None:
        """The point at rest about which a body turns; None where it has none."""
        return self._pivots.get(body)

    @cached_property
    def _pivots(self) -> dict[str, str]:
        bodies = self.scene.bodies.items()
        return {body: point for body, points in bodies for point in reversed(points) if point in self.resting}

    @cached_property
    def driven(self) -> tuple[tuple[str | None, str | None], ...]:
        """By driver the body whose rotation it gives, and the point whose motion it gives; None for any other."""
        return tuple((driven_body(driver), driven_point(driver)) for driver in self.scene.drivers)

    @property
    def slides(self) -> Iterator[Sliding]:
        """The paths of points that slide on moving bodies."""
        return (path for joint in self.scene.joints if (path := joint.sliding()))

    def slide(self, point: str, body: str) -> Sliding:
        """The path of a point on a body. Raises LookupError where it does not slide there."""
        found = next((path for path in self.slides if (path.point, path.body) == (point, body)), None)
        if found is None:
            raise LookupError(f"{point} does not slide on {body}")
        return found

    def guides(self, at: Placement) -> dict[str, complex]:
        """Directions (unit vectors) of the straight fixed guides of points, with the points placed ``at``."""
        found: dict[str, complex] = {}
        for joint in self.scene.joints:
            shapes = joint.shapes()
            if joint.landmarks() or not any(map(_is_of_one_point, shapes)):
                continue
            for shape, row in zip(shapes, joint.rows(at), strict=True):
                if _is_of_one_point(shape) and isinstance(row, ScalarRow):
                    normal = complex(row.points[shape.points[0]])
                    found.setdefault(shape.points[0], -1j * normal / abs(normal))
        return found

    def aslant_stations(self, at: Placement) -> list[str]:
        """Stations at rest from which a rope runs aslant to the guide of a point: how fast depends on their place.

        Where it runs along the guide, wherever its pulley stands, the figure says all.
        """
        strands = [strand for joint in self.scene.joints for strand in joint.strands(at)]
        guides = self.guides(at) if strands else {}
        led = [strand for strand in strands if strand.end in guides]
        aslant = [s.station for s in led if np.any(np.abs(cross(s.ray, guides[s.end])) > _ASLANT)]
        return list(dict.fromkeys(aslant))


def _is_of_one_point(shape: Shape) -> bool:
    """Whether a row binds a single point to the ground."""
    return len(shape.points) == 1 and not shape.bodies and shape.given_point is None


def driven_body(driver: Constraint) -> str | None:
    """The body whose own rotation a driver gives; None for any other driver."""
    match driver.shapes():
        case (Shape((), (body,)),):
            return body
    return None


def driven_point(driver: Constraint) -> str | None:
    """The point whose own motion a driver gives, as a vector (two rows) or along its path (one); None for any other."""
    match tuple(set(driver.shapes())):
        case (Shape((point,), ()),):
            return point
    return None
