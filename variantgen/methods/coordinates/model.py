"""A mechanism in coordinates: what changes with time, and the equations that its joints and drivers put on it.

Unknown are the coordinates of moving points, and angles and ways where a joint speaks of them. What a driver
prescribes or a guide along an axis keeps constant is no unknown. The equations are those of the positions; derivatives
are taken by :mod:`variantgen.algebra.derivative`.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any

from msgspec.structs import replace

from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import Maybe, added, forward, product
from variantgen.algebra.values import parts
from variantgen.mechanism.rows import Constraint
from variantgen.methods.coordinates.coordinate import Coordinate, PositionEquation
from variantgen.methods.coordinates.heading import Heading, fixed_number
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.linkage.problem import CLOSE
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Fact

_LEVEL = 1e-9  # of the size, or of a unit vector: what is smaller is none
_RATES = {"length": ("velocity", "acceleration"), "angle": ("angular velocity", "angular acceleration")}


class Model:
    """The coordinates and equations of the part of a mechanism that leads to what is asked, or of the ``whole``."""

    def __init__(self, book: Book, whole: bool = False) -> None:
        self.book, self.task, self.geometry, self.whole = book, book.task, book.geometry, whole
        self.coordinates: dict[Value, Coordinate] = {}
        self.equations: list[PositionEquation] = []
        self.points = self._included()
        self._x: dict[tuple[str, int], Value] = {}
        self._constant: set[tuple[str, int]] = set()
        self._angles: dict[str, Value] = {}
        self._slides: dict[tuple[str, str], Value] = {}
        self._references: dict[str, tuple[str, str] | None] = {}

    def at(self, order: int) -> Model:
        """The same coordinates and equations with the book for velocities (1) or accelerations (2)."""
        model = copy(self)
        model.book = self.book.at(order)
        return model

    # What takes part.

    def _included(self) -> set[str]:
        """Points that are asked, that joints and drivers speak of, and the hinges."""
        asked = {q.point for q in self.task.sought if q.point}
        found = {point for c in self.relevant for shape in c.shapes() for point in shape.points}
        bodies = self.task.scene.bodies
        reached = self.task.scene.points if self.whole else self.task.needed.points
        hinges = {p for p in reached if sum(p in members for members in bodies.values()) > 1}
        return (found | asked | hinges) - self.task.fixed

    @property
    def relevant(self) -> list[Constraint]:
        """Joints and drivers of points and bodies on the way to what is asked."""
        return [c for c in self.task.scene.constraints if self.is_relevant(c)]

    def is_relevant(self, constraint: Constraint) -> bool:
        """Whether a joint or driver is on the way to what is asked."""
        if self.whole:
            return True
        points = {p for shape in constraint.shapes()[:1] for p in shape.points}
        bodies = {b for shape in constraint.shapes()[:1] for b in shape.bodies}
        needed = self.task.needed
        known = needed.bodies | self.translating
        return bool(points | bodies) and points <= needed.points | self.task.fixed and bodies <= known

    def is_needed(self, body: str) -> bool:
        """Whether the rotation of a body takes part."""
        return self.whole or body in self.task.needed.bodies

    @property
    def translating(self) -> frozenset[str]:
        """Bodies that are kept from turning."""
        return self.task.linkage.translating

    def hold_translating(self) -> None:
        """A body in translation along an axis keeps the other coordinate of all its points."""
        for members in (members for body, members in self.task.scene.bodies.items() if body in self.translating):
            for axis in (0, 1):
                if any((p, axis) in self._constant for p in members):
                    self._constant |= {(p, axis) for p in members}

    # Coordinates.

    def coordinate(self, name: Name, measure: str, exact: float) -> Value:
        """Something new that changes; unknown unless it is prescribed later."""
        size = self.task.size if measure == "length" else 1.0
        value = Value(name, measure, exact, None, size)
        speed, acceleration = (
            Value(replace(name, dots=dots), kind, 0.0, None, self.book.size_of(kind))
            for dots, kind in enumerate(_RATES[measure], 1)
        )
        self.coordinates[value] = Coordinate(value, speed, acceleration)
        return value

    def prescribe(self, value: Value, speed: Expression, acceleration: Expression) -> None:
        """Make a coordinate known as a function of time, by its derivatives now."""
        own = self.coordinates[value]
        own.given = True
        for rate, source in ((own.speed, speed), (own.acceleration, acceleration)):
            rate.exact = source.number(True)
            rate.expression = source if rate.exact else Constant(0.0)

    def hold(self, point: str, axis: int) -> None:
        """Keep the coordinate x (0) or y (1) of a point."""
        self._constant.add((point, axis))

    def is_held(self, point: str, axis: int) -> bool:
        """Whether a coordinate of a point does not change."""
        return point in self.task.fixed or (point, axis) in self._constant

    def of(self, point: str, axis: int) -> Maybe:
        """The coordinate x (0) or y (1) of a point; nothing if it is constant and zero."""
        key = (point, axis)
        z = self.task.now.z[point]
        exact = (z.real, z.imag)[axis]
        if key not in self._x:
            name = Name("xy"[axis], point)
            if self.is_held(point, axis):
                self._x[key] = Value(name, "length", exact, None, self.task.size)
            else:
                self._x[key] = self.coordinate(name, "length", exact)
        value = self._x[key]
        return None if value.exact == 0 and value not in self.coordinates else value

    def unknown(self, point: str, axis: int) -> Value | None:
        """The changing coordinate of a point, or nothing if it is constant."""
        self.of(point, axis)
        value = self._x[point, axis]
        return value if value in self.coordinates else None

    def start(self, point: str, axis: int) -> Maybe:
        """The coordinate of a point at the given instant, as a constant."""
        z = self.task.now.z[point]
        value = Value(Name("xy"[axis], point + "0"), "length", (z.real, z.imag)[axis], None, self.task.size)
        return None if value.exact == 0 else value

    def shift(self, start: str, end: str, axis: int) -> Maybe:
        """The difference of coordinates of two points."""
        return added((1, self.of(end, axis)), (-1, self.of(start, axis)))

    def now(self, start: str, end: str) -> complex:
        """The vector between two points now."""
        return self.geometry.vector(start, end)

    def is_turning(self, body: str | None) -> bool:
        """Whether a body can turn (nothing at rest, no body in translation)."""
        return body is not None and body not in self.translating

    # Angles.

    def reference(self, body: str) -> tuple[str, str] | None:
        """The ray of a body whose direction is its angle; None where the angle is that of turning from now on."""
        if body not in self._references:
            wheel = any(disc.body == body for disc in self.task.form.figure.discs)
            ordered = self.members(body)
            rod = len(ordered) > 1 and not wheel
            self._references[body] = (ordered[0], ordered[1]) if rod else None
        return self._references[body]

    def angle(self, body: str) -> Value:
        """The angle of a body that turns."""
        if body not in self._angles:
            ray = self.reference(body)
            if ray is None:
                self._angles[body] = self.coordinate(Name("rotation", body), "angle", 0.0)
            else:
                exact = degrees(self.now(*ray))
                self._angles[body] = self.coordinate(Name("direction", *ray), "angle", exact)
        return self._angles[body]

    def has_angle(self, body: str) -> bool:
        """Whether the equations speak of the angle of a body."""
        return body in self._angles

    def turned(self, body: str | None, direction: float) -> Heading:
        """The direction of a line of a body that has the given direction (degrees) now."""
        if body is None or not self.is_turning(body):
            return Heading(None, direction)
        own = self.angle(body)
        return Heading(own, direction - own.exact)

    def rotation(self, body: str) -> Value | None:
        """The angle of a body; nothing for one that does not turn."""
        return self.angle(body) if self.is_turning(body) else None

    def swept(self, body: str | None) -> Maybe:
        """The angle through which a body has turned since the given instant."""
        if body is None or not self.is_turning(body):
            return None
        own = self.angle(body)
        if own.exact == 0:
            return own
        name = Name("direction", own.name.of, own.name.about + "0") if own.name else None
        return added((1, own), (-1, Value(name, "angle", own.exact)))

    def pole(self, body: str) -> str:
        """The point of a body from which others are reached: one at rest, or the first that takes part."""
        return self.members(body)[0]

    def members(self, body: str) -> list[str]:
        """The points of a body that take part: those at rest first, then those that drivers or wheels lead."""
        led = [name for driver in self.task.scene.drivers for shape in driver.shapes() for name in shape.points[:1]]
        led += [centre for joint in self.task.scene.joints if (centre := getattr(joint, "centre", ""))]
        found = [p for p in self.task.scene.bodies[body] if p in self.points or p in self.task.fixed]
        return sorted(found, key=lambda p: (p not in self.task.fixed, p not in led))

    def slide(self, point: str, body: str, exact: float) -> Value:
        """The way of a point along its line on a body."""
        if (point, body) not in self._slides:
            taken = any(other == point for other, _ in self._slides)
            name = Name("slide", point, (body or "1") if taken else "")
            self._slides[point, body] = self.coordinate(name, "length", exact)
        return self._slides[point, body]

    def arc(self, point: str, body: str, exact: float) -> Value:
        """The angle of a point on its circle on a body, from the angle of the body (degrees)."""
        if (point, body) not in self._slides:
            self._slides[point, body] = self.coordinate(Name("arc", point), "angle", exact)
        return self._slides[point, body]

    @property
    def slides(self) -> dict[tuple[str, str], Value]:
        """Ways and arcs of sliding points by point and body."""
        return self._slides

    # Equations.

    def add(self, key: str, left: Maybe, right: Maybe, **facts: Fact) -> None:
        """A relation of positions, unless it says nothing."""
        if left is not None or right is not None:
            self.equations.append(PositionEquation(key, left, right, facts))

    def add_sum(self, key: str, left: Maybe, *terms: Maybe, **facts: Fact) -> None:
        """``left = sum of terms``."""
        self.add(key, left, added(*((1, term) for term in terms)), **facts)

    def add_vector(self, key: str, start: str, end: str, terms: Sequence[tuple[Maybe, Maybe]], **facts: Fact) -> None:
        """``x_end = x_start + ...`` and ``y_end = y_start + ...``; ``terms`` are pairs of components."""
        for axis in (0, 1):
            right = added((1, self.of(start, axis)), *((1, term[axis]) for term in terms))
            if self.unknown(end, axis) is None and not self._changes(right):
                continue
            self.add(key, self.of(end, axis), right, **facts)

    def _changes(self, item: Maybe) -> bool:
        return item is not None and bool(changing(item, self))

    def add_distance(self, key: str, start: str, end: str, distance: Expression, **facts: Fact) -> None:
        """``(x_end - x_start)^2 + (y_end - y_start)^2 = distance^2``."""
        squares = [None if d is None else forward(d)[1] ** 2 for d in (self.shift(start, end, axis) for axis in (0, 1))]
        self.add(key, added(*((1, square) for square in squares)), distance**2, **facts)

    def radius(self, body: str | None, centre: str, exact: float) -> Expression:
        """A radius of that length of a body (None: the ground): of its disc in the drawing, by its letter, or a number.

        The sheet of a scene gives letters to radii that its file states as numbers.
        """
        drawn = self.task.drawn_radius(body, centre, exact)
        stated = self.task.stated_radii.get(body or "", ()) if self.task.is_own_scene else ()
        if not isinstance(drawn, Value) and any(abs(radius - exact) <= CLOSE * exact for radius in stated):
            return self.book.geometry.unnamed_radii.of(body or "", exact)
        return drawn or fixed_number("length", exact)

    # Numbers.

    one = Constant(1.0)
    minus = Constant(-1.0)

    def offset(self, number: float) -> Maybe:
        """A constant length of the drawing, with its sign."""
        if abs(number) < _LEVEL * self.task.size:
            return None
        value = fixed_number("length", abs(number))
        return value if number > 0 else product(self.minus, value)

    def length(self, number: Any) -> float:
        """A length of the scene (m) in the printed unit."""
        return float(number) / self.task.length_unit


def changing(item: Expression, model: Model) -> list[Value]:
    """The coordinates that an expression depends on."""
    return [value for value in dict.fromkeys(parts(item)) if value in model.coordinates]
