"""Triangles with a side and the angles at it: right, isosceles, equilateral ones are noticed first, then sines."""

from __future__ import annotations

from collections.abc import Iterator

from variantgen.algebra.expression import Applied, Constant, Expression, Value, cos, sin
from variantgen.methods.centres.centre import is_angle
from variantgen.methods.geometry.angle_sums import angle_sum, is_single, supplement
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.rays import Centre
from variantgen.methods.steps.step import Fact, Point, Segment, triangle

Shape = tuple[str, tuple[Value, ...], tuple[Expression, Expression]]


def shapes(side: Value, at_a: Value, at_b: Value, at_p: Value) -> Iterator[Shape]:
    """Shapes of the triangle, the simplest first: its name ("" where it is not that), the angles to show, AP and BP."""
    equal = is_angle(at_a.exact, at_b.exact)
    two = Constant(2.0)

    def case(holds: bool, name: str, angles: tuple[Value, ...], ap: Expression, bp: Expression) -> Shape:
        return (name if holds else "", angles, (ap, bp))

    yield case(equal and is_angle(at_a.exact, 60.0), "equilateral", (at_a, at_b), side, side)
    square = is_angle(at_p.exact, 90.0)
    yield case(square and _is_known(at_b), "right_at_centre", (), side * sin(at_b), side * cos(at_b))
    yield case(square, "right_at_centre", (at_a,), side * cos(at_a), side * sin(at_a))
    yield case(is_angle(at_a.exact, 90.0), "right_at_point", (at_b,), side * Applied("tan", at_b), side / cos(at_b))
    yield case(is_angle(at_b.exact, 90.0), "right_at_other", (at_a,), side / cos(at_a), side * Applied("tan", at_a))
    leg = side / (two * cos(at_a))
    yield case(equal, "isosceles", (at_a, at_b), leg, leg)
    sines = [sin(supplement(angle) or angle) for angle in (at_a, at_b, at_p)]
    by_sines = (side * sines[1] / sines[2], side * sines[0] / sines[2])
    yield case(True, "by_sines", (at_a, at_b, at_p), *by_sines)


def _is_known(angle: Value) -> bool:
    """Whether an angle is a given one, or one that has been found before."""
    return is_single(angle_sum(angle)) and bool(angle_sum(angle).parts)


def say_shape(book: Book, centre: Centre, shape: str, ends: tuple[str, str]) -> None:
    """Name the triangle of two points and the velocity centre, and what is special about it."""
    a, b = ends
    facts: dict[str, Fact] = {"triangle": triangle(a, b, centre.kind, centre.body), "segment": Segment(a, b)}
    book.say(f"perpendiculars.{shape}", True, point=Point(a), other=Point(b), centre=centre.fact, **facts)
