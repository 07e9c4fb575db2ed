"""A known vector as one term: its magnitude and its direction, where it is known by components."""

from __future__ import annotations

from variantgen.algebra.expression import Applied, Constant, Expression, Magnitude, Ratio, Total, Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.geometry import Geometry, normal_angle
from variantgen.methods.solution.book import Book, Known
from variantgen.methods.steps.step import Derived, Fact, Term, VectorOf
from variantgen.methods.vectors.points import components, modulus, positive

_SQUARE = 1e-7  # degrees from a right angle within which two components are across each other


def whole(book: Book, point: str, known: Known) -> Term:
    """The vector of a point as one term: itself, or the magnitude and direction of its components.

    Of two components across each other, ``a = sqrt(a_1^2 + a_2^2)``, and the vector is turned from the first towards
    the second by ``arctan(a_2 / a_1)``. Other components are first projected on the axes x and y. The vector is not
    zero.
    """
    if len(known) == 1:
        return _forward(known[0])
    name = Name(book.letter, point)
    terms = known if len(known) == 2 and _are_square(known) else components(book, name, known)
    if len(terms) == 1:
        return _forward(terms[0])
    size = modulus(book, name, terms)
    angle = _direction(name, terms[0], terms[1])
    if book.order == 1 and angle.name is not None:
        facts: dict[str, Fact] = {"vector": VectorOf(name), "component": VectorOf(terms[0].name)}
        book.say("points.heading", False, angle=angle.name, **facts)
    book.items.append(Derived(angle))
    return book.term(name, size, angle, "components", vector=VectorOf(name))


def _forward(term: Term) -> Term:
    """The same vector with a positive magnitude."""
    assert term.size is not None
    if term.size.exact > 0:
        return term
    return Term(term.name, positive(term.size), Geometry.turned(term.angle, 180.0), term.way)


def _direction(name: Name, first: Term, second: Term) -> Value:
    """``theta = phi_1 +- arctan |a_2 / a_1|``, from the direction of the first component towards the second."""
    start, end = _forward(first), _forward(second)
    assert first.size is not None
    assert second.size is not None
    sign = 1 if normal_angle(end.angle.exact - start.angle.exact) > 0 else -1
    slope = Applied("arctan", Magnitude(Ratio(second.size, first.size)))
    parts: list[tuple[int, Expression]] = [(1, start.angle), (sign, slope)]
    beyond = start.angle.exact + sign * slope.number(True)
    exact = normal_angle(beyond)
    if turns := round((exact - beyond) / 360.0):
        parts.append((turns, Constant(360.0, "angle")))
    return Value(Name("heading", name.of, name.about, name.part, name.kind), "angle", exact, Total(tuple(parts)))


def _are_square(terms: Known) -> bool:
    turn = abs(terms[0].angle.exact - terms[1].angle.exact) % 180.0
    return abs(turn - 90.0) < _SQUARE
