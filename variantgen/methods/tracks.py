"""The vectors of a point on a fixed path: known direction of the velocity, normal component of the acceleration."""

from __future__ import annotations

from variantgen.methods.book import Book, Known
from variantgen.methods.expression import Constant, Value
from variantgen.methods.geometry import Geometry, degrees
from variantgen.methods.group import Track
from variantgen.methods.name import Name
from variantgen.methods.points import across, modulus, positive
from variantgen.methods.step import Point, Term

_DATA_DIGITS = 3  # decimals of an angle that the statement gives (degrees)
_ROUNDING = 1e-9


def on_track(book: Book, track: Track) -> tuple[Known, Term]:
    """What is known of the vector of a point on its path, and the rest, of unknown magnitude in an assumed direction.

    On a line the assumed direction is to the right (or up), on a circle counter-clockwise.
    """
    name = Name(book.letter, track.point)
    if track.straight:
        return (), book.term(name, None, line_angle(book, track), "guide", point=Point(track.point))
    if book.order == 1:
        return (), across(book, name, None, (track.point, track.centre), 1)
    normal = _normal(book, track, name.component("n"))
    return normal, across(book, name.component("tau"), None, (track.point, track.centre), 1)


def line_angle(book: Book, track: Track) -> Value:
    """The angle of a straight path with the x axis: one of the data, or that of a side of a body along the path."""
    way = forward(track.line)
    exact = degrees(way)
    if abs(exact - round(exact, _DATA_DIGITS)) < _ROUNDING:
        return Value(None, "angle", exact)
    for members in book.task.scene.bodies.values():
        for other in members if track.point in members else ():
            side = book.geometry.vector(track.point, other)
            if other != track.point and abs((side.conjugate() * way).imag) < _ROUNDING * abs(side):
                angle = book.geometry.direction(track.point, other)
                return angle if (side.conjugate() * way).real > 0 else Geometry.turned(angle, 180.0)
    return Value(None, "angle", exact, Constant(exact))


def forward(line: complex) -> complex:
    """The direction of a line that leads to the right, of an upright one that leads up."""
    right = line.real if abs(line.real) > 1e-9 else line.imag
    return line if right > 0 else -line


def _normal(book: Book, track: Track, name: Name) -> Known:
    """``a^n = v^2 / r`` or, where the rate of the body that leads the point is known, ``omega^2 r``, to the centre."""
    arm = book.geometry.length(track.point, track.centre)
    angle = book.geometry.direction(track.point, track.centre)
    rate = book.omega.get(track.body) if track.body else None
    if rate is not None:
        if not rate.sense:
            return ()
        size = book.derive(name, "acceleration", rate.size**2 * arm)
    else:
        terms = book.velocity[track.point]
        if not terms:
            return ()
        book.say("common.circle", point=Point(track.point), centre=Point(track.centre))
        size = book.derive(name, "acceleration", modulus(book, Name("v", track.point), terms) ** 2 / arm)
    return (book.term(name, size, angle, "towards", start=Point(track.point), end=Point(track.centre)),)


def settled(term: Term, size: Value) -> Known:
    """An unknown vector that has been found: with its true direction; nothing where it is zero."""
    if size.exact == 0:
        return ()
    angle = term.angle if size.exact > 0 else Geometry.turned(term.angle, 180.0)
    return (Term(term.name, positive(size), angle, term.way),)


def sense_of(term: Term, size: Value, assumed: int) -> int:
    """The true sense of a rotation whose vector was assumed in the sense ``assumed``."""
    return 0 if size.exact == 0 else assumed if size.exact > 0 else -assumed
