"""Directions of vectors in the table of an equation: the line of a vector, and to which side of it the vector points.

The side is the true one also of a vector that is still to be found.
"""

from __future__ import annotations

import cmath
import math

from variantgen.methods.geometry.geometry import normal_angle
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Fact, Point, Segment, Sentence, Term, Word

QUARTERS = ("right", "up", "left", "down")
_CORNERS = ("right_up", "left_up", "left_down", "right_down")
_STRAIGHT = 1e-6  # degrees within which a direction is that of an axis
_SIDED = ("ways.guide", "ways.straight", "ways.track", "ways.path", "ways.groove")


def pointed(book: Book, term: Term) -> Term:
    """A term of a table with its line and, where the line alone leaves two, the side to which it points.

    To the right, up, left or down on a straight path the side alone says all of a vector that is known; of an unknown
    one a later sentence may say the side, so that the line is kept apart.
    """
    side = side_of(book, term)
    if side is None:
        return term
    if term.size is not None and term.way.key == "ways.straight" and isinstance(side, Word) and side.key in QUARTERS:
        return Term(term.name, term.size, term.angle, Sentence("ways.side", {"side": side}))
    return Term(term.name, term.size, term.angle, Sentence("ways.pointed", {"way": term.way, "side": side}))


def side_of(book: Book, term: Term) -> Fact | None:
    """The side as a sentence or word; None for a direction that has no two sides, or is given elsewhere."""
    if term.way.key in _SIDED:
        return Word(on_paper(term.angle.exact))
    segment = term.way.facts.get("segment")
    if not isinstance(segment, Segment):
        return None
    ahead = cmath.rect(1.0, math.radians(term.angle.exact))
    if term.way.key == "ways.slot":
        along = (book.geometry.vector(segment.start, segment.end).conjugate() * ahead).real > 0
        start, end = (segment.start, segment.end) if along else (segment.end, segment.start)
        return Sentence("ways.towards", {"start": Point(start), "end": Point(end)})
    if term.way.key != "ways.across":
        return None
    return Word(on_paper(term.angle.exact))


def on_paper(angle: float) -> str:
    """The word for a direction on paper (degrees from the x axis)."""
    angle = normal_angle(angle) % 360.0
    quarter = round(angle / 90.0)
    if abs(angle - 90.0 * quarter) < _STRAIGHT:
        return QUARTERS[quarter % 4]
    return _CORNERS[int(angle // 90.0)]
