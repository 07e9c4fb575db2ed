"""A known vector as one term: its magnitude and its direction, where it is known by components."""

from __future__ import annotations

import math

from variantgen.methods.book import Book, Known
from variantgen.methods.expression import Applied, Expression, Ratio, Total, Value
from variantgen.methods.geometry import normal_angle
from variantgen.methods.name import Name
from variantgen.methods.points import components, modulus
from variantgen.methods.step import Derived, Term, VectorOf

_SQUARE = 1e-7  # degrees from a right angle within which two components are across each other


def whole(book: Book, point: str, known: Known) -> Term:
    """The vector of a point as one term: itself, or the magnitude and direction of its components.

    Of two components across each other, ``a = sqrt(a_1^2 + a_2^2)``, and the vector is turned from the first towards
    the second by ``arctan(a_2 / a_1)``. Other components are first projected on the axes x and y. The vector is not
    zero.
    """
    if len(known) == 1:
        return known[0]
    name = Name(book.letter, point)
    terms = known if len(known) == 2 and _are_square(known) else components(book, name, known)
    if len(terms) == 1:
        return terms[0]
    size = modulus(book, name, terms)
    angle = _direction(name, terms[0], terms[1])
    book.items.append(Derived(angle))
    return book.term(name, size, angle, "components", vector=VectorOf(name))


def _direction(name: Name, first: Term, second: Term) -> Value:
    """``phi = phi_1 +- arctan(a_2 / a_1)``."""
    assert first.size is not None
    assert second.size is not None
    sign = 1 if normal_angle(second.angle.exact - first.angle.exact) > 0 else -1
    parts: list[tuple[int, Expression]] = [
        (1, first.angle),
        (sign, Applied("arctan", Ratio(second.size, first.size))),
    ]
    total = first.angle.exact + sign * math.degrees(math.atan2(second.size.exact, first.size.exact))
    return Value(Name("direction", name.of, part=name.kind), "angle", normal_angle(total), Total(tuple(parts)))


def _are_square(terms: Known) -> bool:
    turn = abs(terms[0].angle.exact - terms[1].angle.exact) % 180.0
    return abs(turn - 90.0) < _SQUARE
