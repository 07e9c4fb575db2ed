"""Accelerations by the acceleration centre Q of a body (guide, 3.2.3, formulas 70-72).

Q has no acceleration. The acceleration of A, turned by the angle mu in the sense of epsilon, leads from A to Q::

    tan mu = |epsilon| / omega^2,   AQ = a_A / sqrt(epsilon^2 + omega^4),   a_B = BQ sqrt(epsilon^2 + omega^4)
"""

from __future__ import annotations

import math

from variantgen.algebra.expression import Applied, Constant, Expression, Ratio, SquareRoot, Value
from variantgen.algebra.name import Name
from variantgen.methods.centres.centre import named_place, ray_to_centre, turned_by
from variantgen.methods.groups.carriers import is_translating
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.rays import Centre, CentreRay
from variantgen.methods.steps.step import Body, Fact, Point, Sentence, Term, VectorOf
from variantgen.methods.vectors.points import known_point, renamed, vector
from variantgen.methods.vectors.whole_vector import whole


def carry(book: Book, point: str, body: str, pole: str) -> None:
    """Write down the acceleration of a further point of a body whose motion is known: ``a_B = BQ sqrt(...)``."""
    name = Name("a", point)
    vector(book, pole)
    if ("Q", body) not in book.centres:
        with book.step("acceleration_centre.centre", "acceleration_centre", body=Body(body)):
            centre_of(book, body, pole)
    with book.step("acceleration_centre.point", "acceleration_centre", body=Body(body), point=Point(point)):
        centre = centre_of(book, body, pole)
        facts: dict[str, Fact] = {"point": Point(point), "centre": centre.fact, "vector": VectorOf(name)}
        if centre.infinite:
            second = VectorOf(Name("a", pole))
            book.say("acceleration_centre.same", False, first=VectorOf(name), second=second, body=Body(body))
            book.acceleration[point] = renamed(book, vector(book, pole), point)
            return
        ray = ray_to_centre(book, centre, point, _is_direction_asked(book, point))
        if ray is None:
            book.say("acceleration_centre.in_centre", False, **facts)
            book.acceleration[point] = ()
            return
        size = book.derive(name, "acceleration", ray.arm * _intensity(book, body))
        book.acceleration[point] = (_term(book, centre, point, ray, size),)


def _is_direction_asked(book: Book, point: str) -> bool:
    return any(q.point == point and q.kind == "a" and q.component for q in book.task.sought)


def _term(book: Book, centre: Centre, point: str, ray: CentreRay, size: Value) -> Term:
    """The acceleration, at the angle mu to the ray: the ray is the acceleration turned in the sense of epsilon."""
    sense = book.epsilon[centre.body].sense
    name = Name("a", point)
    facts: dict[str, Fact] = {"vector": VectorOf(name), "ray": centre.segment(point), "centre": centre.fact}
    if not sense:
        book.say("acceleration_centre.along", True, **facts)
        way = Sentence("acceleration_centre.way_towards", {"start": Point(point), **facts})
        return Term(name, size, ray.angle, way)
    slope = angle(book, centre.body)
    book.say("acceleration_centre.direction", True, angle=slope, **facts)
    turned = turned_by(Name("heading", point, body="a"), ray.angle, -sense, slope)
    return Term(name, size, turned, Sentence("acceleration_centre.way_turned", {"angle": slope, **facts}))


def centre_of(book: Book, body: str, pole: str) -> Centre:
    """The acceleration centre of a body whose rates and point ``pole`` are known; found now if it is not yet."""
    key = ("Q", body)
    if key not in book.centres:
        book.centres[key] = _found(book, body, pole)
    return book.centres[key]


def _found(book: Book, body: str, pole: str) -> Centre:
    """Turn the acceleration of the pole by mu in the sense of epsilon, and lay off AQ."""
    centre = Centre(body, "Q")
    known = book.acceleration[pole]
    facts: dict[str, Fact] = {"body": Body(body), "centre": centre.fact, "pole": Point(pole)}
    if is_translating(book, body) or not (book.omega[body].sense or book.epsilon[body].sense):
        book.say("acceleration_centre.infinite", False, **facts)
        centre.infinite = True
        return centre
    if not known:
        book.say("acceleration_centre.at_rest", False, **facts)
        centre.at = pole
        return centre
    facts |= {"vector": VectorOf(Name("a", pole)), "ray": centre.segment(pole)}
    term = whole(book, pole, known)
    rate = book.epsilon[body]
    book.say("acceleration_centre.definition", True, **facts)
    slope = angle(book, body)
    if rate.sense:
        book.say(f"acceleration_centre.turned_{rate.word}", False, angle=slope, **facts)
        ahead = turned_by(centre.direction(pole), term.angle, rate.sense, slope)
    else:
        book.say("acceleration_centre.ahead", False, **facts)
        ahead = term.angle
    assert term.size is not None
    arm = book.derive(centre.length(pole), "length", term.size / _intensity(book, body))
    centre.rays[pole] = CentreRay(arm, ahead)
    centre.at = named_place(book, centre.place(book.task))
    if centre.at:
        book.say("acceleration_centre.named", True, at=Point(centre.at), **facts)
    return centre


def angle(book: Book, body: str) -> Value:
    """The angle mu between accelerations and rays to the centre, 0 to 90 degrees; shown once."""
    name = Name("mu", body)
    if name in book.values:
        return book.values[name]
    omega, epsilon = book.omega[body], book.epsilon[body]
    expression: Expression
    if not epsilon.sense:
        expression = Constant(0.0, "angle")
    elif not omega.sense:
        expression = Constant(90.0, "angle")
    else:
        expression = Applied("arctan", Ratio(epsilon.size, omega.size**2))
    return book.derive(name, "angle", expression)


def _intensity(book: Book, body: str) -> Expression:
    """``sqrt(epsilon^2 + omega^4)``, without what is zero."""
    omega, epsilon = book.omega[body], book.epsilon[body]
    if not epsilon.sense:
        return omega.size**2
    return SquareRoot(epsilon.size**2 + omega.size**4) if omega.sense else epsilon.size


def distance(book: Book, body: str, point: str) -> Value:
    """The asked distance of a point from the acceleration centre; infinite where there is none."""
    pole = known_point(book, body)
    with book.step("acceleration_centre.distance", "acceleration_centre", body=Body(body), point=Point(point)):
        centre = centre_of(book, body, pole)
        if centre.infinite:
            return Value(centre.length(point), "length", math.inf)
        ray = ray_to_centre(book, centre, point, False)
        return Value(centre.length(point), "length", 0.0) if ray is None else ray.arm


def asked_angle(book: Book, body: str) -> Value:
    """The asked angle mu, in a step of its own if it has not been found on the way."""
    if Name("mu", body) in book.values:
        return book.values[Name("mu", body)]
    with book.step("acceleration_centre.angle", "acceleration_centre", body=Body(body)):
        if is_translating(book, body):
            book.say("acceleration_centre.infinite", False, body=Body(body), centre=Centre(body, "Q").fact)
            return Value(Name("mu", body), "angle", 0.0)
        return angle(book, body)
