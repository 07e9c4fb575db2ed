"""Vector equations: projection on axes, each across one of the unknown vectors, and solution for two magnitudes."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.algebra.expression import Constant, Expression, Total, Value, cos
from variantgen.methods.geometry.geometry import Geometry, normal_angle
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.not_applicable import NotApplicableError
from variantgen.methods.steps.step import (
    Derived,
    Fact,
    Projection,
    Sentence,
    Share,
    Term,
    TermTable,
    VectorLine,
    VectorOf,
)
from variantgen.methods.vectors.directions import pointed, side_of

_PERPENDICULAR = 1e-7  # degrees from a right angle within which a projection is zero
_PARALLEL = 1e-7


def unknowns(terms: Sequence[Term]) -> list[Term]:
    """The vectors of unknown magnitude."""
    return [term for term in terms if term.size is None]


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

    Each is found by projecting on the axis across the other unknown vector (with one unknown, on its own direction). A
    negative number means that the vector points against its assumed direction.
    """
    if book.graphics is not None:
        return book.graphics.solve(book, left, right, wanted)
    free = unknowns((*left, *right))
    found = []
    for term in wanted:
        other = next((item for item in free if item is not term), None)
        axis = _axis(term, other)
        found.append(_projected(book, left, right, term, axis, other))
    return found


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
    book: Book, left: Sequence[Term], right: Sequence[Term], term: Term, axis: Value, other: Term | None
) -> Value:
    """Project the equation on an axis and solve it for the one unknown vector that is left."""
    sides = [shares(side, axis) for side in (left, right)]
    book.items.append(Projection(_axis_words(term, axis, other), *sides))
    parts: list[tuple[int, Expression]] = []
    own: Share | None = None
    for side, items in zip((-1, 1), sides, strict=True):
        for share in items:
            if share.term is term:
                own = share
                flip = -side * share.sign
            else:
                parts.append((side * share.sign, _share(share)))
    if own is None:  # both unknown vectors lie along one line, which the equation does not tell apart
        raise NotApplicableError(f"the vectors {term.name.kind} of {term.name.of} are parallel to another unknown one")
    expression = _quotient([(flip * sign, part) for sign, part in parts], own.angle)
    value = Value(term.name, book.measure, expression.number(True), expression, book.size_of(book.measure))
    book.items.append(Derived(value, symbolic=False))
    if value.exact < 0:
        assumed = side_of(book, term)
        # A short solution has no table: the sentence says itself which direction was assumed.
        facts: dict[str, Fact] = {"side": assumed} if assumed is not None else {}
        book.say("common.opposite_to" if facts else "common.opposite", False, vector=VectorOf(term.name), **facts)
    return value


def _quotient(parts: Sequence[tuple[int, Expression]], angle: Value | None) -> Expression:
    """The sum of the parts over the cosine that stands with the unknown."""
    if not parts:
        return Constant(0.0)
    above: Expression = parts[0][1] if len(parts) == 1 and parts[0][0] > 0 else Total(tuple(parts))
    return above if angle is None else above / cos(angle)


def _share(share: Share) -> Expression:
    """A known projection as an expression, without its sign."""
    if share.term.size is None:
        raise NotApplicableError(
            f"more than one unknown vector is left: {share.term.name.kind} of {share.term.name.of}"
        )
    return share.term.size if share.angle is None else share.term.size * cos(share.angle)


def shares(terms: Sequence[Term], axis: Value) -> tuple[Share, ...]:
    """Projections of vectors on an axis with acute angles; those across it are left out."""
    found = []
    for term in terms:
        if term.size is not None and term.size.exact == 0:
            continue
        share = share_of(term, axis)
        if share is not None:
            found.append(share)
    return tuple(found)


def share_of(term: Term, axis: Value) -> Share | None:
    """The projection of a vector on an axis; None for one across it."""
    angle = normal_angle(term.angle.exact - axis.exact)
    if abs(abs(angle) - 90.0) < _PERPENDICULAR:
        return None
    obtuse = abs(angle) > 90.0
    acute = 180.0 - abs(angle) if obtuse else abs(angle)
    if acute < _PARALLEL:
        return Share(-1 if obtuse else 1, term, None)
    return Share(-1 if obtuse else 1, term, _acute(term.angle, axis, acute))


def _acute(direction: Value, axis: Value, acute: float) -> Value:
    """The acute angle between a vector and an axis, as a difference of the two printed directions."""
    for sign in (1, -1):
        turn = acute - sign * (direction.exact - axis.exact)
        whole = round(turn / 180.0) * 180.0
        if abs(turn - whole) < 1e-6:
            parts: list[tuple[int, Expression]] = [(sign, direction), (-sign, axis)]
            parts += [(1 if whole > 0 else -1, Constant(abs(whole), "angle"))] if whole else []
            return Value(None, "angle", acute, Total(tuple(parts)))
    raise ArithmeticError("an angle between two directions is not their difference")


def _axis_words(term: Term, axis: Value, other: Term | None) -> Sentence:
    """How the axis is described: across the other unknown vector, or along the wanted one."""
    if other is None:
        return Sentence("axes.along", {"vector": VectorOf(term.name), "angle": axis})
    return Sentence("axes.across", {"vector": VectorOf(other.name), "angle": axis})
