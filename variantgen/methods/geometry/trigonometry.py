"""Cosines and sines of sums of angles, reduced as by hand; directions and lengths from legs."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Protocol

from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Ratio,
    SquareRoot,
    Total,
    Value,
    cos,
    sin,
)
from variantgen.algebra.normal_form import Signed, positive, squared, summed, terms_of
from variantgen.methods.geometry.angles import AngleForm, Atom, normal_angle, tidy
from variantgen.methods.geometry.legs import Leg

_NOTHING = 1e-11  # a cosine or sine below it is zero but for rounding
_EQUAL = 1e-9  # relative difference of two lengths that are one
_HALF_TURN = 180.0  # degrees
_SHARP = 0.5  # cosine of an angle that its sine still gives sharply
_QUARTERS = {
    "cos": (("cos", 1), ("sin", -1), ("cos", -1), ("sin", 1)),
    "sin": (("sin", 1), ("cos", 1), ("sin", -1), ("cos", -1)),
}


class Angular(Protocol):
    """What gives the angles that forms are made of, in degrees
    (:class:`variantgen.methods.geometry.geometry.Geometry`).
    """

    def taken_apart(self, form: AngleForm) -> AngleForm:
        """A form in which directions are taken apart into given angles, corners of triangles and numbers."""

    def atom(self, atom: Atom) -> Value:
        """The value of a given angle or of the direction of a ray."""

    def number(self, form: AngleForm) -> float:
        """The angle between -180 and 180 degrees."""

    def total(self, form: AngleForm) -> float:
        """The sum of the parts, whole turns with it."""

    def corner(self, vertex: str, first: str, second: str, expression: Expression) -> Expression:
        """The angle of a triangle at a vertex."""

    def inclination(self, start: str, end: str, line: str, expression: Expression) -> Expression:
        """The acute angle between a segment and a line."""

    def foot(
        self, start: str, on_line: str, end: str, along: Expression, across: Expression, beyond: bool
    ) -> tuple[Value, Value] | None:
        """The named legs of the right triangle that a perpendicular to a line makes; None where that has no letters.

        ``beyond`` tells that its foot is beyond the start, not on the side of the other point on the line.
        """

    def projections(
        self, ends: tuple[str, str], axis: AngleForm, along: Expression, across: Expression
    ) -> tuple[Value, Value] | None:
        """The named legs of a right triangle along and across a line of the figure; None where that has no letters."""

    def say_triangle(self, ends: tuple[str, str], first: Leg, shape: str) -> None:
        """Say of the triangle with a base between two points and a side from the first what shape it has, once."""

    def ahead_on(self, start: str, form: AngleForm) -> str:
        """A point that lies in a direction from another one, or nothing."""

    def is_nothing(self, length: Expression) -> bool:
        """Whether a length is zero but for rounding."""


def angle_of(geometry: Angular, form: AngleForm, extra: Sequence[Signed] = ()) -> Expression:
    """A sum of angles and of further terms as an expression between -180 and 180 degrees."""
    form = geometry.taken_apart(form)
    terms = [*_terms(geometry, form), *extra]
    total = form.constant + sum(sign * term.number(True) for sign, term in terms)
    return _sum_of(terms, form.constant + 360.0 * round((normal_angle(total) - total) / 360.0))


def _terms(geometry: Angular, form: AngleForm) -> list[Signed]:
    return [(1 if c > 0 else -1, _part(geometry.atom(atom), abs(c))) for atom, c in form.parts]


def _sum_of(terms: Sequence[Signed], constant: float) -> Expression:
    """Terms with a number of degrees, what is positive first."""
    constant = tidy(constant)
    if not terms:
        return Constant(constant, "angle")
    ordered = sorted(terms, key=lambda term: -term[0])
    if constant:
        own = (1 if constant > 0 else -1, Constant(abs(constant), "angle"))
        ordered = [own, *ordered] if constant > 0 else [*ordered, own]
    return ordered[0][1] if len(ordered) == 1 and ordered[0][0] > 0 else Total(tuple(ordered))


def _part(value: Expression, count: float) -> Expression:
    if count == 0.5:
        return Ratio(value, Constant(2.0))
    return value if count == 1 else Constant(count) * value


def reduced(geometry: Angular, function: str, form: AngleForm) -> tuple[int, Expression | None]:
    """A cosine or sine as a sign and the function of an acute or given angle; None stands for one, sign 0 for zero."""
    number = math.radians(geometry.number(form))
    value, other = (math.cos(number), math.sin(number))[:: 1 if function == "cos" else -1]
    if abs(value) < _NOTHING:
        return 0, None
    if abs(other) < _NOTHING:
        return (1 if value > 0 else -1), None
    sign, form = 1, geometry.taken_apart(form)
    if not form.parts and abs(size := normal_angle(form.constant)) > 90.0:  # of 20 degrees, not of 160
        sign, form = -1, AngleForm((), normal_angle(size - 180.0))
    quarter = round(form.constant / 90.0)
    if abs(form.constant - 90.0 * quarter) < 1e-9:
        function, sign = _QUARTERS[function][quarter % 4]
        form = AngleForm(form.parts)
    terms = _terms(geometry, form)
    if _is_backwards(form, terms):
        terms, form = [(-side, term) for side, term in terms], form.times(-1.0)
        sign = -sign if function == "sin" else sign
    whole = _sum_of(terms, form.constant)
    if whole.number(True) > _HALF_TURN and len(terms) > 1:  # of a sum such as 105 + 150 degrees that beyond 180
        return -sign, Applied(function, _sum_of(terms, form.constant - _HALF_TURN))
    return sign, Applied(function, whole)


def _is_backwards(form: AngleForm, terms: Sequence[Signed]) -> bool:
    """Whether the opposite angle is written more simply: without a minus before a single angle, else positive."""
    if len(terms) == 1 and not form.constant:
        return terms[0][0] < 0
    return form.constant + sum(side * term.number(True) for side, term in terms) < 0


def projected(geometry: Angular, function: str, legs: Iterable[Leg], axis: AngleForm) -> list[Signed]:
    """Projections of legs on an axis (``cos``) or on the one 90 degrees to its left (``sin``), without zeros."""
    found: list[Signed] = []
    for leg in legs:
        sign, factor = reduced(geometry, function, leg.form.minus(axis))
        if sign:
            found.append((sign, leg.length if factor is None else leg.length * factor))
    return found


def direction_of(geometry: Angular, legs: Sequence[Leg], ends: tuple[str, str]) -> Expression:
    """The direction of the sum of legs: that of a leg, turned by an angle of the triangle (arc tangent)."""
    axis = _axis_of(legs)
    ahead, along = positive(summed(projected(geometry, "cos", legs, axis)))
    left, across = positive(summed(projected(geometry, "sin", legs, axis)))
    if geometry.is_nothing(across):
        return angle_of(geometry, axis if ahead > 0 else axis.turned(180.0))
    if geometry.is_nothing(along):
        return angle_of(geometry, axis.turned(90.0 * left))
    if along == across:
        return angle_of(geometry, axis.turned(left * (45.0 if ahead > 0 else 135.0)))
    if len(legs) == 2 and _are_equal(*legs):
        return angle_of(geometry, legs[0].form.plus(_turn(geometry, legs), 0.5))
    start, end = ends
    if _has_foot_at_end(geometry, legs, ends):
        back = direction_of(geometry, [leg.reversed() for leg in reversed(legs)], (end, start))
        return angle_of(geometry, AngleForm((), _HALF_TURN), ((1, back),))
    foot = _foot(geometry, legs, ends)
    if ahead < 0 and foot is None:
        axis, left, ahead = axis.turned(180.0), -left, -ahead
    on_side = geometry.ahead_on(start, axis)
    corner: Expression = Applied("arctan", Ratio(across, along) if foot is None else Ratio(foot[1], foot[0]))
    if ahead < 0:  # the foot of the perpendicular is beyond the vertex
        corner = Constant(180.0, "angle") - corner
    named: Expression = corner
    if len(legs) == 2 and reduced(geometry, "cos", legs[1].form.minus(legs[0].form))[0] == 0:
        geometry.say_triangle(ends, legs[0], "triangle_right")
    if on_side:
        named = geometry.corner(start, on_side, end, corner)
    elif under := _foot_of(along, start):
        named = geometry.corner(start, end, under, corner)
    elif not axis.parts and axis.constant % 90.0 == 0:
        line = "horizontal" if axis.constant % 180.0 == 0 else "vertical"
        named = geometry.inclination(start, end, line, corner)
    return angle_of(geometry, axis, ((left, named),))


def _foot_of(leg: Expression, start: str) -> str:
    """The foot H of a perpendicular where a leg is AH from the start A; nothing for another length."""
    name = leg.name if isinstance(leg, Value) else None
    return name.about if name is not None and name.kind == "length" and name.of == start else ""


def _axis_of(legs: Sequence[Leg]) -> AngleForm:
    """The leg from which an angle of the triangle is counted: one along an axis of the paper, else the first."""
    return next((leg.form for leg in legs if not leg.form.parts), legs[0].form)


def _has_foot_at_end(geometry: Angular, legs: Sequence[Leg], ends: tuple[str, str]) -> bool:
    """Whether only at the end of a way a line of the figure carries the foot of a perpendicular, from its start."""
    if len(legs) != 2 or not legs[0].form.parts or legs[1].form.parts or geometry.ahead_on(ends[0], legs[1].form):
        return False
    return bool(geometry.ahead_on(ends[1], legs[1].form.turned(_HALF_TURN)))


def _foot(geometry: Angular, legs: Sequence[Leg], ends: tuple[str, str]) -> tuple[Value, Value] | None:
    """In a triangle of two sides and the angle between them the legs of the right triangle whose hypotenuse is the
    third side, by the perpendicular from the end to the line of the first; None in other triangles.
    """
    if _has_foot_at_end(geometry, legs, ends):
        legs, ends = [leg.reversed() for leg in reversed(legs)], ends[::-1]
    if len(legs) != 2 or not legs[1].form.parts:
        return None
    if reduced(geometry, "cos", legs[1].form.minus(legs[0].form))[0] == 0:  # the foot would be their common end
        return None
    axis = _axis_of(legs)
    ahead, along = positive(summed(projected(geometry, "cos", legs, axis)))
    _, across = positive(summed(projected(geometry, "sin", legs, axis)))
    oblique = isinstance(along, Total) and len(list(terms_of(across))) == 1
    on_side = geometry.ahead_on(ends[0], axis) if oblique else ""
    return geometry.foot(ends[0], on_side, ends[1], along, across, ahead < 0) if on_side else None


def right_triangle(geometry: Angular, legs: Sequence[Leg], ends: tuple[str, str]) -> list[Leg]:
    """The legs of the right triangle on a way of several segments: along one of them and across it, or one where the
    other is zero; nothing where the figure has no letters for them.
    """
    axis = _axis_of(legs)
    ahead, along = positive(summed(projected(geometry, "cos", legs, axis)))
    left, across = positive(summed(projected(geometry, "sin", legs, axis)))
    ways = (axis if ahead > 0 else axis.turned(180.0)), axis.turned(90.0 * left)
    if geometry.is_nothing(across):
        return [Leg(along, ways[0])]
    if geometry.is_nothing(along):
        return [Leg(across, ways[1])]
    found = geometry.projections(ends, axis, along, across)
    return [] if found is None else [Leg(leg, way) for leg, way in zip(found, ways, strict=True)]


def _are_equal(first: Leg, second: Leg) -> bool:
    """Whether two legs are the equal sides of an isosceles triangle."""
    one, other = first.length.number(True), second.length.number(True)
    return abs(one - other) <= _EQUAL * one


def _turn(geometry: Angular, legs: Sequence[Leg]) -> AngleForm:
    """The angle from the first of two legs to the second, between -180 and 180 degrees."""
    turn = legs[1].form.minus(legs[0].form)
    return turn.turned(geometry.number(turn) - geometry.total(turn))


def length_of(geometry: Angular, legs: Sequence[Leg], ends: tuple[str, str]) -> Expression:
    """The length of the sum of legs: law of Pythagoras, by a perpendicular where it takes one, or law of cosines."""
    if not legs:
        return Constant(0.0)
    if len(legs) == 1:
        return legs[0].length
    if len(legs) > 2:
        axis = _axis_of(legs)
        sides = [summed(projected(geometry, function, legs, axis)) for function in ("cos", "sin")]
        kept = [side for side in sides if not geometry.is_nothing(side)]
        return SquareRoot(squared(kept)) if len(kept) > 1 else positive(kept[0])[1]
    first, second = (leg.length for leg in legs)
    turn = legs[1].form.minus(legs[0].form)
    sign, cosine = reduced(geometry, "cos", turn)
    if sign and cosine is None:  # an angle with which they happen to lie on one line
        return positive(summed(((1, first), (sign, second))))[1]
    if _are_equal(*legs):
        geometry.say_triangle(ends, legs[0], "triangle_half_square" if cosine is None else "triangle_isosceles")
        if cosine is None:
            return SquareRoot(Constant(2.0)) * first
        half = reduced(geometry, "cos", _turn(geometry, legs).times(0.5))[1]
        return Constant(2.0) * first * half if half is not None else Constant(2.0) * first
    squares = squared((first, second))
    if cosine is None:
        geometry.say_triangle(ends, legs[0], "triangle_right")
        return SquareRoot(squares)
    foot = _foot(geometry, legs, ends)
    if foot is not None:
        return SquareRoot(squared(foot))
    return SquareRoot(summed(((1, squares), (sign, Constant(2.0) * first * second * cosine))))


def by_height(base: Value, own: Value, opposite: Value, known: Value) -> Expression:
    """The angle at one end of the base of a triangle by the ``known`` one at its other end.

    The height on the base is a leg of two right triangles, with the side ``opposite`` the wanted angle and with its
    ``own`` one.
    """
    height, beyond = opposite * sin(known), opposite * cos(known)
    ahead = base.exact - beyond.number(True)
    if ahead > _SHARP * own.exact:
        return Applied("arcsin", Ratio(height, own))
    if ahead > 0:
        return Applied("arctan", Ratio(height, base - beyond))
    return Constant(180.0, "angle") - Applied("arctan", Ratio(height, beyond - base))
