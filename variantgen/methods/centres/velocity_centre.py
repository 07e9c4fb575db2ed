"""Velocities by the velocity centre P of a body: ``omega = v_A / AP``, ``v_B = omega BP`` (guide, 3.1.4, 61 and 62)."""

from __future__ import annotations

import math

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.methods.centres.centre import ray_to_centre
from variantgen.methods.centres.known_centre import centre_of, is_near_centre, sense_about
from variantgen.methods.centres.perpendiculars import meet
from variantgen.methods.geometry.geometry import Geometry, between
from variantgen.methods.groups.group import Dyad
from variantgen.methods.groups.wanted import is_rate_wanted, leads_on
from variantgen.methods.solution.book import Book, Rate, resultant
from variantgen.methods.solution.rays import Centre
from variantgen.methods.steps.step import Body, Fact, Point, Term, VectorOf
from variantgen.methods.vectors.point_paths import on_path
from variantgen.methods.vectors.points import carry_by_sum, known_point, positive, renamed, vector
from variantgen.methods.vectors.pole import solve_dyad as solve_by_equation
from variantgen.methods.vectors.turning_speed import is_same, turning_speed
from variantgen.methods.vectors.whole_vector import whole

_SQUARE = 1e-9  # cosine of an angle that is a right one, but for rounding
_FAR = 4.0  # of the distance AB: of a centre beyond that the triangle ABP is a thin one, with some 14 degrees at P
# Of the largest distance of A, B and P: as near the letter P and the symbol of a hinge cover each other; and where P is
# the hinge itself, but for rounding.
_BESIDE, _SAME = 0.07, 1e-6
_TRANSLATION = 1e-9  # of the largest velocity: a body that turns less is in translation


def applies(book: Book, group: Dyad) -> bool:
    """Whether the directions of two velocities tell where the centre is: not if both are across their line."""
    known = vector(book, group.pole)
    now, point = book.task.now, group.point_path.point
    side = now.z[point] - now.z[group.pole]
    path = group.point_path.line if group.point_path.straight else 1j * (now.z[point] - now.z[group.point_path.centre])
    return book.order == 1 and not (_are_square(side, path) and known and _are_square(side, resultant(known)))


def _are_square(first: complex, second: complex) -> bool:
    """Whether two vectors are across each other, but for rounding."""
    return abs((first.conjugate() * second).real) <= _SQUARE * abs(first) * abs(second)


def solve_dyad(book: Book, group: Dyad) -> None:
    """Find the velocity of the point on its path and the angular velocity of the body.

    Unless the centre is wished, the velocities are projected on AB where it would serve the velocity of B alone, which
    is one line, and a vector equation takes its place where it is remote (no thin triangle, no long way off the page)
    or so near to a hinge that no figure could show both.
    """
    body, pole, point = group.body, group.pole, group.point_path.point
    vector(book, pole)
    if book.style.is_free and not is_rate_wanted(book.task, 1, body, {point, pole}):
        from variantgen.methods.centres import projections  # loaded only where it takes the centre's place

        if projections.applies(book, group):
            projections.solve_dyad(book, group)
            return
    elif book.style.is_free and (_is_remote(book, group) or _is_beside_hinge(book, group)):
        solve_by_equation(book, group)
        return
    with book.step("velocity_centre.link", "velocity_centre", body=Body(body), point=Point(point)):
        _, path = on_path(book, group.point_path)
        if find(book, group, path) is not None:
            _enter_speed(book, body, point, path)


def _is_remote(book: Book, group: Dyad) -> bool:
    """Whether the body turns, but about a centre that is far from its points A and B."""
    now, pole, point = book.task.now, group.pole, group.point_path.point
    turning = abs(book.exact_rate(group.body) * (now.z[point] - now.z[pole]))
    fastest = max(abs(now.v[pole]), abs(now.v[point]))
    return _TRANSLATION * fastest < turning < fastest / _FAR


def _is_beside_hinge(book: Book, group: Dyad) -> bool:
    """Whether the centre is beside a point of the body, or of one that is joined to it, but not in it."""
    now, pole = book.task.now, group.pole
    rate, fastest = book.exact_rate(group.body), max(map(abs, now.v.values()))
    ends = [now.z[pole], now.z[group.point_path.point]]
    if abs(rate * (ends[1] - ends[0])) <= _TRANSLATION * fastest:
        return False
    centre = now.z[pole] + 1j * now.v[pole] / rate
    size = max(abs(ends[1] - ends[0]), *(abs(end - centre) for end in ends))
    members = {*now.scene.bodies[group.body]}
    shown = members.union(*(points for points in now.scene.bodies.values() if members & {*points}))
    places = (now.z[name] for name in shown.difference(book.task.form.figure.hidden))
    return any(_SAME * size < abs(place - centre) < _BESIDE * size for place in places)


def find(book: Book, group: Dyad, path: Term) -> Rate | None:
    """Find the centre of the body and its angular velocity; None where the body is at rest, and its points are."""
    body, pole, point = group.body, group.pole, group.point_path.point
    known = book.velocity[pole]
    if not known:
        book.say("velocity_centre.at_rest", False, pole=Point(pole), point=Point(point), body=Body(body))
        book.omega[body] = _no_rotation(body)
        book.velocity[point] = ()
        book.centres["P", body] = Centre(body, at=pole)
        return None
    first = whole(book, pole, known)
    centre = meet(book, body, first, path)
    book.centres[centre.key] = centre
    book.omega[body] = _no_rotation(body) if centre.infinite else _turning(book, centre, pole, first)
    return book.omega[body]


def _no_rotation(body: str) -> Rate:
    return Rate(Value(Name("omega", body), "angular velocity", 0.0), 0)


def _turning(book: Book, centre: Centre, pole: str, first: Term) -> Rate:
    """``omega = v_A / AP``, in the sense in which A turns about P."""
    ray = centre.rays[pole]
    assert first.size is not None
    omega = book.derive(Name("omega", centre.body), "angular velocity", first.size / ray.arm)
    rate = Rate(omega, sense_about(ray, first))
    vector_fact = VectorOf(Name("v", pole))
    book.say(f"velocity_centre.{rate.word}", False, body=Body(centre.body), centre=centre.fact, vector=vector_fact)
    return rate


def _enter_speed(book: Book, body: str, point: str, path: Term) -> None:
    """The velocity of the point on its path: ``v_B = omega BP``, along the path in the sense of the rotation."""
    centre, rate = book.centres["P", body], book.omega[body]
    name = Name("v", point)
    if centre.infinite:
        pole = next(p for p in book.task.scene.bodies[body] if p in book.velocity)
        first = whole(book, pole, book.velocity[pole])
        book.say("velocity_centre.same", False, first=VectorOf(name), second=VectorOf(Name("v", pole)), body=Body(body))
        assert first.size is not None
        size, ahead = book.derive(name, "velocity", first.size), first.angle.exact
    elif point not in centre.rays:
        book.say("velocity_centre.in_centre", False, point=Point(point), centre=centre.fact, vector=VectorOf(name))
        book.velocity[point] = ()
        return
    else:
        ray = centre.rays[point]
        _say_direction(book, centre, rate, point)
        size, ahead = (
            _speed(book, centre, rate, point),
            ray.angle.exact - 90.0 * rate.sense,
        )
    angle = path.angle if between(path.angle.exact, ahead) < 90.0 else Geometry.turned(path.angle, 180.0)
    book.velocity[point] = (Term(name, size, angle, path.way),)


def _speed(book: Book, centre: Centre, rate: Rate, point: str) -> Value:
    """``v_C = omega CP``, or the speed of another point at the same distance."""
    name, arm = Name("v", point), centre.rays[point].arm
    for other, ray in centre.rays.items():
        known = book.velocity.get(other, ())
        if other != point and len(known) == 1 and known[0].size is not None and is_same(ray.arm.exact, arm.exact):
            return book.derive(name, "velocity", positive(known[0].size), law=rate.size * arm)
    return turning_speed(book, name, rate.size, arm)


def _say_direction(book: Book, centre: Centre, rate: Rate, point: str) -> None:
    facts: dict[str, Fact] = {"vector": VectorOf(Name("v", point)), "ray": centre.segment(point)}
    book.say(f"velocity_centre.direction_{rate.word}", True, **facts)


def carry(book: Book, point: str, body: str, pole: str) -> None:
    """Write down the velocity of a further point of a body whose motion is known: ``v_C = omega CP``.

    Where the distance to the centre takes a law of cosines, or the centre must be found first, two velocities are added
    instead, unless the centre is wished.
    """
    name = Name("v", point)
    vector(book, pole)
    strict = book.style.strict and book.style.velocities == "velocity_centre"
    if not strict and not is_near_centre(book, body, point):
        carry_by_sum(book, point, body, pole)
        return
    with book.step("velocity_centre.point", "velocity_centre", body=Body(body), point=Point(point)):
        centre, rate = centre_of(book, body), book.omega[body]
        if centre.infinite:
            book.say(
                "velocity_centre.same", False, first=VectorOf(name), second=VectorOf(Name("v", pole)), body=Body(body)
            )
            book.velocity[point] = renamed(book, vector(book, pole), point)
            return
        ray = ray_to_centre(book, centre, point, leads_on(book.task, point, body))
        if ray is None or not rate.sense:
            book.say("velocity_centre.in_centre", False, point=Point(point), centre=centre.fact, vector=VectorOf(name))
            book.velocity[point] = ()
            return
        _say_direction(book, centre, rate, point)
        size = _speed(book, centre, rate, point)
        angle = Geometry.turned(ray.angle, -90.0 * rate.sense)
        book.velocity[point] = (book.term(name, size, angle, "across", segment=centre.segment(point)),)


def distance(book: Book, body: str, point: str) -> Value:
    """The asked distance of a point from the velocity centre; infinite where the body is in translation."""
    known_point(book, body)
    with book.step("velocity_centre.distance", "velocity_centre", body=Body(body), point=Point(point)):
        centre = centre_of(book, body)
        if centre.infinite:
            return Value(centre.length(point), "length", math.inf)
        ray = ray_to_centre(book, centre, point, False)
        return Value(centre.length(point), "length", 0.0) if ray is None else ray.arm
