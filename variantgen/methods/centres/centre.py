"""The velocity centre P or the acceleration centre Q of a body: rays from its points to the centre.

Each ray has a length and a direction. The first ones come from how the centre was found; that of any other point C of
the body follows from a triangle A C P with a known ray A P: by the law of cosines, or more simply where the triangle is
right-angled, has two equal sides, or is none because the points lie on one line.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable

from msgspec import Struct

from variantgen.algebra.expression import Applied, Constant, Expression, Ratio, SquareRoot, Total, Value, cos, sin
from variantgen.algebra.name import Name
from variantgen.methods.geometry.angle_sums import difference
from variantgen.methods.geometry.geometry import Geometry, between, normal_angle
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.named_angles import by_name, note_sum
from variantgen.methods.solution.rays import Centre, CentreRay
from variantgen.methods.steps.step import Derived, Fact, Point, triangle

NEAR = 1e-9  # of the size of the mechanism: closer points are one
SAME_ANGLE = 1e-7  # degrees within which two angles are one, but for rounding
_NO_LENGTH = 1e-12  # of the sides of a triangle: a shorter leg is none


def is_near(book: Book, first: complex, second: complex) -> bool:
    """Whether two places are one, but for rounding; far from the mechanism that is coarser."""
    middle = next(iter(book.task.now.z.values()))
    return abs(first - second) <= NEAR * (book.task.size + abs(first - middle))


def named_place(book: Book, place: complex) -> str:
    """The point of the figure at a place, or nothing."""
    hidden = book.task.form.figure.hidden
    names = (name for name in book.task.now.z if name not in hidden)
    return next((name for name in names if is_near(book, place, book.task.now.z[name])), "")


def own_angle(value: Value) -> Value:
    """An angle of a triangle; one that is a given or known angle is that."""
    return value.expression if isinstance(value.expression, Value) else value


def note_angle(book: Book, value: Value) -> Value:
    """Show once how an angle is found; a given or known one needs no line."""
    if isinstance(value.expression, Value) or value.name is None or value.name.kind == "parameter":
        return own_angle(value)
    name = value.name
    if name not in book.values:
        value = by_name(book, value)
        book.items.append(Derived(value))
        book.values[name] = value
        note_sum(book, value)
    return book.values[name]


def is_angle(value: float, *others: float) -> bool:
    """Whether an angle (degrees) is one of those given."""
    return any(abs(value - other) < SAME_ANGLE for other in others)


# The ray of a further point, from a triangle.


class _Triangle(Struct, frozen=True):
    """The triangle A C P: ``base`` A with its known ray, ``point`` C, ``spread`` the angle at A (degrees)."""

    base: str
    point: str
    ray: CentreRay
    side: float
    spread: float

    @property
    def shape(self) -> int:
        """What is special about it; the simplest comes first."""
        equal = abs(self.side - self.ray.arm.exact) <= NEAR * self.side
        cases = (
            is_angle(self.spread, 0.0, 180.0),
            equal and is_angle(self.spread, 60.0),
            is_angle(self.spread, 90.0),
            equal,
        )
        return next((i for i, case in enumerate(cases) if case), len(cases))


_ON_LINE, _EQUILATERAL, _RIGHT, _ISOSCELES, _GENERAL = range(5)
_WITHOUT_ANGLE = (_ON_LINE, _EQUILATERAL, _RIGHT)
_SHAPES = ("on_line", "equilateral", "right", "isosceles", "general")


def ray_to_centre(book: Book, centre: Centre, point: str, with_direction: bool) -> CentreRay | None:
    """The ray from a point of the body to the centre, with the lines that find its length; None at the centre.

    The lines for its direction are written where it is asked for (``with_direction``).
    """
    if point in centre.rays:
        return centre.rays[point]
    if is_near(book, book.task.now.z[point], centre.place(book.task)):
        centre.at = centre.at or point
        return None
    triangle = _simplest(book, centre, point)
    if triangle is not None and triangle.shape == _GENERAL and (corner := _corner_between(book, centre, point)):
        ray_to_centre(book, centre, corner, False)
        triangle = _simplest(book, centre, point)
    if triangle is None:
        at = centre.at
        found = CentreRay(book.geometry.length(point, at), book.geometry.direction(point, at))
    else:
        found = _found(book, centre, triangle, with_direction)
    centre.rays[point] = found
    return found


def is_simple(book: Book, centre: Centre, point: str) -> bool:
    """Whether the distance of a point from a centre follows without a law of cosines."""
    if centre.infinite or point in centre.rays or is_near(book, book.task.now.z[point], centre.place(book.task)):
        return True
    triangle = _simplest(book, centre, point)
    return triangle is None or triangle.shape < _GENERAL


def _corner_between(book: Book, centre: Centre, point: str) -> str:
    """Another corner of the body on the way: two simple triangles take the place of a law of cosines; empty for none.

    Its own distance follows without an angle, and that of the point from a triangle that is right-angled there.
    """
    if not book.style.shortcuts:
        return ""
    place = centre.place(book.task)
    for corner in book.task.scene.bodies[centre.body]:
        if corner in (point, *centre.rays) or corner in book.task.form.figure.hidden:
            continue
        first, way = _simplest(book, centre, corner), place - book.task.now.z[corner]
        if first is None or first.shape not in _WITHOUT_ANGLE or is_near(book, book.task.now.z[corner], place):
            continue
        ray = CentreRay(Value(None, "length", abs(way)), Value(None, "angle", math.degrees(cmath.phase(way))))
        second = _simplest(book, Centre(centre.body, centre.kind, rays={corner: ray}), point)
        if second is not None and second.shape in _WITHOUT_ANGLE:
            return corner
    return ""


def _simplest(book: Book, centre: Centre, point: str) -> _Triangle | None:
    """The triangle of the simplest shape with a known ray."""
    found = []
    for base, ray in centre.rays.items():
        side = book.geometry.vector(base, point)
        if abs(side) > NEAR * book.task.size:
            spread = between(math.degrees(cmath.phase(side)), ray.angle.exact)
            found.append(_Triangle(base, point, ray, abs(side), spread))
    return min(found, key=lambda triangle: triangle.shape, default=None)


def _found(book: Book, centre: Centre, corners: _Triangle, with_direction: bool) -> CentreRay:
    """The third side of the triangle, and its direction from the point C."""
    base, point, ray = corners.base, corners.point, corners.ray
    side = book.geometry.length(base, point)
    there, mark = _towards(book, centre, base, point)
    shape = corners.shape
    facts: dict[str, Fact] = {
        "point": Point(point),
        "base": Point(base),
        "centre": centre.fact,
        "ray": centre.segment(base),
        "triangle": triangle(point, base, centre.kind, centre.body),
    }
    book.say(f"centre.{_SHAPES[shape]}", **facts)
    spread = difference(centre.corner(base, mark), ray.angle, there)
    if shape in (_ISOSCELES, _GENERAL):
        spread = note_angle(book, spread)
    arm = book.derive(centre.length(point), "length", _ARMS[shape](ray.arm, side, spread))
    if shape == _ON_LINE:
        beyond = spread.exact < 90.0 and side.exact > ray.arm.exact
        return CentreRay(arm, Geometry.turned(ray.angle, 180.0) if beyond else ray.angle)
    corner = Value(centre.corner(point, base), "angle", *_corner(shape, ray.arm, side, spread))
    back = Geometry.turned(there, 180.0)
    goal = math.degrees(cmath.phase(centre.place(book.task) - book.task.now.z[point]))
    sign = min((1, -1), key=lambda s: abs(normal_angle(back.exact + s * corner.exact - goal)))
    angle = turned_by(centre.direction(point), back, sign, corner)
    if with_direction:
        note_angle(book, corner)
    return CentreRay(arm, angle)


def _towards(book: Book, centre: Centre, base: str, point: str) -> tuple[Value, str]:
    """The direction from one point to another, and the point that names it: an earlier one on the same line will do."""
    side = book.geometry.vector(base, point)
    for other in centre.rays:
        along = book.geometry.vector(base, other)
        if other != base and abs((along.conjugate() * side).imag) <= NEAR * abs(along) * abs(side):
            there = book.geometry.direction(base, other)
            ahead = (along.conjugate() * side).real > 0
            return (there, other) if ahead else (Geometry.turned(there, 180.0), point)
    return book.geometry.direction(base, point), point


def _on_line(arm: Value, side: Value, spread: Value) -> Expression:
    if spread.exact > 90.0:
        return arm + side
    return arm - side if arm.exact > side.exact else side - arm


def _hypotenuse(arm: Value, side: Value) -> Expression:
    if abs(arm.exact - side.exact) <= NEAR * side.exact:
        return side * SquareRoot(Constant(2.0))
    return SquareRoot(arm**2 + side**2)


_ARMS: dict[int, Callable[[Value, Value, Value], Expression]] = {
    _ON_LINE: _on_line,
    _EQUILATERAL: lambda arm, side, spread: side,
    _ISOSCELES: lambda arm, side, spread: Constant(2.0) * side * sin(spread / Constant(2.0)),
    _RIGHT: lambda arm, side, spread: _hypotenuse(arm, side),
    _GENERAL: lambda arm, side, spread: SquareRoot(arm**2 + side**2 - Constant(2.0) * arm * side * cos(spread)),
}


def _corner(shape: int, arm: Value, side: Value, spread: Value) -> tuple[float, Expression]:
    """The angle at C between the sides to A and to P, in degrees: its number and its expression."""
    expression: Expression
    if shape == _EQUILATERAL:
        expression = Constant(60.0, "angle")
    elif shape == _ISOSCELES:
        expression = Constant(90.0, "angle") - spread / Constant(2.0)
    elif shape == _RIGHT:
        equal = abs(arm.exact - side.exact) <= NEAR * side.exact
        expression = Constant(45.0, "angle") if equal else Applied("arctan", Ratio(arm, side))
    else:
        expression = _steep(arm * sin(spread), side - arm * cos(spread), max(arm.exact, side.exact))
    return expression.number(True), expression


def _steep(across: Expression, ahead: Expression, scale: float) -> Expression:
    """The angle whose tangent is ``across / ahead``, 0 to 180 degrees."""
    length = ahead.number(True)
    if abs(length) <= _NO_LENGTH * scale:
        return Constant(90.0, "angle")
    slope = Applied("arctan", Ratio(across, ahead))
    return slope if length > 0 else slope + Constant(180.0, "angle")


def turned_by(name: Name | None, start: Value, sign: int, turn: Value) -> Value:
    """A direction turned by an angle, between -180 and 180 degrees."""
    total = start.exact + sign * turn.exact
    exact = normal_angle(total)
    whole = round((exact - total) / 360.0) * 360.0
    parts: list[tuple[int, Expression]] = [(1, start), (sign, turn)]
    parts += [(1 if whole > 0 else -1, Constant(abs(whole), "angle"))] if whole else []
    return Value(name, "angle", exact, Total(tuple(parts)))
