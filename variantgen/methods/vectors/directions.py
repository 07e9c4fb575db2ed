"""Directions of vectors in the table of an equation: the line of a vector, and to which side of it the vector points.

Of a known vector the side is its true one, of an unknown one it is assumed: a negative result is explained by it.
"""

from __future__ import annotations

import cmath
import math

from variantgen.methods.geometry.geometry import normal_angle
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import CentreOf, Fact, Point, Segment, Sentence, Term, Word

_QUARTERS = ("right", "up", "left", "down")
_CORNERS = ("right_up", "left_up", "left_down", "right_down")
_STRAIGHT = 1e-6  # degrees within which a direction is that of an axis
_SIDED = ("ways.guide", "ways.straight", "ways.track", "ways.path")


def pointed(book: Book, term: Term) -> Term:
    """A term of a table with its line and, where the line alone leaves two, the side to which it points."""
    side = side_of(book, term)
    if side is None:
        return term
    key = "ways.assumed" if term.size is None else "ways.pointed"
    return Term(term.name, term.size, term.angle, Sentence(key, {"way": term.way, "side": side}))


def side_of(book: Book, term: Term) -> Fact | None:
    """The side as a sentence or word; None for a direction that has no two sides, or is given elsewhere."""
    if term.way.key in _SIDED:
        return Word(_on_paper(term.angle.exact))
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
    centre: Fact
    if segment.centre_of:
        centre = CentreOf(segment.centre_of, segment.end)
        ray = cmath.rect(
            1.0, math.radians(book.centres[segment.end, segment.centre_of].rays[segment.start].angle.exact)
        )
    else:
        centre = Point(segment.end)
        ray = book.geometry.vector(segment.start, segment.end)
    # The radius leads from the centre to the point.
    sense = "counter_clockwise" if (-ray.conjugate() * ahead).imag > 0 else "clockwise"
    return Sentence("ways.about", {"sense": Word(sense), "centre": centre})


def _on_paper(angle: float) -> str:
    """The word for a direction on paper (degrees from the x axis)."""
    angle = normal_angle(angle) % 360.0
    quarter = round(angle / 90.0)
    if abs(angle - 90.0 * quarter) < _STRAIGHT:
        return _QUARTERS[quarter % 4]
    return _CORNERS[int(angle // 90.0)]
