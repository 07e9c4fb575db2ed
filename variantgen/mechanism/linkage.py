"""A mechanism as a reader of its figure sees it: what rests, what only translates, what turns about a fixed point.

Solutions, figures and their descriptions ask the same object. The solver, its verification and the reference of the
accuracy report do not: they work with the equations of joints alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.rows import Constraint, Placement, ScalarRow, Shape, Sliding
from variantgen.mechanism.scene import Scene, fixed_points


@dataclass(frozen=True)
class Linkage:
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
        sleeves = [(j.sleeve, j.body) for j in self.scene.joints if isinstance(j, Slot) and j.sleeve is not None]
        return frozenset(held | {sleeve for sleeve, body in sleeves if body in held})

    def owners(self, point: str) -> list[str]:
        """Bodies that a point belongs to, in the order of the scene."""
        return [body for body, members in self.scene.bodies.items() if point in members]

    def pivot(self, body: str) -> str | None:
        """The point at rest about which a body turns; None where it has none."""
        return next((point for point in self.scene.bodies[body] if point in self.resting), None)

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
            for shape, row in zip(joint.shapes(), joint.rows(at), strict=True):
                alone = len(shape.points) == 1 and not shape.bodies and shape.given_point is None
                if alone and not joint.landmarks() and isinstance(row, ScalarRow):
                    normal = complex(row.points[shape.points[0]])
                    found.setdefault(shape.points[0], -1j * normal / abs(normal))
        return found


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
