"""The order of a solution: which group of links comes next, given what is known already."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

from variantgen.mechanism.drivers.circling import Circling
from variantgen.mechanism.drivers.extension import Extension
from variantgen.mechanism.drivers.relative_travel import RelativeTravel
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.joint import Sliding
from variantgen.methods.groups.carriers import is_within_reach
from variantgen.methods.groups.contact_groups import contact_groups
from variantgen.methods.groups.group import (
    Dyad,
    ExtendingLink,
    FixedSleeve,
    FloatingDyad,
    Group,
    PivotedLink,
    PointPath,
    RelativeRotation,
    RollingContactPole,
    RollingWheel,
    SlidingPair,
    Support,
    ThirdClassGroup,
    TwoPointBody,
)
from variantgen.methods.groups.reached import KnownMotion
from variantgen.methods.solution.book import Book

_SEARCHES = (
    "_relative_rotations",
    "_fixed_sleeves",
    "_pivoted_links",
    "_rolling_wheels",
    "_dyads",
    "_floating_dyads",
    "_sliding_pairs",
    "_contact_groups",
    "_extending_links",
    "_pivoted_links_at_last",
    "_two_point_bodies",
    "_third_class_groups",
    "_rolling_contact_poles",
)
_BY_NUMBERS = ("_contact_groups",)  # whether tangents are parallel


class Route(KnownMotion):
    """Looks for the next group of a book whose velocities are being worked out."""

    def __init__(self, book: Book) -> None:
        super().__init__(book)
        self.taken: list[Group] = []

    def next(self) -> Group | None:
        """The next group that adds something that is needed, or None when nothing does."""
        self.open_bodies = self._open_bodies()
        for at_last in (False, True):
            self.at_last = at_last
            found = next((group for group in self._groups() if group not in self.taken), None)
            if found is not None:
                self.taken.append(found)
                return found
        return None

    def _groups(self) -> Iterator[Group]:
        """The groups within reach, in the order in which they are taken.

        What is found follows from names, so the form remembers which searches are vain where the same is known.
        """
        book = self.book
        known = frozenset(book.velocity), frozenset(book.omega), frozenset(book.relative)
        vain: set[str] = self.task.by_names.setdefault(("vain", self.at_last, self.translating, *known), set())
        for name in _SEARCHES:
            if name in vain:
                continue
            nothing = True
            for group in getattr(self, name)():
                nothing = False
                yield group
            if nothing and name not in _BY_NUMBERS:
                vain.add(name)

    def _relative_rotations(self) -> Iterator[Group]:
        for number, driver in enumerate(self.scene.drivers):
            if (
                isinstance(driver, Rotation)
                and driver.relative_to in self.book.omega
                and driver.body not in self.book.omega
            ):
                yield RelativeRotation(driver.body, driver.relative_to, number)

    def _fixed_sleeves(self) -> Iterator[Group]:
        for joint in self.scene.joints:
            pair = joint.locked()
            for body, other in permutations(pair) if pair else ():
                if body in self.open_bodies and other in self.book.omega:
                    yield FixedSleeve(body, other)

    def _pivoted_links(self) -> Iterator[Group]:
        for body in self.open_bodies:
            members = self.scene.bodies[body]
            pivot = self.task.linkage.pivot(body)
            known = [p for p in members if p != pivot and p in self.book.velocity]
            if pivot is not None and known:
                yield PivotedLink(body, pivot, known[0])

    def _rolling_wheels(self) -> Iterator[Group]:
        for number, joint in enumerate(self.scene.joints):
            wheel = joint.on_ground()
            if wheel and (wheel.centre in self.book.velocity) != (wheel.body in self.book.omega):
                yield RollingWheel(wheel.body, wheel.centre, number, wheel.contact, wheel.around)

    def _dyads(self) -> Iterator[Group]:
        for body in self.open_bodies:
            pole = self.known_point(body)
            if pole is None or pole in self.task.fixed:
                continue
            for point in self.scene.bodies[body]:
                if point != pole and not self.is_known(point) and (point_path := self.point_path(point, body)):
                    yield Dyad(body, pole, point_path)

    def _floating_dyads(self) -> Iterator[Group]:
        for first in self.open_bodies:
            for second in self.open_bodies:
                members = self.scene.bodies[first]
                shared = [p for p in members if p in self.scene.bodies[second] and not self.is_known(p)]
                poles = self.known_point(first), self.known_point(second)
                if first < second and shared and poles[0] and poles[1]:
                    yield FloatingDyad(shared[0], (first, second), (poles[0], poles[1]))

    def _sliding_pairs(self) -> Iterator[Group]:
        for path in self.task.linkage.slides:
            if path.point not in self.task.needed.points:
                continue
            if (path.point, path.body) not in self.book.relative and (group := self._sliding(path)) is not None:
                yield group

    def _sliding(self, path: Sliding) -> Group | None:
        """What the sliding of a point on a body tells, if one of the two is known well enough."""
        point, carrier = path.point, path.body
        turning = carrier in self.book.omega or carrier in self.translating
        moved = self.is_moved(carrier) or (turning and self.known_point(carrier) is not None)
        if moved:
            pole = self.known_point(carrier) or ""
            if self._is_driven(path):
                return SlidingPair(path, carrier, pole, False, driven=True)
            if self.is_known(point):
                return SlidingPair(path, carrier, pole, False)
            if point_path := self.point_path(point, carrier):
                return SlidingPair(path, carrier, pole, False, point_path=point_path)
            for body in self.owners(point):
                if body in self.open_bodies and (own := self.known_point(body)):
                    return SlidingPair(path, carrier, pole, False, body, own)
            return None
        if not self.is_known(point):
            return None
        if carrier in self.translating:
            ends = ((p, self.guided(p)) for p in self.scene.bodies[carrier])
            point_path = next((PointPath(p, line=way) for p, way in ends if way), None)
            return None if point_path is None else SlidingPair(path, carrier, "", False, carrier_path=point_path)
        known = self.known_point(carrier)
        return None if known is None else SlidingPair(path, carrier, known, True)

    def _is_driven(self, path: Sliding) -> bool:
        """Whether the relative motion of a point is given."""
        return any(
            isinstance(driver, RelativeTravel | Circling) and (driver.point, driver.body) == (path.point, path.body)
            for driver in self.scene.drivers
        )

    def _contact_groups(self) -> Iterator[Group]:
        yield from contact_groups(self)

    def _extending_links(self) -> Iterator[Group]:
        for number, driver in enumerate(self.scene.drivers):
            if not isinstance(driver, Extension):
                continue
            for point, base in ((driver.end, driver.start), (driver.start, driver.end)):
                for body in self.owners(point):
                    pivot = self.task.linkage.pivot(body)
                    if pivot is not None and self.is_known(base) and body in self.open_bodies:
                        yield ExtendingLink(number, body, pivot, point, base)

    def _pivoted_links_at_last(self) -> Iterator[Group]:
        """Bodies about a fixed point of which another point can be had from a neighbour."""
        for body in self.open_bodies:
            members = self.scene.bodies[body]
            pivot = self.task.linkage.pivot(body)
            known = [p for p in members if p != pivot and is_within_reach(self.book, p)]
            if pivot is not None and known:
                yield PivotedLink(body, pivot, known[0])

    def _two_point_bodies(self) -> Iterator[Group]:
        for body in self.open_bodies:
            known = [p for p in self.scene.bodies[body] if self.is_known(p)]
            if len(known) > 1:
                yield TwoPointBody(body, known[0], known[1])

    def _third_class_groups(self) -> Iterator[Group]:
        for body in self.open_bodies:
            held = [support for point in self.scene.bodies[body] if (support := self._support(point, body))]
            first = next((support for support in held if support.point_path is not None), None)
            if first is not None and first.point_path is not None and len(held) > 2:
                others = [support for support in held if support is not first]
                yield ThirdClassGroup(body, first.point_path, (others[0], others[1]))

    def _support(self, point: str, body: str) -> Support | None:
        """What holds a point of a body that has no known point."""
        if point_path := self.point_path(point, body):
            return Support(point, point_path)
        for rod in self.owners(point):
            if rod != body and rod in self.open_bodies and (far := self.known_point(rod)):
                return Support(point, rod=rod, far=far)
        return None

    def _rolling_contact_poles(self) -> Iterator[Group]:
        for joint in self.scene.joints:
            wheel = joint.on_ground()
            if wheel is None or wheel.body not in self.open_bodies:
                continue
            if wheel.contact in self.scene.bodies[wheel.body] and wheel.contact not in self.book.velocity:
                yield RollingContactPole(wheel.body, wheel.centre, wheel.contact)
