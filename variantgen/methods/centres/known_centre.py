"""The velocity centre of a body of which velocities are known: ways (a) and (c) of the guide, 3.1.4, and by omega.

(a) A wheel rolls without slip on something at rest: the contact is the centre. (c) Two velocities are parallel, and
across the line of their points: the centre divides that line in the ratio of the velocities. Where one velocity and
omega are known, the centre lies on the perpendicular to the velocity, at the distance ``v / omega``.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.mechanism.rows import Placement
from variantgen.methods.centres.centre import is_simple, named_place
from variantgen.methods.centres.perpendiculars import facts_of_two, perpendicular
from variantgen.methods.geometry.geometry import Geometry, between, normal_angle
from variantgen.methods.groups.carriers import is_translating
from variantgen.methods.groups.contact import place_of, resting_letter
from variantgen.methods.groups.contacts_of_scene import contacts_of_scene
from variantgen.methods.groups.group import TwoPointBody
from variantgen.methods.groups.wanted import is_rate_wanted
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.book import Book, Rate
from variantgen.methods.solution.rays import Centre, CentreRay
from variantgen.methods.steps.step import Body, Fact, Point, Term, VectorOf
from variantgen.methods.vectors.points import vector
from variantgen.methods.vectors.whole_vector import whole

# Sentences that say already which point is the centre.
_TELLING = ("contact.by_rest_v", "gears.rest_v", "rolling.omega", "rested.pole_v")
_SAME = 1e-9  # relative difference within which two numbers are one, but for rounding


def centre_of(book: Book, body: str) -> Centre:
    """The velocity centre of a body whose motion is known; found now, with the lines that say how, if it is not yet."""
    key = ("P", body)
    if key not in book.centres:
        book.centres[key] = _found(book, body)
    return book.centres[key]


def is_near_centre(book: Book, body: str, point: str) -> bool:
    """Whether a point of a body is one simple triangle away from a velocity centre that needs no search.

    The centre is known, or it is a point at rest or the contact of a wheel; the triangle is right-angled, isosceles or
    equilateral, or the points lie on one line.
    """
    rate = book.omega.get(body)
    if book.task.linkage.pivot(body) is not None or is_translating(book, body) or rate is None or not rate.sense:
        return True
    centre = book.centres.get(("P", body))
    if centre is not None:
        return is_simple(book, centre, point)
    if any(p in book.velocity and not book.velocity[p] for p in book.task.scene.bodies[body]):
        return True
    explained = any(book.has_said(key, body=Body(body)) for key in _TELLING)
    for axle, place in resting_contacts(book.task, body, explained):
        if book.velocity.get(axle):
            arm, angle = abs(place - book.task.now.z[axle]), cmath.phase(place - book.task.now.z[axle])
            ray = CentreRay(Value(None, "length", arm), Value(None, "angle", math.degrees(angle)))
            return is_simple(book, Centre(body, at=named_place(book, place), rays={axle: ray}), point)
    return False


def _found(book: Book, body: str) -> Centre:
    rate = book.omega.get(body)
    members = book.task.scene.bodies[body]
    facts: dict[str, Fact] = {"body": Body(body), "centre": Centre(body).fact}
    pivot = book.task.linkage.pivot(body)
    if pivot is not None:
        book.say("known_centre.pivot", False, at=Point(pivot), **facts)
        return Centre(body, at=pivot)
    if is_translating(book, body) or (rate is not None and not rate.sense):
        book.say("known_centre.no_rotation", False, **facts)
        return Centre(body, infinite=True)
    if rate is None:
        raise LookupError(f"the rotation of {body}")
    known = [p for p in members if p in book.velocity]
    resting = next((p for p in known if not book.velocity[p]), None)
    if resting is not None:
        book.say("known_centre.at_rest", False, at=Point(resting), **facts)
        return Centre(body, at=resting)
    return _contact(book, body) or _by_rate(book, body, known[0], rate)


# Way (a).


def _contact(book: Book, body: str) -> Centre | None:
    """The contact of a wheel of known motion with something at rest; None where there is none."""
    task = book.task
    explained = any(book.has_said(key, body=Body(body)) for key in _TELLING)
    for axle, place in resting_contacts(task, body, explained):
        if not book.velocity.get(axle):
            continue
        name = named_place(book, place)
        centre = Centre(body, at=name)
        facts: dict[str, Fact] = {"body": Body(body), "centre": centre.fact}
        if not explained:
            named: dict[str, Fact] = {"at": Point(name)} if name else {}
            book.say("known_centre.named_contact" if name else "known_centre.contact", False, **named, **facts)
        if name:
            centre.rays[axle] = CentreRay(book.geometry.length(axle, name), book.geometry.direction(axle, name))
        else:
            ahead = perpendicular(book, whole(book, axle, book.velocity[axle]), place - task.now.z[axle])
            centre.rays[axle] = CentreRay(_radius(book, body, axle, abs(place - task.now.z[axle])), ahead)
        return centre
    return None


def contact_fact(book: Book, body: str) -> Fact:
    """The contact of a wheel with something at rest in a sentence: a point of the figure, or the velocity centre."""
    place = next((place for _, place in resting_contacts(book.task, body, False)), None)
    name = "" if place is None else named_place(book, place)
    return Point(resting_letter(book.task, body, name)) if name else Centre(body).fact


def resting_contacts(task: Task, body: str, explained: bool) -> Iterator[tuple[str, complex]]:
    """Centres and places of the contacts of a body with something at rest; tied threads only if ``explained``."""
    metre = task.length_unit
    at = Placement({name: place * metre for name, place in task.now.z.items()}, task.scene.frame)
    for joint in task.scene.joints:
        contact = joint.contact_at(at)
        if contact is not None and contact.other is None and contact.body[0] == body:
            yield contact.body[1], complex(contact.place) / metre
    for thread in contacts_of_scene(task).values() if explained else ():
        for known, side in thread.ways:
            if known.is_rest and side.lever and side.body == body:
                yield side.centre, place_of(task, side)


def _radius(book: Book, body: str, axle: str, exact: float) -> Value:
    """The radius of a wheel, as the drawing of its disc has it; of an undrawn one its own symbol."""
    drawn = book.task.drawn_radius(body, axle, exact)
    if isinstance(drawn, Value):
        return drawn
    return book.geometry.unnamed_radii.of(body, exact)


# By one velocity and omega.


def _by_rate(book: Book, body: str, point: str, rate: Rate) -> Centre:
    """``AP = v_A / omega``, on the perpendicular to the velocity on its left if the body turns counter-clockwise."""
    term = whole(book, point, book.velocity[point])
    assert term.size is not None
    centre = Centre(body)
    facts: dict[str, Fact] = {"body": Body(body), "centre": centre.fact, "point": Point(point)}
    book.say("known_centre.by_rate", False, vector=VectorOf(Name("v", point)), ray=centre.segment(point), **facts)
    side = cmath.rect(1.0, math.radians(term.angle.exact + 90.0 * rate.sense))
    ahead = perpendicular(book, term, side)
    centre.rays[point] = CentreRay(book.derive(centre.length(point), "length", term.size / rate.size), ahead)
    return centre


# Way (c).


def is_divided(book: Book, group: TwoPointBody) -> bool:
    """Whether both known velocities are across the line of their points, so that the centre divides it."""
    arm = book.geometry.vector(group.pole, group.point)
    speeds = [book.task.now.v[point] for point in (group.pole, group.point)]
    limit = _SAME * abs(arm) * max(abs(v) for v in speeds)
    return all(abs((arm.conjugate() * v).real) <= limit for v in speeds)


def solve_divided(book: Book, group: TwoPointBody) -> None:
    """The rate of a body from two known velocities across the line of their points."""
    for point in (group.pole, group.point):
        vector(book, point)
    if is_rate_wanted(book.task, 1, group.body, {group.pole, group.point}):
        facts: dict[str, Fact] = {"body": Body(group.body), "point": Point(group.point), "pole": Point(group.pole)}
        with book.step("known_points.v", "velocity_centre", **facts):
            divide(book, group.body, group.pole, group.point)


def divide(book: Book, body: str, first: str, second: str) -> Rate:
    """Find the centre and omega from two known velocities that are parallel, and across the line of their points.

    With one sense ``omega = (v_A - v_B) / AB`` for the faster A, with opposite ones ``(v_A + v_B) / AB``; then
    ``AP = v_A / omega``. Equal velocities of one sense mean translation at the instant; a point at rest
    is the centre itself.
    """
    ends = (first, second) if book.velocity[first] else (second, first)
    if not book.velocity[ends[1]]:
        return _about_end(book, body, *ends)
    terms = [whole(book, point, book.velocity[point]) for point in ends]
    sizes = [term.size for term in terms if term.size is not None]
    facts = facts_of_two(body, terms[0], terms[1])
    same = between(terms[0].angle.exact, terms[1].angle.exact) < 90.0
    if same and abs(sizes[0].exact - sizes[1].exact) <= _SAME * sizes[0].exact:
        book.say("known_centre.equal", False, **facts)
        book.centres["P", body] = Centre(body, infinite=True)
        return _entered(book, body, Rate(Value(Name("omega", body), "angular velocity", 0.0), 0))
    book.say("known_centre.same_sense" if same else "known_centre.opposite_sense", False, **facts)
    fast = 0 if sizes[0].exact > sizes[1].exact else 1
    speed = sizes[fast] - sizes[1 - fast] if same else sizes[0] + sizes[1]
    omega = book.derive(Name("omega", body), "angular velocity", speed / book.geometry.length(*ends))
    centre = Centre(body)
    for i, point in enumerate(ends):
        ahead = book.geometry.direction(point, ends[1 - i])
        ahead = Geometry.turned(ahead, 180.0) if same and i != fast else ahead
        centre.rays[point] = CentreRay(book.derive(centre.length(point), "length", sizes[i] / omega), ahead)
    book.centres["P", body] = centre
    return _entered(book, body, Rate(omega, sense_about(centre.rays[ends[0]], terms[0])))


def _about_end(book: Book, body: str, moving: str, resting: str) -> Rate:
    """Way (c) where one of the points is at rest: ``omega = v_A / AB``; where both are, the body is at rest."""
    centre = Centre(body, at=resting)
    book.centres["P", body] = centre
    facts: dict[str, Fact] = {"body": Body(body), "centre": centre.fact, "at": Point(resting)}
    book.say("known_centre.at_rest", False, **facts)
    if not book.velocity[moving]:
        return _entered(book, body, Rate(Value(Name("omega", body), "angular velocity", 0.0), 0))
    term = whole(book, moving, book.velocity[moving])
    assert term.size is not None
    centre.rays[moving] = CentreRay(book.geometry.length(moving, resting), book.geometry.direction(moving, resting))
    omega = book.derive(Name("omega", body), "angular velocity", term.size / centre.rays[moving].arm)
    return _entered(book, body, Rate(omega, sense_about(centre.rays[moving], term)))


def _entered(book: Book, body: str, rate: Rate) -> Rate:
    """Note the angular velocity of a body, and say its sense."""
    book.omega[body] = rate
    if rate.sense:
        book.say(f"known_centre.{rate.word}", False, body=Body(body), centre=Centre(body).fact)
    return rate


def sense_about(ray: CentreRay, term: Term) -> int:
    """The sense in which a point with the velocity ``term`` turns about the centre (1 counter-clockwise, -1)."""
    return -1 if normal_angle(term.angle.exact - ray.angle.exact) > 0 else 1
