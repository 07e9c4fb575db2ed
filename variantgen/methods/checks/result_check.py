"""The check at the end of a solution: a relation that it has not used, with its numbers.

A vector equation on a third axis, or equal projections of the velocities of two points.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations
from typing import TypeGuard

from msgspec.structs import replace

from variantgen.algebra.expression import Constant, Expression, Total, Value
from variantgen.algebra.name import Name
from variantgen.algebra.substitution import substituted
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.named_angles import renamed
from variantgen.methods.steps.step import (
    Balance,
    Body,
    Derived,
    Fact,
    Item,
    Segment,
    Sentence,
    Share,
    Step,
    Term,
    VectorLine,
    VectorOf,
    Word,
)
from variantgen.methods.vectors.natural_sum import signed
from variantgen.methods.vectors.points import RIGHT, UP, sum_of
from variantgen.methods.vectors.vector_equation import share_of, shares, unknowns

_AXES = {"right": RIGHT, "up": UP}
_OPPOSITE = {"right": "left", "up": "down"}
_UNKNOWNS = 2  # vectors that an equation determines
_EQUATED = ("projections.theorem", "coupled.equal")  # sentences that make projections on a segment equal
_RIGHT_ANGLE = 90.0  # degrees
_TERMS = 3  # of a sum of angles that is short
_SEEN = 0.1  # cosine of an angle at which a vector is still seen on an axis


def equal_projections(book: Book) -> list[Item]:
    """Projections of two velocities of a body on the line of their points, each worked out; nothing if none is fit.

    Fit are two points that both move, with velocities of known direction that are not across their line. Those that
    were found by the velocity centre of the body have equal projections whatever its distances are worked out to be.
    """
    for body, members in book.task.scene.bodies.items():
        if ("P", body) in book.centres:
            continue
        moving = [p for p in members if len(book.velocity.get(p, ())) == 1]
        for first, second in combinations(moving, 2):
            items = [] if are_equated(book, first, second) else _pair(book, body, first, second)
            if items:
                return items
    return []


def are_equated(book: Book, first: str, second: str) -> bool:
    """Whether the velocities of two points were found by their equal projections."""
    ends = (Segment(first, second), Segment(second, first))
    return any(book.has_said(key, segment=segment) for key in _EQUATED for segment in ends)


def third_axis(steps: Sequence[Step]) -> list[Item]:
    """The last vector equation with two unknown vectors, on an axis on which it has not been projected: both sides.

    The axis is horizontal or vertical, or along one of the known vectors where neither is a third one. Nothing where
    there is no equation of which both unknown vectors were found, or only the axes that were used fit.
    """
    for step in reversed(steps):
        values = {item.value.name: item.value for item in step.items if isinstance(item, Derived)}
        for line in (item for item in step.items if isinstance(item, VectorLine)):
            free = unknowns((*line.left, *line.right))
            if len(free) == _UNKNOWNS and all(term.name in values and values[term.name].exact > 0 for term in free):
                along = [term.angle for term in (*line.left, *line.right) if term.size is not None]
                for axes in (list(_AXES.values()), along):
                    axis = max(axes, key=lambda axis: _least_share(free, axis), default=None)
                    if axis is not None and _least_share(free, axis) > _SEEN:
                        return _balance(line, values, axis)
    return []


def _least_share(terms: Iterable[Term], axis: Value) -> float:
    """The least cosine of the angles between vectors and an axis, signs apart."""
    return min(abs(math.cos(math.radians(term.angle.exact - axis.exact))) for term in terms)


def _balance(line: VectorLine, values: Mapping[Name | None, Value], axis: Value) -> list[Item]:
    """Both sides of an equation on an axis, to the side on which they are positive.

    Of vectors whose sum is zero, as at a sleeve about a fixed axis, those that are known stand on the one side.
    """
    sides = []
    for terms in (line.left, line.right):
        known = [replace(term, size=values[term.name]) if term.size is None else term for term in terms]
        sides.append(list(shares(known, axis)))
    if not line.left:
        found_here = {term.name for term in unknowns(line.right)}
        others = [replace(share, sign=-share.sign) for share in sides[1] if share.term.name not in found_here]
        sides = [others, [share for share in sides[1] if share.term.name in found_here]]
    if reverse := sum_of(sides[0]).number(True) < 0:
        sides = [[replace(share, sign=-share.sign) for share in side] for side in sides]
    scale = max(value.exact for value in values.values() if value.measure in ("acceleration", "velocity"))
    found = [worked_out(side, scale) for side in sides]
    first, second = (VectorOf(term.name) for term in unknowns((*line.left, *line.right)))
    facts: dict[str, Fact] = {"first": first, "second": second}
    word = next((word for word, own in _AXES.items() if own is axis), "")
    if not word:
        along = next(term for term in (*line.left, *line.right) if term.angle is axis)
        key = "check.third_axis_against" if reverse else "check.third_axis_along"
        return [Sentence(key, {**facts, "vector": VectorOf(along.name)}, detail=False), Balance(*found)]
    facts["side"] = Word(_OPPOSITE[word] if reverse else word)
    return [Sentence("check.third_axis", facts, detail=False), Balance(*found)]


def worked_out(projections: Sequence[Share], scale: float, table: Mapping[Value, Expression] | None = None) -> Value:
    """The sum of projections as a side of a check, in ``scale``: each angle by its letter, a short sum or a number.

    In place of a value in the ``table`` the arithmetic stands that gives it.
    """
    whole = sum_of([_by_number(share) for share in projections])
    whole = substituted(whole, {**(table or {}), **_spelled(projections)}) or Constant(0.0)
    return Value(None, "number", whole.number(True), whole, scale)


def projected(projections: Sequence[Share]) -> list[tuple[int, Expression]]:
    """Projections of known vectors with their signs, written like that."""
    table = _spelled(projections)
    parts = signed([_by_number(share) for share in projections])
    return [(sign, substituted(part, table) or Constant(0.0)) for sign, part in parts]


def _spelled(projections: Sequence[Share]) -> dict[Value, Expression]:
    """What stands in place of angles that are short sums."""
    angles = [angle for share in projections if _is_sum(angle := _by_number(share).angle)]
    return {angle: angle.expression for angle in angles if angle.expression is not None}


def _by_number(share: Share) -> Share:
    """A projection whose angle, unless the solution has it or it is a short sum of such, is a number."""
    if share.angle is None or share.angle.name is not None or _is_sum(share.angle):
        return share
    number, sign = share.angle.exact, share.sign
    if _RIGHT_ANGLE < number < 2 * _RIGHT_ANGLE:  # the acute angle is the one that the solution has
        number, sign = 2 * _RIGHT_ANGLE - number, sign if share.function == "sin" else -sign
    return replace(share, sign=sign, angle=Value(None, "angle", number, Constant(number, "angle")))


def _is_sum(angle: Value | None) -> TypeGuard[Value]:
    """Whether an angle without a name is a short sum of those that the solution has: a reader sees where it is from."""
    if angle is None or angle.name is not None or not isinstance(angle.expression, Total):
        return False
    parts = [part for _, part in angle.expression.terms]
    return len(parts) <= _TERMS and all(isinstance(p, Constant) or (isinstance(p, Value) and p.name) for p in parts)


def by_links(found: Mapping[str, Value]) -> list[Item]:
    """The answers ``found`` by going through the links, as a check of a method for the whole problem."""
    named = [value for value in found.values() if value.name is not None and value.measure != "number"]
    values = [Value(v.name, v.measure, v.exact, Constant(v.exact)) for v in named]
    return [Sentence("check.links", {}, detail=False), *(Derived(value) for value in values)] if values else []


def _pair(book: Book, body: str, first: str, second: str) -> list[Item]:
    """The check on one pair of points."""
    terms = [book.velocity[p][0] for p in (first, second)]
    if terms[0].size is terms[1].size or terms[0].angle.exact == terms[1].angle.exact:
        return []
    axis = book.geometry.direction(first, second)
    on_line = [share_of(term, axis) for term in terms]
    found = [renamed(book, share) for share in on_line if share is not None]
    if len(found) < len(terms):
        return []
    if _projection(found[0]).exact < 0:  # to the side to which the velocities point
        found = [replace(share, sign=-share.sign) for share in found]
    facts: dict[str, Fact] = {"body": Body(body), "segment": Segment(first, second)}
    facts |= {"first": VectorOf(terms[0].name), "second": VectorOf(terms[1].name)}
    items: list[Item] = [Sentence("check.projections", facts, detail=False)]
    return items + [Derived(_projection(share)) for share in found]


def _projection(share: Share) -> Value:
    """The projection of a vector as a value with its arithmetic; a given velocity on the line keeps its letter."""
    size = share.term.size
    assert size is not None
    expression = share.size
    if share.sign < 0:
        expression = -expression
    name = share.term.name if expression is size and size.name is None else None
    return Value(name, size.measure, expression.number(True), expression, size.exact)
