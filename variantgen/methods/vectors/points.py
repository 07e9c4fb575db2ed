"""Vectors of points of bodies whose motion is known: rotation about a fixed point, translation, the pole formula."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from variantgen.algebra.expression import Constant, Expression, Total, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import hypotenuse
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.groups.carriers import carrier_of, is_carried, is_translating
from variantgen.methods.groups.wanted import leads_on
from variantgen.methods.linkage.time_laws import law_behind
from variantgen.methods.solution.book import Book, Known, Rate, along
from variantgen.methods.steps.step import Body, Fact, Point, Share, Term, VectorOf, Word
from variantgen.methods.vectors.directions import on_paper
from variantgen.methods.vectors.midpoint import enter_midpoint, midpoint_ends
from variantgen.methods.vectors.natural_sum import natural_components, natural_modulus, signed
from variantgen.methods.vectors.turning_speed import is_same, turning_speed
from variantgen.methods.vectors.vector_equation import named_shares, write

VIEWS = {1: "velocities", 2: "accelerations"}  # kinds of figures that show the vectors of an order
BODY_VIEWS = {1: "body_velocities", 2: "body_accelerations"}  # the same, of the points of one body
RIGHT = Value(None, "angle", 0.0)
UP = Value(None, "angle", 90.0)


def rotation(book: Book, point: str, pole: str, body: str, name: Name) -> Known:
    """The vectors of a point in the rotation of a body about a pole, with the lines for their magnitudes.

    Velocity: ``omega r`` across the radius. Acceleration: ``a^n = omega^2 r`` towards the pole and
    ``a^tau = epsilon r`` across the radius. What is zero is left out.
    """
    arm, omega = book.geometry.length(point, pole), book.omega[body]
    if book.order == 1:
        return _across(book, name, omega, arm, (point, pole), body)
    found: Known = ()
    if omega.sense:
        normal = _of_other_point(book, name.component("n"), body, arm) or omega.size**2 * arm
        size = book.derive(name.component("n"), book.measure, normal)
        angle = book.geometry.direction(point, pole)
        found = (book.term(name.component("n"), size, angle, "towards", start=Point(point), end=Point(pole)),)
    elif name.about:
        book.say("rates.no_normal", omega=Name("omega", body), vector=name.component("n"))
    rate = book.epsilon[body]
    if not rate.sense and name.about:
        key = "rates.no_tangential" if turns_uniformly(book, body) else "rates.no_tangential_now"
        book.say(key, body=Body(body), epsilon=Name("epsilon", body), vector=name.component("tau"))
    return found + _across(book, name.component("tau"), rate, arm, (point, pole), body)


def _across(book: Book, name: Name, rate: Rate, arm: Value, ends: tuple[str, str], body: str) -> Known:
    """The vector across a radius, in the sense of a known rate."""
    if not rate.sense:
        return ()
    other = _of_other_point(book, name, body, arm)
    size = turning_speed(book, name, rate.size, arm) if other is None else book.derive(name, book.measure, other)
    return (across(book, name, size, ends, rate.sense),)


def _of_other_point(book: Book, name: Name, body: str, arm: Value) -> Value | None:
    """The same component of another asked point of the body at the same distance from the pole, if it is written."""
    if not name.about:
        return None
    asked = {q.point for q in book.task.sought if q.kind == book.letter} & set(book.task.scene.bodies[body])
    for point in sorted(asked - {name.of}):
        found = book.values.get(replace(name, of=point))
        if found is not None and is_same(abs(book.geometry.vector(point, name.about)), arm.exact):
            return found
    return None


def across(book: Book, name: Name, size: Value | None, ends: tuple[str, str], sense: int) -> Term:
    """A vector of the point ``ends[0]`` across its radius to ``ends[1]``, in a sense of rotation about that one."""
    angle = Geometry.turned(book.geometry.direction(ends[1], ends[0]), 90.0 * sense)
    return book.term(name, size, angle, "across", **along(*ends))


def vector(book: Book, point: str) -> Known:
    """The vector of a point as known terms; written down now if it is not known yet.

    Raises LookupError where no body of the point is known.
    """
    if point not in book.vectors:
        body, pole = carrier_of(book, point)
        vector(book, pole)
        _carry(book, point, body, pole)
    return book.vectors[point]


def known_point(book: Book, body: str) -> str:
    """A point of a body whose vector is written; the first that can be is written down where none is.

    Raises LookupError where none can.
    """
    members = book.task.scene.bodies[body]
    written = next((p for p in members if p in book.vectors), None)
    if written is None:
        written = next((p for p in members if is_carried(book, p, body)), members[0])
        vector(book, written)
    return written


def _carry(book: Book, point: str, body: str, pole: str) -> None:
    """Write down the vector of a point of a body by that of its pole."""
    name = Name(book.letter, point)
    if is_translating(book, body):
        with book.step(
            f"points.translation_{book.letter}", BODY_VIEWS[book.order], body=Body(body), point=Point(point)
        ):
            book.say("points.same", first=VectorOf(name), second=VectorOf(Name(book.letter, pole)), body=Body(body))
            book.vectors[point] = renamed(book, book.vectors[pole], point)
            sum_up(book, point)
    elif pole in book.task.fixed:
        with book.step(f"points.turning_{book.letter}", body=Body(body), point=Point(point), pivot=Point(pole)):
            book.vectors[point] = rotation(book, point, pole, body, name)
            _say_ways(book, point, pole, body)
            sum_up(book, point)
    elif book.carry is not None:
        book.carry(book, point, body, pole)
    else:
        carry_by_sum(book, point, body, pole)


def carry_by_sum(book: Book, point: str, body: str, pole: str) -> None:
    """Write down the vector of a further point: half the sum of the vectors of two points, or the pole formula."""
    with book.step(
        f"points.by_pole_{book.letter}", BODY_VIEWS[book.order], body=Body(body), point=Point(point), pole=Point(pole)
    ):
        ends = midpoint_ends(book, point, body)
        if ends is not None:
            enter_midpoint(book, point, body, ends)
        else:
            by_pole(book, point, body, pole)


def _say_ways(book: Book, point: str, pivot: str, body: str) -> None:
    """Where the vector of a point in rotation about a pivot points, or its components; why one of these vanishes."""
    name = Name(book.letter, point)
    terms = book.vectors[point]
    if not terms:
        return
    side = Word(on_paper(terms[-1].angle.exact))
    facts: dict[str, Fact] = {"vector": VectorOf(name), "pivot": Point(pivot), "side": side, **along(point, pivot)}
    facts |= {"normal": VectorOf(name.component("n")), "tangential": VectorOf(name.component("tau"))}
    facts |= {"body": Body(body), "omega": Name("omega", body), "epsilon": Name("epsilon", body)}
    key = book.letter if len(terms) > 1 or book.order == 1 else terms[0].name.part
    if key == "n" and not turns_uniformly(book, body):
        key = "n_now"
    book.say(f"points.about_pivot_{key}", **facts)


def turns_uniformly(book: Book, body: str) -> bool:
    """Whether a body without angular acceleration is driven, and not by a function of time."""
    for template, (turned, _) in zip(book.task.form.drivers, book.task.linkage.driven, strict=True):
        if turned == body:
            source = template.fields.get("omega")
            return not isinstance(source, FamilyExpression) or law_behind(book.task, source) is None
    return False


def renamed(book: Book, terms: Known, point: str) -> Known:
    """Vectors of a translating body under the name of another of its points."""
    found = []
    for term in terms:
        assert term.size is not None
        name = replace(term.name, of=point, about="")
        size = book.derive(name, book.measure, term.size)
        found.append(Term(name, size, term.angle, term.way))
    return tuple(found)


def by_pole(book: Book, point: str, body: str, pole: str) -> None:
    """The pole formula (guide, 57 and 63): vectors of the pole and of the rotation about it, summed on the axes."""
    name, about = Name(book.letter, point), Name(book.letter, point, pole)
    known = vector(book, pole)
    key = "wheel" if book.order == 2 and _is_rolling(book, body) else book.letter
    known_way = book.has_said(f"points.sum_{key}", body=Body(body), pole=Point(pole))
    phrase = f"points.again_{book.letter}" if known_way else f"points.sum_{key}"
    book.say(phrase, body=Body(body), pole=Point(pole), point=Point(point), vector=VectorOf(name))
    start = len(book.items)
    turning = rotation(book, point, pole, body, about)
    sought = book.term(name, None, RIGHT, "unknown")
    write(book, (sought,), (*known, *turning), start)
    enter_sum(book, point, (*known, *turning), leads_on(book.task, point, body))


def _is_rolling(book: Book, body: str) -> bool:
    """Whether a body touches something without slip, so that its rates are known before the equation is written."""
    at = book.task.at
    return any(touch.body[0] == body for joint in book.task.scene.joints if (touch := joint.contact_at(at)))


def enter_sum(book: Book, point: str, terms: Known, leading: bool) -> None:
    """Enter the sum of known vectors as the vector of a point, and its magnitude where that is asked.

    A drawing makes it one vector. Where it is ``leading`` on, more than two vectors are put together to two components;
    else they stay apart, and the magnitude is worked out at once.
    """
    name = Name(book.letter, point)
    if book.graphics is not None:
        book.vectors[point] = book.graphics.compose(book, name, terms)
    elif leading and not (len(terms) == 2 and _are_square(terms) and {term.point for term in terms} == {point}):
        book.vectors[point] = natural_components(book, name, terms) if terms else ()
    else:
        book.vectors[point] = terms
    sum_up(book, point)


def components(book: Book, name: Name, terms: Sequence[Term]) -> Known:
    """The sum of known vectors by its projections on the axes x and y, which keep their signs."""
    found = []
    for axis, word in ((RIGHT, "x"), (UP, "y")):
        parts = named_shares(book, terms, axis)
        own = name.component(word)
        whole = sum_of(parts) if book.graphics is None else book.graphics.component(book, own, terms)
        size = book.derive(own, book.measure, whole)
        if size.exact == 0:
            continue
        found.append(book.term(own, size, axis, f"axis_{word}"))
    return tuple(found)


def sum_of(parts: Sequence[Share]) -> Expression:
    """The sum of projections of known vectors, in their order."""
    terms = signed(parts)
    if not terms:
        return Constant(0.0)
    return terms[0][1] if len(terms) == 1 and terms[0][0] > 0 else Total(tuple(terms))


def positive(size: Value) -> Value:
    """The magnitude behind a projection."""
    return size if size.exact >= 0 else Value(size.name, size.measure, -size.exact, -size, size.size)


def sum_up(book: Book, point: str) -> None:
    """The magnitude of a vector that is known by components across each other, where it is asked."""
    if len(book.vectors[point]) > 1 and any(q.kind == book.letter and q.point == point for q in book.task.sought):
        magnitude(book, point)


def magnitude(book: Book, point: str) -> Value:
    """The magnitude of the vector of a point, as a value."""
    return modulus(book, Name(book.letter, point), book.vectors[point])


def modulus(book: Book, name: Name, terms: Known) -> Value:
    """The magnitude of a vector of one term, or of terms at right angles; of others by their projections."""
    sizes = [term.size for term in terms if term.size is not None]
    if len(terms) == 1 and (sizes[0].name == name or (terms[0].name == name and sizes[0].exact > 0)):
        return sizes[0]
    if name in book.values:
        return book.values[name]
    if not terms:
        return Value(name, book.measure, 0.0)
    if book.graphics is not None:
        return book.graphics.size(book, name, terms)
    if len(terms) > 2 or (len(terms) == 2 and not _are_square(terms)):
        return natural_modulus(book, name, terms)
    if len({term.name.whole for term in terms}) > 1:  # components of one vector are known to be across each other
        first, other = (VectorOf(term.name) for term in terms)
        book.say("natural.square", False, vector=first, other=other)
    return book.derive(name, book.measure, hypotenuse(sizes))


def _are_square(terms: Known) -> bool:
    turn = abs(terms[0].angle.exact - terms[1].angle.exact) % 180.0
    return abs(turn - 90.0) < 1e-7
