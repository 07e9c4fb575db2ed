"""The check at the end of a solution: equal projections of the velocities of two points of a body on their line."""

from __future__ import annotations

from itertools import combinations

from variantgen.methods.book import Book
from variantgen.methods.expression import Value, cos
from variantgen.methods.name import Name
from variantgen.methods.step import Body, Derived, Fact, Item, Segment, Sentence, Share, VectorOf
from variantgen.methods.vector_equation import share_of


def equal_projections(book: Book) -> list[Item]:
    """Projections of two velocities of a body on the line of their points, each worked out; nothing if none is fit.

    Fit are two points that both move, with velocities of known direction that are not across their line.
    """
    for body, members in book.task.scene.bodies.items():
        moving = [p for p in members if len(book.velocity.get(p, ())) == 1]
        for first, second in combinations(moving, 2):
            items = _pair(book, body, first, second)
            if items:
                return items
    return []


def _pair(book: Book, body: str, first: str, second: str) -> list[Item]:
    """The check on one pair of points."""
    terms = [book.velocity[p][0] for p in (first, second)]
    if terms[0].size is terms[1].size or terms[0].angle.exact == terms[1].angle.exact:
        return []
    axis = book.geometry.direction(first, second)
    found = [share_of(term, axis) for term in terms]
    if any(share is None for share in found):
        return []
    facts: dict[str, Fact] = {"body": Body(body), "segment": Segment(first, second)}
    facts |= {"first": VectorOf(terms[0].name), "second": VectorOf(terms[1].name)}
    items: list[Item] = [Sentence("check.projections", facts, detail=False)]
    return items + [Derived(_projection(share)) for share in found if share is not None]


def _projection(share: Share) -> Value:
    """The projection of a vector as a value with its arithmetic."""
    size = share.term.size
    assert size is not None
    expression = size if share.angle is None else size * cos(share.angle)
    if share.sign < 0:
        expression = -expression
    name = Name("projection", share.term.name.of, share.term.name.about, share.term.name.part, share.term.name.kind)
    return Value(name, size.measure, expression.number(True), expression, size.exact)
