"""A check of velocities that the velocity centre gave: ``v_B = v_A + v_BA`` with ``v_BA = omega AB``.

The centre P needs the distances AP and BP, this the length AB. On some axes it holds whatever AP is worked out to be,
because BP was worked out by AP; so the axis is chosen on which every such number, wrong by one per cent, is seen.
Projections on AB itself do not check a centre of which AP and BP were found by the law of sines: they are equal then.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from itertools import combinations

from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.algebra.name import Name
from variantgen.algebra.substitution import substituted
from variantgen.algebra.values import in_order
from variantgen.methods.checks.result_check import are_equated, worked_out
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.named_angles import renamed
from variantgen.methods.steps.step import (
    Balance,
    Derived,
    Fact,
    Item,
    Point,
    Segment,
    Sentence,
    Share,
    Step,
    Term,
    VectorOf,
)
from variantgen.methods.vectors.vector_equation import share_of

_WRONG = 1.01  # what a number is multiplied by to see whether the check depends on it
_SEEN = 2e-3  # of the largest term: a difference that four printed digits show
_AGREE = 1e-9  # of the largest velocity


def base_point_of_velocities(book: Book, steps: Sequence[Step]) -> list[Item]:
    """Both sides of ``v_B = v_A + v_BA`` on an axis; nothing where no body has such velocities.

    Fit is a body with a centre P whose angular velocity stands in the solution, with two points of it at a known
    distance, none of which was the base point of the other. The axis is along one of the three vectors, the first on
    which every number that was worked out for the centre is seen when it is wrong, or else one on which some are.
    """
    shown = {item.value.name for step in steps for item in step.items if isinstance(item, Derived)}
    for enough in (all, any):
        for body, members in book.task.scene.bodies.items():
            rate = book.omega.get(body)
            if ("P", body) in book.centres and rate is not None and rate.sense and _is_seen(rate.size, shown):
                for pole, point in combinations(members, 2):
                    fit = _is_fit(book, pole, point, shown)
                    if fit and (items := _compared(book, body, pole, point, shown, enough)):
                        return items
    return []


def _is_fit(book: Book, pole: str, point: str, shown: Collection[Name | None]) -> bool:
    """Whether both velocities and the distance are seen, and no step has joined them yet."""
    known = [book.velocity.get(end, ()) for end in (pole, point)]
    if any(len(terms) != 1 or not _is_seen(terms[0].size, shown) for terms in known):
        return False
    if Name("v", pole, point) in book.values or Name("v", point, pole) in book.values:
        return False
    return not are_equated(book, pole, point) and _is_seen(book.geometry.length(pole, point), shown)


def _is_seen(value: Value | None, shown: Collection[Name | None]) -> bool:
    """Whether a reader knows a value: it is given, or has a line."""
    if value is None:
        return False
    return value.expression is None or isinstance(value.expression, Value) or value.name in shown


def _about(book: Book, body: str, pole: str, point: str) -> tuple[Term, Expression]:
    """``v_BA = omega AB``, across AB in the sense of the rotation, and its arithmetic."""
    rate = book.omega[body]
    size = rate.size * book.geometry.length(pole, point)
    angle = Geometry.turned(book.geometry.direction(pole, point), 90.0 * rate.sense)
    value = Value(None, "velocity", size.number(True), size)
    return Term(Name("v", point, pole), value, angle, Sentence("")), size


def _compared(
    book: Book,
    body: str,
    pole: str,
    point: str,
    shown: Collection[Name | None],
    enough: Callable[[Iterable[bool]], bool],
) -> list[Item]:
    """The sentence and both sides on the first axis on which the check can fail: where ``enough`` numbers are seen."""
    about, size = _about(book, body, pole, point)
    whole, other = book.velocity[point][0], book.velocity[pole][0]
    for axis in (about, whole, other):
        left = _on_axis(book, [whole], axis.angle)
        right = _on_axis(book, [other, about], axis.angle)
        arithmetic = {about.size: size} if about.size else {}
        sides = [worked_out(parts, book.scale, arithmetic) for parts in (left, right)]
        if abs(sides[0].exact - sides[1].exact) > _AGREE * book.scale or not left or not right:
            continue
        if sides[0].exact < 0:
            continue
        if not enough(_shows(sides, value) for value in _of_centre(in_order(sides), body, shown)):
            continue
        facts: dict[str, Fact] = {"pole": Point(pole), "vector": VectorOf(axis.name), "segment": Segment(pole, point)}
        key = "across" if axis is about else "along"
        return [Sentence(f"check.base_point_{key}", facts, detail=False), Balance(sides[0], sides[1])]
    return []


def _of_centre(values: Sequence[Value], body: str, shown: Collection[Name | None]) -> list[Value]:
    """The numbers that were worked out by the centre of a body: the rays to it, and its angular velocity."""
    rays = [v for v in values if v.name and v.name.kind == "length" and v.name.part == "centre"]
    return [v for v in values if v.name in shown and (v in rays or v.name == Name("omega", body))]


def _on_axis(book: Book, terms: Sequence[Term], axis: Value) -> list[Share]:
    """The projections of vectors that are not across an axis."""
    return [renamed(book, share) for term in terms if (share := share_of(term, axis)) is not None]


def _shows(sides: Sequence[Value], wrong: Value) -> bool:
    """Whether the sides differ where one number is wrong, and with it all that is worked out from it."""
    table: dict[Value, Expression] = {wrong: Constant(_WRONG * wrong.exact, wrong.measure)}
    for value in in_order(sides):
        if value is not wrong and value.expression is not None:
            found = substituted(value.expression, table) or Constant(0.0)
            table[value] = Constant(found.number(True), value.measure)
    left, right = (table[side].number(True) for side in sides)
    return abs(left - right) > _SEEN * max(abs(side.exact) for side in sides)
