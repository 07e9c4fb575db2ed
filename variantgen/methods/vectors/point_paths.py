"""The vectors of a point on a fixed path: known direction of the velocity, normal component of the acceleration."""

from __future__ import annotations

import cmath
import math

from variantgen.algebra.expression import Constant, Value
from variantgen.algebra.name import Name
from variantgen.mechanism.joints.guide import Guide
from variantgen.methods.geometry.geometry import Geometry, degrees
from variantgen.methods.groups.group import PointPath
from variantgen.methods.solution.book import Book, Known
from variantgen.methods.steps.step import Fact, Point, Segment, Term
from variantgen.methods.vectors.points import across, modulus, positive

_DATA_DIGITS = 3  # decimals of an angle that the statement gives (degrees)
_ROUNDING = 1e-9


def on_path(book: Book, point_path: PointPath) -> tuple[Known, Term]:
    """The known terms of the vector of a point on its path, and the unknown one along it, in an assumed direction.

    On a line the assumed direction is to the right (or up), on a circle counter-clockwise.
    """
    name = Name(book.letter, point_path.point)
    if point_path.straight:
        way, facts = _way_along(book, point_path)
        return (), book.term(name, None, line_angle(book, point_path), way, **facts)
    if book.order == 1:
        return (), across(book, name, None, (point_path.point, point_path.centre), 1)
    normal = _normal(book, point_path, name.component("n"))
    return normal, across(book, name.component("tau"), None, (point_path.point, point_path.centre), 1)


def line_angle(book: Book, point_path: PointPath) -> Value:
    """The angle of a straight path with the x axis: one of the data, or that of a side of a body along the path."""
    way = forward(point_path.line)
    exact = degrees(way)
    same_motion = _moving_alike(book, point_path.point)
    for template, joint in zip(book.task.form.joints, book.task.scene.joints, strict=True):
        if isinstance(joint, Guide) and joint.point in same_motion:
            stated = book.geometry.stated_angle(template.fields.get("angle"), way)
            if stated.expression is not None:
                return stated
    if abs(exact - round(exact, _DATA_DIGITS)) < _ROUNDING:
        return Value(None, "angle", exact)
    if other := _side_along(book, point_path):
        angle = book.geometry.direction(point_path.point, other)
        ahead = (book.geometry.vector(point_path.point, other).conjugate() * way).real > 0
        return angle if ahead else Geometry.turned(angle, 180.0)
    return Value(None, "angle", exact, Constant(exact, "angle"))


def _moving_alike(book: Book, point: str) -> set[str]:
    """A point and those of bodies in translation of which it is one."""
    scene = book.task.scene
    return {point}.union(*(scene.bodies[body] for body in book.task.translating if point in scene.bodies[body]))


def _side_along(book: Book, point_path: PointPath) -> str | None:
    """A point of the same body in the direction of a straight path."""
    for members in book.task.scene.bodies.values():
        for other in members if point_path.point in members else ():
            side = book.geometry.vector(point_path.point, other)
            if other != point_path.point and abs((side.conjugate() * point_path.line).imag) < _ROUNDING * abs(side):
                return other
    return None


def _way_along(book: Book, point_path: PointPath) -> tuple[str, dict[str, Fact]]:
    """How the direction of a straight path is described: by a guide that the figure shows, by a line of the body."""
    task, point = book.task, point_path.point
    figure, joints = task.form.figure, task.scene.joints
    guided = point not in figure.bare and any(isinstance(joint, Guide) and joint.point == point for joint in joints)
    if guided or any(point in task.scene.bodies[body] for body in task.translating):
        return "guide", {"point": Point(point)}
    other = _side_along(book, point_path)
    # The direction of the centre of a wheel is no matter of the points of its rim.
    if other is None or other in figure.hidden or any(disc.centre == point for disc in figure.discs):
        return "straight", {"point": Point(point)}
    return "slot", {"segment": Segment(point, other)}


def forward(line: complex) -> complex:
    """The direction of a line that leads to the right, of an upright one that leads up."""
    right = line.real if abs(line.real) > 1e-9 else line.imag
    return line if right > 0 else -line


def _normal(book: Book, point_path: PointPath, name: Name) -> Known:
    """``a^n = v^2 / r`` or, where the rate of the body that leads the point is known, ``omega^2 r``, to the centre."""
    arm = book.geometry.length(point_path.point, point_path.centre)
    angle = book.geometry.direction(point_path.point, point_path.centre)
    rate = book.omega.get(point_path.body) if point_path.body else None
    if rate is not None:
        if not rate.sense:
            return ()
        size = book.derive(name, "acceleration", rate.size**2 * arm)
    else:
        terms = book.velocity[point_path.point]
        if not terms:
            return ()
        book.say("common.circle", point=Point(point_path.point), centre=Point(point_path.centre))
        size = book.derive(name, "acceleration", modulus(book, Name("v", point_path.point), terms) ** 2 / arm)
    return (book.term(name, size, angle, "towards", start=Point(point_path.point), end=Point(point_path.centre)),)


def directed(term: Term, size: Value) -> Known:
    """An unknown vector that has been found: with its true direction; nothing where it is zero."""
    if size.exact == 0:
        return ()
    angle = term.angle if size.exact > 0 else Geometry.turned(term.angle, 180.0)
    return (Term(term.name, positive(size), angle, term.way),)


def sense_of(book: Book, term: Term, size: Value) -> int:
    """The sense of the rotation about a pole of which a vector across the radius was found."""
    segment = term.way.facts["segment"]
    assert isinstance(segment, Segment)
    ahead = cmath.rect(size.exact, math.radians(term.angle.exact))
    turn = (book.geometry.vector(segment.end, segment.start).conjugate() * ahead).imag
    return (turn > 0) - (turn < 0)
