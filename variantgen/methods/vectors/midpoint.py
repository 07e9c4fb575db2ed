"""The midpoint of two points of a body: its velocity and its acceleration are half the sums of theirs.

It applies where the vectors of both ends are written already and no component on x or y is asked. It costs one line,
two where there are more than three vectors, and no rotation about a pole.
"""

from __future__ import annotations

from itertools import combinations

from variantgen.algebra.name import Name
from variantgen.methods.groups.wanted import leads_on
from variantgen.methods.solution.book import Book, Known
from variantgen.methods.steps.step import Fact, Point, Segment, VectorOf
from variantgen.methods.vectors.natural_sum import natural_components, natural_modulus, unshown_components

_SAME = 1e-9  # of the segment: nearer places are one


def midpoint_ends(book: Book, point: str, body: str) -> tuple[str, str] | None:
    """The ends of a segment of a body of which a point is the midpoint, both with known vectors that do not vanish."""
    if book.graphics is not None or any(q.point == point and q.component for q in book.task.sought):
        return None
    place, hidden = book.task.now.z, book.task.form.figure.hidden
    known = [p for p in book.task.scene.bodies[body] if p != point and book.vectors.get(p) and p not in hidden]
    for first, second in combinations(known, 2):
        if abs(place[first] + place[second] - 2.0 * place[point]) <= _SAME * abs(place[first] - place[second]):
            return first, second
    return None


def enter_midpoint(book: Book, point: str, body: str, ends: tuple[str, str]) -> None:
    """Write down the vector of a midpoint by those of the ends."""
    name = Name(book.letter, point)
    terms: Known = tuple(term for end in ends for term in book.vectors[end])
    named = [_name(book, end) for end in ends]
    facts: dict[str, Fact] = {"point": Point(point), "segment": Segment(*ends), "vector": VectorOf(name)}
    book.say("points.midpoint", False, first=VectorOf(named[0]), second=VectorOf(named[1]), **facts)
    if leads_on(book.task, point, body):
        book.vectors[point] = natural_components(book, name, terms, 2)
    else:
        book.vectors[point] = unshown_components(book, name, terms, 2)
        natural_modulus(book, name, terms, 2)


def _name(book: Book, point: str) -> Name:
    """The name of the vector of a point: its own, or under which it is given."""
    terms = book.vectors[point]
    return terms[0].name if len(terms) == 1 and terms[0].point == point else Name(book.letter, point)
