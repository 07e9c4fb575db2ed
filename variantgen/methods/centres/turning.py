"""Rates of bodies that turn about a fixed point or roll on something at rest, and sums of rotations."""

from __future__ import annotations

from variantgen.algebra.expression import Total, Value
from variantgen.algebra.name import Name
from variantgen.methods.centres.known_centre import contact_fact
from variantgen.methods.geometry.geometry import Geometry, degrees
from variantgen.methods.groups.group import FixedSleeve, PivotedLink, RelativeRotation, RollingContactPole, RollingWheel
from variantgen.methods.solution.book import Book, Known, Rate
from variantgen.methods.steps.step import Body, Fact, Point, Sentence, Term, VectorOf
from variantgen.methods.vectors.given_motion import amount
from variantgen.methods.vectors.points import across, modulus, sum_of, sum_up, vector
from variantgen.methods.vectors.turning_speed import related, turning_speed
from variantgen.methods.vectors.vector_equation import named_shares


def solve_pivoted_link(book: Book, group: PivotedLink) -> None:
    """``omega = v_B / r``; ``epsilon = a^tau_B / r``, with the sense in which the vector turns about the pivot."""
    body, point, pivot = group.body, group.point, group.pivot
    terms = vector(book, point)
    kind = "omega" if book.order == 1 else "epsilon"
    arm = book.geometry.length(point, pivot)
    with book.step(f"turning.{kind}", body=Body(body), point=Point(point), pivot=Point(pivot)):
        name = Name(book.letter, point) if book.order == 1 else Name("a", point, part="tau")
        found = next((term for term in terms if term.name == name), None)
        if found is None and book.order == 1 and terms:
            found = across(book, name, modulus(book, name, terms), (point, pivot), _sense(book, body))
        if found is None and book.order == 2 and terms:
            found = _tangential(book, name, terms, (point, pivot), _sense(book, body))
        _enter(book, body, found.size if found else None, arm, kind, name)


def _tangential(book: Book, name: Name, terms: Known, ends: tuple[str, str], sense: int) -> Term | None:
    """The tangential component of a vector that is known by other components, in the sense of the rotation."""
    if sense == 0:
        return None
    sought = across(book, name, None, ends, sense)
    book.say("known_points.tangential", vector=VectorOf(name))
    size = book.derive(name, book.measure, sum_of(named_shares(book, terms, sought.angle)))
    return Term(name, size, sought.angle, sought.way)


def _sense(book: Book, body: str) -> int:
    rate = book.exact_rate(body)
    return (rate > 0) - (rate < 0)


def _enter(book: Book, body: str, size: Value | None, arm: Value, kind: str, name: Name) -> None:
    """The rate from the vector across a radius; zero where there is none."""
    if size is None or size.exact == 0:
        book.rates[body] = Rate(Value(Name(kind, body), book.rate_measure, 0.0), 0)
        book.say(f"rates.no_{kind}", False, body=Body(body))
        return
    rate = Rate(book.derive(Name(kind, body), book.rate_measure, size / arm), _sense(book, body))
    book.rates[body] = rate
    book.say(f"rates.{kind}_{rate.word}", body=Body(body), rate=Name(kind, body), vector=VectorOf(name))


def solve_rolling_wheel(book: Book, group: RollingWheel) -> None:
    """A wheel on a line or circle at rest: ``v_O = omega r``, ``a_O = epsilon r`` (on a circle the component tau)."""
    body, centre = group.body, group.centre
    radius = radius_of(book, group)
    kind = "omega" if book.order == 1 else "epsilon"
    known = centre in book.vectors
    key = "by_centre" if known else "centre"
    with book.step(f"rolling.{kind}_{key}", body=Body(body), centre=Point(centre)):
        facts: dict[str, Fact] = {"centre": Point(centre), "vector": VectorOf(Name(book.letter, centre))}
        part = "tau" if group.around and book.order == 2 else ""
        if kind == "omega" and not book.has_said("rested.pole_v", body=Body(body)):
            # Also in a short solution: later steps may speak of this centre.
            contact = Sentence("rolling.contact_at", {"point": contact_fact(book, body)})
            book.say("rolling.omega", False, body=Body(body), contact=contact, **facts)
        else:
            facts |= related(book, body, centre, part)
            book.say("rolling.omega_again" if kind == "omega" else "rolling.epsilon", body=Body(body), **facts)
        name = Name(book.letter, centre, part=part)
        if known:
            given = (name, *(term.name for term in book.vectors[centre] if term.name.kind == "parameter"))
            size = next((term.size for term in book.vectors[centre] if term.name in given), None)
            _enter(book, body, size, radius, kind, name)
        else:
            book.vectors[centre] = _centre(book, group, radius, name)
            sum_up(book, centre)


def solve_rolling_contact_pole(book: Book, group: RollingContactPole) -> None:
    """The contact of a rolling wheel as its pole: at rest now, with the acceleration ``omega^2 r`` to the centre."""
    contact, centre = group.contact, group.centre
    name = Name(book.letter, contact)
    facts: dict[str, Fact] = {"body": Body(group.body), "point": Point(contact), "centre": Point(centre)}
    with book.step(f"rested.{book.letter}", **facts):
        book.say(f"rested.pole_{book.letter}", False, vector=VectorOf(name), **facts)
        rate = book.omega.get(group.body)
        if book.order == 1 or rate is None or not rate.sense:
            book.vectors[contact] = ()
            return
        size = book.derive(name, book.measure, rate.size**2 * book.geometry.length(centre, contact))
        angle = book.geometry.direction(contact, centre)
        term = book.term(name, size, angle, "towards", start=Point(contact), end=Point(centre))
        book.vectors[contact] = (term,)


def radius_of(book: Book, group: RollingWheel) -> Value:
    """The radius of the wheel: of the disc of the drawing, or its distance from the named contact."""
    task = book.task
    joint = task.scene.joints[group.joint]
    number = getattr(joint, "radius", None)
    exact = (
        float(number) / task.length_unit
        if number is not None
        else abs(book.geometry.vector(group.centre, group.contact))
    )
    drawn = task.drawn_radius(group.body, group.centre, exact)
    if isinstance(drawn, Value):
        return drawn
    if group.contact:
        return book.geometry.length(group.centre, group.contact)
    return book.geometry.unnamed_radii.of(group.body, exact)


def _centre(book: Book, group: RollingWheel, radius: Value, name: Name) -> Known:
    """The vector of the centre of a wheel whose rate is known."""
    rate = book.rates[group.body]
    terms: Known = ()
    if group.around and book.order == 2 and book.velocity[group.centre]:
        arm = book.geometry.length(group.centre, group.around)
        speed = modulus(book, Name("v", group.centre), book.velocity[group.centre])
        own = Name("a", group.centre, part="n")
        book.say("common.circle", point=Point(group.centre), centre=Point(group.around))
        size = book.derive(own, book.measure, speed**2 / arm)
        angle = book.geometry.direction(group.centre, group.around)
        facts = {"start": Point(group.centre), "end": Point(group.around)}
        terms = (book.term(own, size, angle, "towards", **facts),)
    if not rate.sense:
        return terms
    size = turning_speed(book, name, rate.size, radius)
    if group.around:
        exact = book.exact(group.centre) - _normal_part(book, group)
        turned = 90.0 if _is_left(book, group, exact) else -90.0
        angle = Geometry.turned(book.geometry.direction(group.around, group.centre), turned)
    else:
        angle = Value(None, "angle", degrees(book.exact(group.centre)))
    return (*terms, book.term(name, size, angle, "track", point=Point(group.centre)))


def _normal_part(book: Book, group: RollingWheel) -> complex:
    """The exact normal component of the centre's vector: none for a velocity."""
    if book.order == 1:
        return 0j
    arm = book.geometry.vector(group.centre, group.around)
    return abs(book.task.now.v[group.centre]) ** 2 / abs(arm) ** 2 * arm


def _is_left(book: Book, group: RollingWheel, way: complex) -> bool:
    """Whether a vector of the centre leads counter-clockwise round the circle."""
    arm = book.geometry.vector(group.around, group.centre)
    return (arm.conjugate() * way).imag > 0


def solve_relative_rotation(book: Book, group: RelativeRotation) -> None:
    """Rotations about parallel axes: ``omega = omega_other + omega_rel``, with the signs of their senses."""
    kind = "omega" if book.order == 1 else "epsilon"
    relative = amount(book, book.task.form.drivers[group.driver], kind, book.rate_measure)
    other = book.rates[group.other]
    exact, base = book.exact_rate(group.body), other.sense * other.size.exact
    sign = 1 if exact - base > 0 else -1
    with book.step(f"turning.composed_{kind}", body=Body(group.body), other=Body(group.other)):
        book.say(f"turning.sum_{kind}", body=Body(group.body), other=Body(group.other))
        terms = [(other.sense, other.size)] if other.sense else []
        terms += [(sign, relative)] if relative.exact else []
        sense = (exact > 0) - (exact < 0)
        if sense == 0:
            _enter(book, group.body, None, relative, kind, Name(kind, group.body))
            return
        whole = Total(tuple((sense * s, value) for s, value in terms))
        rate = Rate(book.derive(Name(kind, group.body), book.rate_measure, whole), sense)
        book.rates[group.body] = rate
        book.say(f"rates.{kind}_{rate.word}_sum", body=Body(group.body), rate=Name(kind, group.body))


def solve_fixed_sleeve(book: Book, group: FixedSleeve) -> None:
    """A sleeve that does not swivel: ``omega = omega_other``, ``epsilon = epsilon_other``."""
    kind = "omega" if book.order == 1 else "epsilon"
    other = book.rates[group.other]
    with book.step(f"turning.composed_{kind}", body=Body(group.body)):
        book.say(f"turning.same_{kind}", body=Body(group.body), other=Body(group.other))
        if other.sense == 0:
            book.rates[group.body] = Rate(Value(Name(kind, group.body), book.rate_measure, 0.0), 0)
            return
        book.rates[group.body] = Rate(book.derive(Name(kind, group.body), book.rate_measure, other.size), other.sense)
