"""The velocity centre P or the acceleration centre Q of a body by its rays: what is known of it, how it is named."""

from __future__ import annotations

import cmath
import math

from msgspec import Struct, field

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.methods.linkage.problem import Task
from variantgen.methods.steps.step import CentreOf, Segment


class CentreRay(Struct, frozen=True):
    """The way from a point to the centre: its length, and its angle with the x axis."""

    arm: Value
    angle: Value


class Centre(Struct):
    """The centre of ``body``: ``kind`` P of velocities, Q of accelerations.

    ``at`` is the named point with which it coincides, if it does; ``infinite``: the body is in translation, and there
    is none. ``rays`` by point; a point at the centre has none.
    """

    body: str
    kind: str = "P"
    at: str = ""
    infinite: bool = False
    rays: dict[str, CentreRay] = field(default_factory=dict)

    @property
    def key(self) -> tuple[str, str]:
        """The key among the centres of a book."""
        return self.kind, self.body

    @property
    def fact(self) -> CentreOf:
        """The centre in a sentence."""
        return CentreOf(self.body, self.kind)

    def segment(self, point: str) -> Segment:
        """The ray of a point in a sentence, ``AP``."""
        return Segment(point, self.kind, self.body)

    def length(self, point: str) -> Name:
        """The name of the distance of a point, ``AP``."""
        return Name("length", point, self.kind, "centre", self.body)

    def direction(self, point: str) -> Name:
        """The name of the direction of the ray from a point."""
        return Name("direction", point, self.kind, "centre", self.body)

    def corner(self, point: str, other: str) -> Name:
        """The name of the angle at a point between the sides to another point and to the centre."""
        return Name("angle", point, f"{other} {self.kind}", "centre", self.body)

    def vertex(self, first: str, second: str) -> Name:
        """The name of the angle at the centre between the rays to two points."""
        return Name("angle", self.kind, f"{first} {second}", "vertex", self.body)

    def place(self, task: Task) -> complex:
        """The position of the centre by its known rays (printed unit of length)."""
        if self.at:
            return task.now.z[self.at]
        point, ray = next(iter(self.rays.items()))
        return task.now.z[point] + cmath.rect(ray.arm.exact, math.radians(ray.angle.exact))
