"""A body on three supports, none of which is known: an Assur group of the third class.

The pole is a point whose path is known. For each other supported point ``v_Q = v_P + v_QP`` is projected on the axis
across what only its support knows: the line of its rod, the normal of its guide. Two equations are left for the
magnitude of ``v_P`` and the rate of the body; for accelerations with the normal components on the known side.
"""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

from variantgen.algebra.expression import Constant, Expression, Total, Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.groups.group import Support, ThirdClassGroup
from variantgen.methods.solution.book import Book, Known, Rate, resultant
from variantgen.methods.steps.step import (
    AxisOf,
    Body,
    Derived,
    EquationLine,
    Fact,
    LinearSystem,
    Point,
    Projection,
    Sentence,
    Term,
    VectorOf,
)
from variantgen.methods.vectors.point_paths import directed, on_path
from variantgen.methods.vectors.points import vector
from variantgen.methods.vectors.pole import about_pole
from variantgen.methods.vectors.vector_equation import AXES, axis_line, crossed_by, named_shares, share_of, write


class SupportEquation(NamedTuple):
    """An equation ``path * p + arm * rate = right`` for the magnitude p of the pole's vector and the rate."""

    path: Value
    arm: Value
    right: Value


def solve_third_class_group(book: Book, group: ThirdClassGroup) -> None:
    """Find the vector of the pole and the rate of the body."""
    pole, body = group.point_path.point, group.body
    for support in group.supports:
        if support.far:
            vector(book, support.far)
    view = "velocities" if book.order == 1 else "accelerations"
    facts: dict[str, Fact] = {"body": Body(body), "pole": Point(pole)}
    with book.step(f"coupled.{book.measure}", view, **facts):
        book.say("coupled.choose_again" if book.has_said("coupled.choose", **facts) else "coupled.choose", **facts)
        known, path = on_path(book, group.point_path)
        path = _ahead(path, (book.exact(pole) - resultant(known)) * cmath.rect(1.0, -math.radians(path.angle.exact)))
        rows = [_row(book, group, support, known, path) for support in group.supports]
        size, rate = _solved(book, body, path, rows)
        turns = [_turning(book, group, support, rate) for support in group.supports]
        book.say(f"coupled.rotation_{book.letter}", **facts)
        for turn in turns:
            assert turn.expression is not None, "it is a product"
            book.items.append(EquationLine(turn, turn.expression))
        book.say("coupled.system", True)
        matrix, right = tuple((r.path, r.arm) for r in rows), tuple(r.right for r in rows)
        book.items.append(LinearSystem((size, rate), matrix, right))
        book.say("coupled.solved", True)
        book.items.extend(Derived(value, symbolic=False, numeric=False) for value in (size, rate))
        book.items.extend(Derived(turn, detail=True) for turn in turns)
        book.vectors[pole] = (*known, *directed(path, size))
        _enter(book, body, rate)
    _keep_tracked(book, group)


def _turning(book: Book, group: ThirdClassGroup, support: Support, rate: Value) -> Value:
    """``v_QP = omega QP``, the vector of the rotation by the rate that is common to all points."""
    pole = group.point_path.point
    name = Name(book.letter, support.point, pole, "tau" if book.order == 2 else "")
    expression = rate * book.geometry.length(support.point, pole)
    return Value(name, book.measure, expression.number(True), expression)


def _ahead(term: Term, way: complex) -> Term:
    """An unknown vector in its true direction; ``way`` is the true one seen along the assumed one."""
    if way.real >= 0:
        return term
    return Term(term.name, None, Geometry.turned(term.angle, 180.0), term.way)


def _row(book: Book, group: ThirdClassGroup, support: Support, known: Known, path: Term) -> SupportEquation:
    """The equation of one support: ``v_Q = v_P + v_QP`` on the axis across its private unknown vector."""
    pole, body = group.point_path.point, group.body
    start = len(book.items)
    own, private, axis = _supported(book, support)
    found = book.exact(support.point) - resultant(own)
    private = _ahead(private, found * cmath.rect(1.0, -math.radians(private.angle.exact)))
    turning, turn = about_pole(book, support.point, pole, body)
    turn = _ahead(turn, complex(book.exact_rate(body)))
    write(book, (*own, private), (*known, path, *turning, turn), start)
    words = (Sentence("axes.across", {"vector": VectorOf(private.name), "axis": AxisOf(AXES[0])}),)
    line, crossed = axis_line(book, private, axis, private), crossed_by(private)
    sides = [
        named_shares(book, side, axis, line, crossed) for side in ((*own, private), (*known, path, *turning, turn))
    ]
    book.items.append(Projection(words, sides[0], sides[1], axis, AXES[0]))
    right = [(share.sign, share.size) for share in named_shares(book, own, axis)]
    right += [(-share.sign, share.size) for share in named_shares(book, (*known, *turning), axis)]
    arm = book.geometry.length(support.point, pole)
    return SupportEquation(
        _coefficient(path, axis, None),
        _coefficient(turn, axis, arm),
        _value(book.measure, right, book.size_of(book.measure)),
    )


def _supported(book: Book, support: Support) -> tuple[Known, Term, Value]:
    """What a support tells of its point: known vectors, the unknown one, and the axis across that."""
    if support.point_path is not None:
        known, private = on_path(book, support.point_path)
        if support.point_path.straight:
            return known, private, Geometry.turned(private.angle, 90.0)
        return known, private, book.geometry.direction(support.point, support.point_path.centre)
    turning, private = about_pole(book, support.point, support.far, support.rod)
    return (*book.vectors[support.far], *turning), private, book.geometry.direction(support.point, support.far)


def _coefficient(term: Term, axis: Value, arm: Value | None) -> Value:
    """What stands with an unknown: the cosine of its angle with the axis, times the arm for a rate."""
    share = share_of(term, axis)
    measure = "number" if arm is None else "length"
    if share is None:
        return Value(None, measure, 0.0)
    factors: list[Expression] = [item for item in (arm, share.factor) if item]
    whole = factors[0] if factors else Constant(1.0)
    for factor in factors[1:]:
        whole = whole * factor
    return _value(measure, [(share.sign, whole)])


def _value(measure: str, parts: list[tuple[int, Expression]], scale: float = 0.0) -> Value:
    """A number of the system with the expression behind it."""
    if not parts:
        return Value(None, measure, 0.0)
    whole = Total(tuple(parts))
    return Value(None, measure, whole.number(True), whole, scale)


def _solved(book: Book, body: str, path: Term, rows: list[SupportEquation]) -> tuple[Value, Value]:
    """The solution of the two equations by Cramer's rule."""
    (a, b, p), (c, d, q) = rows
    below = a * d - b * c
    first, second = (p * d - b * q) / below, (a * q - p * c) / below
    kind = "omega" if book.order == 1 else "epsilon"
    size = Value(path.name, book.measure, first.number(True), first, book.size_of(book.measure))
    rate = Value(Name(kind, body), book.rate_measure, second.number(True), second, book.size_of(book.rate_measure))
    return size, rate


def _enter(book: Book, body: str, found: Value) -> None:
    """The rate of the body with its sense in words."""
    kind = "omega" if book.order == 1 else "epsilon"
    if found.exact == 0:
        book.rates[body] = Rate(found, 0)
        book.say(f"rates.no_{kind}", False, body=Body(body))
        return
    rate = Rate(found, 1 if book.exact_rate(body) > 0 else -1)
    book.rates[body] = rate
    book.say(f"rates.{kind}_{rate.word}_sum", False, body=Body(body), rate=Name(kind, body))


def _keep_tracked(book: Book, group: ThirdClassGroup) -> None:
    """Velocities of points on fixed circles that no body leads, for their normal accelerations."""
    for support in group.supports:
        circled = support.point_path is not None and support.point_path.centre and not support.point_path.body
        if circled and book.order < book.task.order:
            vector(book, support.point)
