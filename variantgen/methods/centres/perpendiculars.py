"""The velocity centre by the directions of two velocities: ways (b) and (d) of the guide, 3.1.4.

The perpendiculars to the velocities at A and B meet in the centre P; the triangle A B P gives AP and BP. Where the
velocities are parallel, and not across AB, the centre is at infinity: the body is in translation at the instant.
"""

from __future__ import annotations

import cmath
import math

from variantgen.algebra.expression import Constant, Value
from variantgen.algebra.name import Name
from variantgen.methods.centres import guide_triangle, pivot_triangle
from variantgen.methods.centres.centre import is_angle, is_near, named_place, note_angle, own_angle
from variantgen.methods.centres.triangle_shapes import say_shape, shapes
from variantgen.methods.geometry.angle_sums import angle_sum, difference, is_short
from variantgen.methods.geometry.geometry import Geometry, between, normal_angle
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.rays import Centre, CentreRay
from variantgen.methods.steps.step import Body, Fact, Point, Segment, Term, VectorOf

_PARALLEL = 1e-7  # degrees between two perpendiculars within which they never meet


def meet(book: Book, body: str, first: Term, second: Term) -> Centre:
    """Ways (b) and (d): the centre by the directions of two velocities; that of ``second`` may be an assumed one.

    Raises ArithmeticError where both are across the line of their points: it takes their magnitudes then.
    """
    a, b = first.point, second.point
    facts = facts_of_two(body, first, second)
    if are_parallel(first, second):
        if is_across(book, first, b):
            raise ArithmeticError(f"the directions of the velocities of {a} and {b} do not tell where the centre is")
        book.say("perpendiculars.infinite", False, **facts)
        return Centre(body, infinite=True)
    normals = [1j * _unit(term) for term in (first, second)]
    shares = _crossing(book.geometry.vector(a, b), normals[0], normals[1])
    place = book.task.now.z[a] + shares[0] * normals[0]
    at = b if is_near(book, place, book.task.now.z[b]) else named_place(book, place)
    centre = Centre(body, at=at)
    if at:
        book.say("perpendiculars.meet_at_point", False, at=Point(at), **facts)
        for point in (point for point in (a, b) if point != at):
            centre.rays[point] = CentreRay(book.geometry.length(point, at), book.geometry.direction(point, at))
        return centre
    book.say("perpendiculars.meet" if first.size is not None else "perpendiculars.meet_two", False, **facts)
    to_a, to_b = (perpendicular(book, t, s * n) for t, s, n in zip((first, second), shares, normals, strict=True))
    _solve_triangle(book, centre, (first, second), (to_a, to_b), place)
    return centre


def are_parallel(first: Term, second: Term) -> bool:
    """Whether two vectors have one direction or opposite ones."""
    angle = between(first.angle.exact, second.angle.exact)
    return min(angle, 180.0 - angle) < _PARALLEL


def is_across(book: Book, term: Term, other: str) -> bool:
    """Whether a vector of a point is across the line from it to another point."""
    line = book.geometry.vector(term.point, other)
    return is_angle(between(term.angle.exact, math.degrees(cmath.phase(line))), 90.0)


def _crossing(side: complex, first: complex, second: complex) -> tuple[float, float]:
    """How far along two lines their crossing is: from A along ``first``, from B = A + ``side`` along ``second``."""
    across = _cross(first, second)
    return _cross(side, second) / across, _cross(side, first) / across


def _cross(first: complex, second: complex) -> float:
    return (first.conjugate() * second).imag


def _unit(term: Term) -> complex:
    return cmath.rect(1.0, math.radians(term.angle.exact))


def facts_of_two(body: str, first: Term, second: Term) -> dict[str, Fact]:
    """What the sentences about two velocities need."""
    a, b = first.point, second.point
    centre = Centre(body)
    facts: dict[str, Fact] = {"body": Body(body), "centre": centre.fact, "segment": Segment(a, b)}
    facts["omega"] = Name("omega", body)
    facts |= {"point": Point(a), "vector": VectorOf(Name("v", a)), "way": first.way, "ray": centre.segment(a)}
    other: dict[str, Fact] = {"other": Point(b), "other_vector": VectorOf(Name("v", b))}
    return facts | other | {"other_way": second.way, "other_ray": centre.segment(b)}


def perpendicular(book: Book, term: Term, towards: complex) -> Value:
    """The direction of the perpendicular to a vector from its point, to the side of ``towards``.

    Where the vector is known to be across a segment, the perpendicular is that segment.
    """
    side = math.degrees(cmath.phase(towards))
    segment = term.way.facts.get("segment") if term.way.key == "ways.across" else None
    line: Value
    if isinstance(segment, Segment) and not segment.centre_of:
        ends = (segment.start, segment.end)
        ahead = math.degrees(cmath.phase(book.geometry.vector(*ends)))
        return book.geometry.direction(*(ends if between(ahead, side) < 90.0 else ends[::-1]))
    if isinstance(segment, Segment):
        line = book.centres[segment.end, segment.centre_of].rays[segment.start].angle
        return line if between(line.exact, side) < 90.0 else Geometry.turned(line, 180.0)
    left = between(normal_angle(term.angle.exact + 90.0), side) < 90.0
    return Geometry.turned(term.angle, 90.0 if left else -90.0)


# The triangle A B P of way (b).


def _solve_triangle(
    book: Book, centre: Centre, terms: tuple[Term, Term], rays: tuple[Value, Value], place: complex
) -> None:
    """The sides AP and BP from AB and the angles at A and B, or by the fixed pivots of links where that is shorter."""
    a, b = ends = terms[0].point, terms[1].point
    geometry = book.geometry
    side = geometry.length(a, b)
    ways = geometry.direction(a, b), geometry.direction(b, a)
    at_a = own_angle(difference(centre.corner(a, b), rays[0], ways[0]))
    at_b = own_angle(difference(centre.corner(b, a), rays[1], ways[1]))
    at_p = own_angle(difference(centre.vertex(a, b), *rays))
    if not is_short(angle_sum(at_p)):
        rest = Constant(180.0, "angle") - at_a - at_b
        at_p = Value(at_p.name, "angle", rest.number(True), rest)
    angles = (at_a, at_b, at_p)
    shape, needed, arms = next(case for case in shapes(side, *angles) if case[0])
    if shape == "by_sines" and pivot_triangle.solve(book, centre, terms, rays, place):
        return
    if shape == "by_sines" and guide_triangle.solve(book, centre, terms, rays):
        return
    say_shape(book, centre, shape, ends)
    for angle in needed:
        note_angle(book, angle)
    first = book.derive(centre.length(a), "length", arms[0])
    equal = shape == "isosceles"
    second = book.derive(centre.length(b), "length", first if equal else arms[1])
    centre.rays |= {a: CentreRay(first, rays[0]), b: CentreRay(second, rays[1])}
