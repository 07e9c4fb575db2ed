"""Vector equations: projection on axes, each across one of the unknown vectors, and solution for two magnitudes."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

from msgspec.structs import replace

from variantgen.algebra.expression import Expression, Total, Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.angle_sums import acute, supplement
from variantgen.methods.geometry.geometry import Geometry, normal_angle
from variantgen.methods.solution.book import Book, resultant
from variantgen.methods.solution.named_angles import named
from variantgen.methods.steps.not_applicable import NotApplicableError
from variantgen.methods.steps.step import (
    AxisOf,
    Derived,
    Fact,
    Point,
    Projection,
    Segment,
    Sentence,
    Share,
    Term,
    TermTable,
    VectorLine,
    VectorOf,
    Word,
)
from variantgen.methods.vectors.collected import PARALLEL, collected, has_angle, projection_of, quotient
from variantgen.methods.vectors.directions import QUARTERS, on_paper, pointed

_PERPENDICULAR = 1e-7  # degrees from a right angle within which a projection is zero
_CLEAR = 1.05  # how much larger than the others together a projection is that is said to prevail
_CROSSING = 1e-9  # sine of the angle between two directions that determine their vectors
AXES = ("xi", "eta")  # letters of the axes of an equation: x and y are those of the figure of the statement
_ROUNDING = 1e-9  # of the largest vector: what is smaller is zero


def unknowns(terms: Sequence[Term]) -> list[Term]:
    """The vectors of unknown magnitude."""
    return [term for term in terms if term.size is None]


def pointing(left: Sequence[Term], right: Sequence[Term]) -> dict[Name, Term]:
    """The vectors of unknown magnitude, each to the side to which the equation makes it point, by name.

    A magnitude that turns out zero leaves its vector as it is. Raises NotApplicableError for more than two unknown
    vectors, or parallel ones.
    """
    free = [(term, 1) for term in unknowns(left)] + [(term, -1) for term in unknowns(right)]
    rest = resultant(right) - resultant(left)
    ways = [side * cmath.rect(1.0, math.radians(term.angle.exact)) for term, side in free]
    if len(ways) == 1:
        sizes = [(ways[0].conjugate() * rest).real]
    elif len(ways) == 2 and abs(below := (ways[0].conjugate() * ways[1]).imag) > _CROSSING:
        sizes = [(rest.conjugate() * ways[1]).imag / below, (ways[0].conjugate() * rest).imag / below]
    else:
        raise NotApplicableError("the directions of the unknown vectors do not determine them")
    none = _ROUNDING * max((term.size.exact for term in (*left, *right) if term.size is not None), default=0.0)
    return {
        term.name: Term(term.name, None, Geometry.turned(term.angle, 180.0), term.way) if size < -none else term
        for (term, _), size in zip(free, sizes, strict=True)
    }


def write(book: Book, left: Sequence[Term], right: Sequence[Term], start: int) -> None:
    """The equation and the table of its vectors: what is known of each.

    The equation comes before the lines of its known magnitudes, which begin at the item ``start`` of the step.
    """
    if book.graphics is not None:
        book.graphics.write(book, left, right, start)
        return
    book.items.insert(start, VectorLine(tuple(left), tuple(right)))
    book.items.append(TermTable(tuple(pointed(book, term) for term in (*left, *right))))


def solved(book: Book, left: Sequence[Term], right: Sequence[Term], wanted: Sequence[Term]) -> list[Value]:
    """Magnitudes of the ``wanted`` unknown vectors of an equation with at most two unknown ones.

    Each is found by projecting on the axis across the other unknown vector (with one unknown, on its own direction).
    Before an equation is solved it is said why its unknown vector points as it does.
    """
    if book.graphics is not None:
        return book.graphics.solve(book, left, right, wanted)
    free = unknowns((*left, *right))
    axes = []
    for letter, term in zip(AXES, wanted, strict=False):
        other = next((item for item in free if item is not term), None)
        axis = _axis(term, other)
        axes.append(((shares(left, axis), shares(right, axis)), term, axis, other, letter))
    for sides, term, axis, other, _ in axes:
        line = axis_line(book, term, axis, other)
        for share in (*sides[0], *sides[1]):  # an angle has one name on both axes, either of which may need it first
            named(book, share, line, crossed_by(other))
    return [_projected(book, *axis) for axis in axes]


def _axis(term: Term, other: Term | None) -> Value:
    """The direction of the axis: across the other unknown, to the side of the wanted one."""
    if other is None:
        return term.angle
    for by in (90.0, -90.0):
        axis = Geometry.turned(other.angle, by)
        if abs(normal_angle(axis.exact - term.angle.exact)) < 90.0:
            return axis
    return axis


def _projected(
    book: Book, plain: tuple[tuple[Share, ...], ...], term: Term, axis: Value, other: Term | None, letter: str
) -> Value:
    """Solve an equation that is projected on an axis, ``plain`` by sides, for the one unknown vector that is left."""
    line = axis_line(book, term, axis, other)
    sides = [tuple(named(book, share, line) for share in side) for side in plain]
    rest: list[tuple[int, Share]] = []
    own: Share | None = None
    for side, items in zip((-1, 1), sides, strict=True):
        for share in items:
            if share.term is term:
                own = share
                flip = -side * share.sign
            else:
                rest.append((side, share))
    if own is None:  # both unknown vectors lie along one line, which the equation does not tell apart
        raise NotApplicableError(f"the vectors {term.name.kind} of {term.name.of} are parallel to another unknown one")
    known = [(flip * side * share.sign, share) for side, share in rest]
    total = _close_sum(book, known) if book.style.shortcuts and own.factor is not None else None
    words = (_axis_words(book, term, axis, other, letter), *_sense_words(book, term, known, total))
    if total is not None:  # what decides the sense is seen before it is said
        book.items.extend((words[0], Sentence("axes.sum"), Derived(total, symbolic=False)))
        words = words[1:]
    book.items.append(Projection(words, sides[0], sides[1], axis, "" if other is None else letter))
    if total is not None and own.factor is not None:
        expression: Expression = total / own.factor
    elif book.style.shortcuts and known and all(has_angle(share, own) for _, share in known):
        # Equal angles: the equation is one of magnitudes.
        expression = quotient(collected([(sign, replace(share, angle=None)) for sign, share in known]), None)
    else:
        expression = quotient(collected(known), own.factor)
    value = Value(term.name, book.measure, expression.number(True), expression, book.size_of(book.measure))
    book.items.append(Derived(value, symbolic=False))
    return value


def shares(terms: Sequence[Term], axis: Value) -> tuple[Share, ...]:
    """Projections of vectors on an axis, those of unknown ones with acute angles; vectors across it are left out."""
    found = []
    for term in terms:
        if term.size is not None and term.size.exact == 0:
            continue
        share = share_of(term, axis)
        if share is not None:
            found.append(share)
    return tuple(found)


def named_shares(
    book: Book, terms: Sequence[Term], axis: Value, line: Fact | None = None, crossed: Fact | None = None
) -> tuple[Share, ...]:
    """The same, to be written: angles that are long sums have a name, with a line.

    ``line`` is the axis in words, or it has none and is across what is ``crossed``.
    """
    return tuple(named(book, share, line, crossed) for share in shares(terms, axis))


def share_of(term: Term, axis: Value) -> Share | None:
    """The projection of a vector on an axis; None for one across it."""
    angle = abs((term.angle.exact - axis.exact + 180.0) % 360.0 - 180.0)
    if abs(angle - 90.0) < _PERPENDICULAR:
        return None
    obtuse = angle > 90.0
    size = 180.0 - angle if obtuse else angle
    if size < PARALLEL:
        return Share(-1 if obtuse else 1, term, None)
    sign = -1 if obtuse else 1
    function, written = acute(term.angle, axis, size)
    whole = supplement(written) if function == "cos" and term.size is not None else None
    return Share(sign, term, written, function) if whole is None else Share(-sign, term, whole)


def _axis_words(book: Book, term: Term, axis: Value, other: Term | None, letter: str) -> Sentence:
    """How the axis is described: along a line of the figure or across the other unknown vector, or along the wanted."""
    line = axis_line(book, term, axis, other)
    if other is None:
        return Sentence("axes.along", {"vector": VectorOf(term.name)})
    if isinstance(line, Segment):
        facts: dict[str, Fact] = {"start": Point(line.start), "end": Point(line.end), "vector": VectorOf(other.name)}
        return Sentence("axes.on_line", {**facts, "axis": AxisOf(letter)})
    side = on_paper(axis.exact)
    return Sentence(
        f"axes.{side}" if side in QUARTERS else "axes.across",
        {"vector": VectorOf(other.name), "side": Word(side), "axis": AxisOf(letter)},
    )


def axis_line(book: Book, term: Term, axis: Value, other: Term | None) -> Segment | VectorOf | None:
    """The line of the axis: the wanted vector, or the segment that the other unknown vector is across, its way."""
    if other is None:
        return VectorOf(term.name)
    segment = other.way.facts.get("segment")
    if other.way.key != "ways.across" or not isinstance(segment, Segment) or segment.centre_of:
        return None
    ahead = book.geometry.vector(segment.start, segment.end) * cmath.rect(1.0, -math.radians(axis.exact))
    return segment if ahead.real > 0 else Segment(segment.end, segment.start)


def crossed_by(other: Term | None) -> Segment | VectorOf | None:
    """What the axis is across: the other unknown vector, or the segment along which that one is."""
    if other is None:
        return None
    segment = other.way.facts.get("segment")
    is_along = other.way.key == "ways.slot" and isinstance(segment, Segment) and not segment.centre_of
    return segment if is_along and isinstance(segment, Segment) else VectorOf(other.name)


def _sense_words(book: Book, term: Term, known: Sequence[tuple[int, Share]], total: Value | None) -> list[Sentence]:
    """Why the wanted vector points as it does: by the projections of the known ones, which it balances; ``total`` is
    their sum where that has a line.
    """
    if not known:
        return []
    facts: dict[str, Fact] = {"vector": VectorOf(term.name), "side": Word(on_paper(term.angle.exact))}
    sizes = [(sign * projection_of(share).number(True), share.term) for sign, share in known]
    against = -sum(min(size, 0.0) for size, _ in sizes)
    if len(sizes) == 1:
        return [Sentence("axes.by_one", {**facts, "known": _named_in_text(sizes[0][1])})]
    if against == 0:
        return [Sentence("axes.by_all", facts)]
    largest, strongest = max(sizes, key=lambda item: item[0])
    if largest > _CLEAR * against:
        return [Sentence("axes.by_strongest", {**facts, "known": _named_in_text(strongest)})]
    return [Sentence("axes.by_sum" if total is None else "axes.by_total", facts)]


def _close_sum(book: Book, known: Sequence[tuple[int, Share]]) -> Value | None:
    """The sum of known projections of which none dominates; None where the sense is seen without it."""
    sizes = [sign * projection_of(share).number(True) for sign, share in known]
    against = -sum(min(size, 0.0) for size in sizes)
    if len(sizes) < 2 or against == 0 or max(sizes) > _CLEAR * against:
        return None
    parts = Total(tuple(collected(known)))
    return Value(None, book.measure, parts.number(True), parts, book.size_of(book.measure))


def _named_in_text(term: Term) -> Fact:
    """A vector in a sentence; of a component along a laid axis its letter, for the equation has the whole vector."""
    return term.name if term.is_laid else VectorOf(term.name)
