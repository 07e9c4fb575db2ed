"""What of a mechanism is known at a point of a solution, and on which paths its other points move."""

from __future__ import annotations

from functools import cached_property

from variantgen.mechanism.linkage import Linkage
from variantgen.methods.groups.carriers import is_within_reach
from variantgen.methods.groups.contact import NoSlipContact
from variantgen.methods.groups.contacts_of_scene import contacts_of_scene
from variantgen.methods.groups.group import (
    PointPath,
)
from variantgen.methods.solution.book import Book


class KnownMotion:
    """The bodies and points of a book whose velocities are being worked out, as far as they are known."""

    def __init__(self, book: Book) -> None:
        self.book = book
        self.task = book.task
        self.scene = book.task.scene
        self.at_last = False  # whether points are known too that a neighbour of a neighbour leads to
        self.open_bodies: list[str] = []  # needed bodies whose rate is not known

    @cached_property
    def contacts(self) -> dict[int, NoSlipContact]:
        """The contacts and threads of the scene."""
        return contacts_of_scene(self.task)

    @property
    def translating(self) -> frozenset[str]:
        """Bodies that do not turn."""
        return self.task.translating

    def is_known(self, point: str) -> bool:
        """Whether the velocity of a point is known or can be had from a body whose motion is known."""
        if point in self.book.velocity or any(self.is_moved(body) for body in self.owners(point)):
            return True
        return self.at_last and is_within_reach(self.book, point)

    def owners(self, point: str) -> list[str]:
        """Bodies of a point."""
        return self.task.linkage.owners(point)

    def is_moved(self, body: str) -> bool:
        """Whether the motion of a body is known: its rate and one of its points."""
        turning = body in self.book.omega or body in self.translating
        return turning and any(point in self.book.velocity for point in self.scene.bodies[body])

    def known_point(self, body: str) -> str | None:
        """A point of a body that is known: a fixed one, one whose vector is written already, or one that can be had."""
        members = self.scene.bodies[body]
        written = [p for p in members if p in self.task.fixed] + [p for p in members if p in self.book.velocity]
        return next(iter(written), None) or next((p for p in members if self.is_known(p)), None)

    def _open_bodies(self) -> list[str]:
        """Needed bodies whose rate is not known."""
        needed, turning, still = self.task.needed.bodies, self.book.omega, self.task.translating
        return [body for body in self.scene.bodies if body in needed and body not in turning and body not in still]

    def point_path(self, point: str, but: str = "") -> PointPath | None:
        """The fixed path of a point by a guide, a fixed circle or another body than ``but``."""
        key, known = ("path", point, but), self.task.remembered
        if key not in known:
            known[key] = self._found_path(point, but)
        found: PointPath | None = known[key]
        return found

    def _found_path(self, point: str, but: str) -> PointPath | None:
        for joint in self.scene.joints:
            for shape in joint.shapes():
                if shape.points != (point,) or shape.bodies or shape.given_point is not None:
                    continue
                if joint.landmarks():
                    return PointPath(point, centre=joint.landmarks()[0])
                return PointPath(point, line=self.guided(point))
            wheel = joint.on_ground()
            if wheel is not None and wheel.centre == point and wheel.body != but:
                if wheel.around:
                    return PointPath(point, centre=wheel.around)
                arm = self.task.now.z[point] - self.task.now.z[wheel.contact]
                return PointPath(point, line=1j * arm / abs(arm))
        for body in self.owners(point):
            members = self.scene.bodies[body]
            pivot = self.task.linkage.pivot(body)
            if body != but and pivot is not None:
                return PointPath(point, centre=pivot, body=body)
            if body != but and body in self.translating:
                guided = next((t for p in members if p != point and (t := self.guided(p))), None)
                if guided is not None:
                    return PointPath(point, line=guided)
        return None

    def guided(self, point: str) -> complex:
        """The direction of the straight guide of a point, or 0."""
        return self._guides.get(point, 0j)

    @property
    def _guides(self) -> dict[str, complex]:
        """Directions of straight guides; the task remembers them."""
        known = self.task.remembered
        if "guides" not in known:
            known["guides"] = Linkage(self.scene).guides(self.task.at)
        found: dict[str, complex] = known["guides"]
        return found
