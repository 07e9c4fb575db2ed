"""Asked components and directions of vectors that a solution has found: on the axes, along a line, along the path."""

from __future__ import annotations

import math

from msgspec.structs import replace

from variantgen.algebra.expression import Applied, Constant, Expression, Raised, Ratio, Total, Value
from variantgen.algebra.name import Name
from variantgen.families.quantities import Quantity
from variantgen.mechanism.relative import sliding_points
from variantgen.methods.geometry.geometry import Geometry, degrees, normal_angle
from variantgen.methods.solution.book import Book, Known, resultant
from variantgen.methods.steps.not_applicable import NotApplicableError
from variantgen.methods.steps.step import Body, Derived, Fact, Point, Segment, VectorOf
from variantgen.methods.vectors.points import RIGHT, UP, components, modulus, rotation, sum_of, vector
from variantgen.methods.vectors.vector_equation import named_shares

_WORDS = {"t": "tau", "n": "n"}  # components along the path, as names of a solution have them


_NOTHING = 1e-11  # of the largest acceleration: a smaller one is rounding


def vector_answer(book: Book, quantity: Quantity) -> Value:
    """The magnitude of a vector, a component of it, or its direction; lines that it still needs are added."""
    if quantity.component in _WORDS:
        return natural_component(book, quantity.target, _WORDS[quantity.component])
    name, terms = _found(book, quantity)
    if quantity.component in ("x", "y"):
        return _component(book, name, terms, quantity.component)
    if quantity.component == "angle":
        return _angle(book, name, terms)
    if quantity.line:
        return _on_line(book, name, terms, quantity)
    if len(terms) == 1 and terms[0].size is not None and terms[0].size.exact > 0:
        return terms[0].size
    if len(terms) > 1 and name not in book.values:
        kind = quantity.kind if quantity.kind.endswith("_rel") else quantity.kind[0]
        if quantity.group == "difference":
            return modulus(book, name, terms)
        with book.step(f"answers.magnitude_{kind}", point=Point(quantity.target)):
            return modulus(book, name, terms)
    return modulus(book, name, terms)


def curvature_radius(book: Book, point: str) -> Value:
    """``rho = v^2 / a_n`` by the known velocity and acceleration of a point; infinite on a straight path."""
    normal = natural_component(book, point, "n")
    name = Name("curvature", point)
    with book.step("answers.curvature", point=Point(point)):
        speed = modulus(book.at(1), Name("v", point), vector(book.at(1), point))
        if abs(normal.exact) <= _NOTHING * book.task.largest_acceleration:
            return Value(name, "length", float("inf"))
        return book.derive(name, "length", Ratio(Raised(speed, 2), normal))


def natural_component(book: Book, point: str, word: str) -> Value:
    """The tangential (``tau``, signed by the velocity) or normal (``n``) acceleration of a point on its path.

    They are known where the point turns about a fixed one; else the acceleration is projected on the velocity or across
    it. Raises NotApplicableError for a point at rest.
    """
    whole = Name("a", point)
    terms, speed = vector(book, point), vector(book.at(1), point)
    if not speed:
        raise NotApplicableError(f"{point} is at rest: its path has no tangent")
    own = whole.component(word)
    if all(term.name in (whole.component("tau"), whole.component("n")) for term in terms):
        term = next((term for term in terms if term.name == own), None)
        if term is None or term.size is None:
            return Value(own, "acceleration", 0.0)
        return _with_sign(term.size, _along(term.size.exact, term.angle.exact, speed) if word == "tau" else 1.0)
    whole_vector = resultant(terms)
    if own in book.values:  # laid off in the sense that it has
        return _with_sign(
            book.values[own], _along(abs(whole_vector), degrees(whole_vector), speed) if word == "tau" else 1.0
        )
    heading = _angle(book.at(1), Name("v", point), speed)
    with book.step(f"answers.component_{word}", point=Point(point), vector=VectorOf(Name("v", point))):
        axis = heading
        if word == "n":
            across = normal_angle(degrees(whole_vector) - heading.exact) > 0
            axis = Geometry.turned(heading, 90.0 if across else -90.0)
        return book.derive(own, book.measure, sum_of(named_shares(book, terms, axis)))


def _along(size: float, angle: float, speed: Known) -> float:
    """The component of a vector along a velocity, but for a positive factor."""
    return size * math.cos(math.radians(angle - degrees(resultant(speed))))


def _with_sign(value: Value, sign: float) -> Value:
    """The value with the sign of a number."""
    if value.exact * sign >= 0:
        return value
    return Value(value.name, value.measure, -value.exact, -value)


def _found(book: Book, quantity: Quantity) -> tuple[Name, Known]:
    """The name of a vector and its known terms."""
    point, kind = quantity.target, quantity.kind
    if quantity.group == "difference":
        return _difference(book, quantity)
    if kind in ("v", "a"):
        return Name(kind, point), vector(book, point)
    carrier = sliding_points(book.task.scene)[point]
    tables = {"v_rel": book.relative, "a_rel": book.relative_acceleration, "a_cor": book.coriolis}
    return Name(kind[0], point, part=kind[2:]), tables[kind][point, carrier]


def _difference(book: Book, quantity: Quantity) -> tuple[Name, Known]:
    """The vector of one point seen from another: by the rotation of the body of both, or as the difference of both."""
    point, base = quantity.pair
    name = Name(quantity.kind, point, base)
    facts: dict[str, Fact] = {"first": Point(point), "second": Point(base)}
    vectors = {
        "whole": VectorOf(name),
        "one": VectorOf(Name(name.kind, point)),
        "other": VectorOf(Name(name.kind, base)),
    }
    body = quantity.common_body(book.task.scene)
    if body in book.rates and (book.order == 1 or body in book.omega):
        with book.step(f"answers.seen_{name.kind}", **facts):
            book.say("answers.by_rotation", False, body=Body(body), base=Point(base), **vectors)
            return name, rotation(book, point, base, body, name)
    if book.graphics is not None:  # it is measured
        with book.step(f"answers.seen_{name.kind}", **facts):
            book.say("answers.difference_drawn", False, **vectors)
            turned = [replace(term, angle=Geometry.turned(term.angle, 180.0)) for term in vector(book, base)]
            return name, (*vector(book, point), *turned)
    axes = {"x": RIGHT, "y": UP}
    if any(name.component(word) not in book.values for word in axes):
        one, other = (vector(book, end) for end in (point, base))
        with book.step(f"answers.seen_{name.kind}", **facts):
            book.say("answers.difference", False, **vectors)
            for word, axis in axes.items():
                taken = [replace(share, sign=-share.sign) for share in named_shares(book, other, axis)]
                book.derive(name.component(word), book.measure, sum_of((*named_shares(book, one, axis), *taken)))
    sizes = [(word, axis, book.values[name.component(word)]) for word, axis in axes.items()]
    return name, tuple(book.term(name.component(w), size, axis, f"axis_{w}") for w, axis, size in sizes if size.exact)


def _component(book: Book, name: Name, terms: Known, axis: str) -> Value:
    """The projection of a vector on an axis of the paper."""
    own = name.component(axis)
    if own in book.values:
        return book.values[own]
    with book.step(f"answers.components_{name.kind}", vector=VectorOf(name)):
        components(book, name, terms)
    return book.values[own]


def _on_line(book: Book, name: Name, terms: Known, quantity: Quantity) -> Value:
    """The projection of a vector on the way from one point to another, or across it to the left."""
    own = name.component(quantity.component)
    if own in book.values:
        return book.values[own]
    *_, start, end = quantity.points(book.task.now.z)
    side = quantity.component.partition("_")[0]
    with book.step(f"answers.{side}_{name.kind}", vector=VectorOf(name), line=Segment(start, end)):
        axis = Geometry.turned(book.geometry.direction(start, end), 90.0 if side == "across" else 0.0)
        return book.derive(own, book.measure, sum_of(named_shares(book, terms, axis)))


def _angle(book: Book, name: Name, terms: Known) -> Value:
    """The direction of a vector: that of its only term, or by the arc tangent of its components."""
    if len(terms) == 1 and terms[0].size is not None:
        return terms[0].angle if terms[0].size.exact >= 0 else Geometry.turned(terms[0].angle, 180.0)
    x, y = (_component(book, name, terms, axis) for axis in ("x", "y"))
    exact = degrees(resultant(terms))
    if x.exact == 0 or y.exact == 0:
        return Value(None, "angle", exact)
    heading = Name("heading", name.of, name.about, name.part, name.kind)
    if heading in book.values:
        return book.values[heading]
    slope: Expression = Applied("arctan", Ratio(y, x))
    turn = round((exact - slope.number(True)) / 180.0) * 180
    whole = Total(((1, slope), (1 if turn > 0 else -1, Constant(abs(turn), "angle")))) if turn else slope
    value = Value(heading, "angle", exact, whole)
    with book.step(f"answers.direction_{name.kind}", vector=VectorOf(name)):
        book.items.append(Derived(value))
        book.values[heading] = value
    return value
