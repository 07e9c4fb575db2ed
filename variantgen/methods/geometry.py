"""The position of the mechanism as the solution needs it: lengths, directions and coordinates, worked out on demand.

A length that the statement gives is taken from there; the direction of a segment that follows from given angles alone
is read off; everything else is computed from coordinates, which come from the constructions of the points. Only what
a later step asks for is worked out.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from typing import Any

from variantgen.families.expressions import Expression as FamilyExpression
from variantgen.families.expressions import parse
from variantgen.families.family import Template
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.fraction import Fraction
from variantgen.mechanism.constructions.polar import Polar
from variantgen.methods.expression import (
    Applied,
    Constant,
    Expression,
    Magnitude,
    Ratio,
    SquareRoot,
    Total,
    Value,
)
from variantgen.methods.name import Name
from variantgen.methods.placing import placed
from variantgen.methods.step import Derived, Item
from variantgen.methods.task import CLOSE, Task
from variantgen.methods.timed import timed_direction

_DISTANCES = ("distance", "first_distance", "second_distance", "length")
_LEVEL = 1e-9  # of the size: a coordinate difference below it is none


class Geometry:
    """Lengths, directions and coordinates of one variant; ``items`` are the lines that derive them, in order."""

    def __init__(self, task: Task) -> None:
        self.task = task
        self.items: list[Item] = []
        self._lengths: dict[frozenset[str], Value] = {}
        self._directions: dict[tuple[str, str], Value] = {}
        self._coordinates: dict[str, tuple[Value, Value]] = {}

    def vector(self, start: str, end: str) -> complex:
        """The exact vector between two points (printed unit of length)."""
        return self.task.now.z[end] - self.task.now.z[start]

    # Lengths.

    def length(self, start: str, end: str) -> Value:
        """The distance of two points."""
        key = frozenset((start, end))
        if key not in self._lengths:
            self._lengths[key] = self._length(start, end)
        return self._lengths[key]

    def _length(self, start: str, end: str) -> Value:
        exact = abs(self.vector(start, end))
        for source, part in self._sources(start, end):
            found = part * self.task.read(source) / self.task.length_unit
            if abs(abs(found) - exact) > CLOSE * self.task.size:
                continue
            expression = self.task.expressed(source)
            if expression is None:
                continue
            if part == 1 and isinstance(expression, Value):
                return self._taken(expression)
            return self._derived(start, end, exact, _scaled(expression, part, found))
        return self._worked_out(start, end, exact)

    def _worked_out(self, start: str, end: str, exact: float) -> Value:
        """A length that is not given, by coordinates."""
        step = self._shift(start, end)
        flat = [
            Magnitude(side) for side, other in (step, step[::-1]) if abs(other.number(True)) < _LEVEL * self.task.size
        ]
        expression = flat[0] if flat else SquareRoot(step[0] ** 2 + step[1] ** 2)
        return self._derived(start, end, exact, expression)

    def defined(self, start: str, end: str, expression: Expression) -> Value:
        """A distance that is made of others, as that of two points of contact on a diameter."""
        key = frozenset((start, end))
        if key not in self._lengths:
            self._lengths[key] = self._derived(start, end, expression.number(True), expression)
        return self._lengths[key]

    def radius(self, centre: str, exact: float, body: str) -> Value:
        """The radius of a circle about a point: as the statement gives it, or from what it gives."""
        key = frozenset((centre, f"{exact:.9g}"))
        if key not in self._lengths:
            self._lengths[key] = self._radius(centre, exact, body)
        return self._lengths[key]

    def _radius(self, centre: str, exact: float, body: str) -> Value:
        for disc in self.task.form.figure.discs:
            if (
                disc.centre == centre
                and abs(self.task.read(disc.radius) / self.task.length_unit - exact) < CLOSE * exact
            ):
                expression = self.task.expressed(disc.radius)
                if isinstance(expression, Value):
                    return self._taken(expression)
                if expression is not None:
                    value = Value(Name("radius", body), "length", exact, expression, self.task.size)
                    self.items.append(Derived(value))
                    return value
        return Value(Name("radius", body), "length", exact)

    def _taken(self, value: Value) -> Value:
        """A given length; one in another unit is converted first."""
        if value.expression is not None and not any(isinstance(i, Derived) and i.value is value for i in self.items):
            self.items.append(Derived(value))
        return value

    def _derived(self, start: str, end: str, exact: float, expression: Expression) -> Value:
        value = Value(Name("length", start, end), "length", exact, expression, self.task.size)
        self.items.append(Derived(value))
        return value

    def _sources(self, start: str, end: str) -> Iterator[tuple[FamilyExpression, float]]:
        """Expressions of the family that may be the distance of two points, with a factor."""
        form = self.task.form
        for name in (start + end, end + start):
            if name in form.parameters:
                yield parse(name), 1.0
        for template in (*self._of_points(start, end), *form.conditions):
            if {start, end} <= {item for item in template.fields.values() if isinstance(item, str)} | {start, end}:
                for key in _DISTANCES:
                    if isinstance(source := template.fields.get(key), FamilyExpression):
                        yield source, 1.0
        for disc in form.figure.discs:
            if disc.centre in (start, end):
                yield disc.radius, 1.0
                yield disc.radius, 2.0
        for point, template in form.points.items():
            if template.component is Fraction and point in (start, end):
                part = template.fields.get("part")
                share = self.task.read(part) if isinstance(part, FamilyExpression) else 0.5
                whole = (template.fields["start"], template.fields["end"])
                for source, factor in self._sources(*whole) if {start, end} & set(whole) else ():
                    yield source, factor * share
                    yield source, factor * (1 - share)

    def _of_points(self, *names: str) -> list[Template]:
        return [self.task.form.points[name] for name in names if name in self.task.form.points]

    # Directions.

    def direction(self, start: str, end: str) -> Value:
        """The angle of the ray from one point to another with the x axis (degrees, counter-clockwise, above -180)."""
        key = (start, end)
        if key not in self._directions:
            self._directions[key] = self._direction(start, end)
        return self._directions[key]

    def _direction(self, start: str, end: str) -> Value:
        if (end, start) in self._directions:
            return self.turned(self._directions[end, start], 180.0, Name("direction", start, end))
        exact = degrees(self.vector(start, end))
        name = Name("direction", start, end)
        if self.is_read_off(start, end):
            return Value(name, "angle", exact)
        if timed := timed_direction(self, start, end, exact):
            return timed
        right, up = self._shift(start, end)
        if abs(right.number(True)) < _LEVEL * self.task.size or abs(up.number(True)) < _LEVEL * self.task.size:
            return Value(name, "angle", exact)
        slope: Expression = Applied("arctan", Ratio(up, right))
        turn = round((exact - slope.number(True)) / 180.0) * 180.0
        if turn:
            slope = Total(((1, slope), (1 if turn > 0 else -1, Constant(180.0, "angle"))))
        value = Value(name, "angle", exact, slope)
        self.items.append(Derived(value))
        return value

    def is_read_off(self, start: str, end: str) -> bool:
        """Whether the direction of a segment follows from given angles alone."""
        points = self.task.form.points
        for one, other in ((start, end), (end, start)):
            template = points[one]
            fields = template.fields
            if template.component is Polar and fields["origin"] == other:
                return self._angle_given(fields)
            if template.component is Fraction and {fields["start"], fields["end"]} >= {other}:
                return self.is_read_off(fields["start"], fields["end"])
        if all(points[name].component is Fraction for name in (start, end)):
            first, second = points[start].fields, points[end].fields
            same = {first["start"], first["end"]} == {second["start"], second["end"]}
            return same and self.is_read_off(first["start"], first["end"])
        both = all(points[name].component is Coordinates for name in (start, end))
        return both and abs(_off_axis(self.vector(start, end))) < _LEVEL * self.task.size

    def _angle_given(self, fields: Mapping[str, Any]) -> bool:
        """Whether the angle of a polar construction is made of given angles, from the axis or a direction read off."""
        angle = fields.get("angle")
        if isinstance(angle, FamilyExpression):
            units = [self.task.form.parameters[n].unit for n in angle.names if n in self.task.form.parameters]
            if (
                any(u is not None and u.measures != "angle" for u in units)
                or angle.names & self.task.form.derived.keys()
            ):
                return False
        towards = fields.get("towards")
        return towards is None or self.is_read_off(fields["origin"], towards)

    @staticmethod
    def turned(angle: Value, by: float, name: Name | None = None) -> Value:
        """A direction turned by so many degrees, between -180 and 180."""
        exact = normal_angle(angle.exact + by)
        shift = round(exact - angle.exact, 6)
        sign = 1 if shift >= 0 else -1
        expression = (
            Total(((1, angle), (sign, Constant(abs(shift), "angle")))) if angle.expression is not None else None
        )
        return Value(name, "angle", exact, expression)

    # Coordinates.

    def coordinates(self, point: str) -> tuple[Value, Value]:
        """The coordinates of a point."""
        if point not in self._coordinates:
            self._coordinates[point] = placed(self, point)
        return self._coordinates[point]

    def _shift(self, start: str, end: str) -> tuple[Expression, Expression]:
        """Differences of coordinates as expressions; zeros are left out."""
        first, second = self.coordinates(start), self.coordinates(end)
        return (_difference(second[0], first[0]), _difference(second[1], first[1]))


def _difference(second: Value, first: Value) -> Expression:
    if first.exact == 0:
        return second
    return -first if second.exact == 0 else second - first


def _scaled(expression: Expression, part: float, found: float) -> Expression:
    """A positive multiple of an expression."""
    if part == 0.5:
        expression = Ratio(expression, Constant(2.0))
    elif part != 1:
        expression = Constant(part) * expression
    return -expression if found < 0 else expression


def _off_axis(vector: complex) -> float:
    """How far a vector is from the nearer axis."""
    return min(abs(vector.real), abs(vector.imag))


def degrees(vector: complex) -> float:
    """The angle of a vector with the x axis in degrees, in (-180, 180]."""
    return normal_angle(math.degrees(cmath.phase(vector)))


def normal_angle(angle: float) -> float:
    """An angle in (-180, 180]; one within rounding of a millionth of a degree is that."""
    angle = angle - 360.0 * math.ceil((angle - 180.0) / 360.0 - 1e-12)
    near = round(angle, 6)
    angle = near if abs(near - angle) < 1e-9 else angle
    return 180.0 if angle == -180.0 else angle + 0.0


def between(first: float, second: float) -> float:
    """The angle between two directions in degrees, 0 to 180."""
    return abs(normal_angle(first - second))
