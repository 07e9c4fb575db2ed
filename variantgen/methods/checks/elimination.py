"""A check of one of two unknown vectors: both components of the equation, from which the other one is eliminated.

The solution has projected on the axis across the other unknown vector u, which is oblique. Along the wanted vector x
and across it, x stands in one component alone: the other one gives u, so ``x = K_x + K_n tan psi`` with the known
vectors K and the angle psi of u with the normal. Each angle is that of a vector with x, none of those that were used.
Velocities of two points of a body with equal projections are taken as ``v_B = v_A + v_BA``. It costs one line.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import permutations

from variantgen.algebra.expression import Applied, Expression, Value
from variantgen.algebra.name import Name
from variantgen.methods.checks.result_check import are_equated, projected
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.named_angles import renamed
from variantgen.methods.steps.step import (
    Balance,
    Derived,
    Fact,
    Item,
    Point,
    Sentence,
    Step,
    Term,
    VectorLine,
    VectorOf,
)
from variantgen.methods.vectors.natural_sum import ordered_sum
from variantgen.methods.vectors.vector_equation import share_of, shares, unknowns

_UNKNOWNS = 2
_AGREE = 1e-9  # relative


def elimination(book: Book, steps: Sequence[Step]) -> list[Item]:
    """The last such equation of which one unknown vector alone was found, or two equal projections; else nothing."""
    found = {item.value.name: item.value for step in steps for item in step.items if isinstance(item, Derived)}
    for step in reversed(steps):
        for line in (item for item in step.items if isinstance(item, VectorLine)):
            free = unknowns((*line.left, *line.right))
            known = [term for term in free if term.name in found]
            if len(free) == _UNKNOWNS and len(known) == 1 and found[known[0].name].exact > 0:
                side = 1 if known[0] in line.left else -1
                others = [(-side, term) for term in line.left if term.size] + [(side, t) for t in line.right if t.size]
                (other,) = (term for term in free if term is not known[0])
                facts: dict[str, Fact] = {"vector": VectorOf(known[0].name), "other": VectorOf(other.name)}
                if items := _compared(book, found[known[0].name], known[0], others, other.angle):
                    return [Sentence("check.elimination", facts, detail=False), *items]
    return _equated(book, found)


def _equated(book: Book, found: dict[Name | None, Value]) -> list[Item]:
    """The velocity of a point that was found by its projection on the line to another one."""
    for members in book.task.scene.bodies.values():
        for pole, point in permutations(members, 2):
            size, terms = found.get(Name("v", point)), [book.velocity.get(end, ()) for end in (pole, point)]
            if size is None or any(len(known) != 1 for known in terms) or not are_equated(book, pole, point):
                continue
            across = Geometry.turned(book.geometry.direction(pole, point), 90.0)
            facts: dict[str, Fact] = {"vector": VectorOf(Name("v", point)), "pole": Point(pole)}
            facts["other"] = VectorOf(Name("v", point, pole))
            if items := _compared(book, size, terms[1][0], [(1, terms[0][0])], across):
                return [Sentence("check.elimination_about", facts, detail=False), *items]
    return []


def _compared(book: Book, size: Value, wanted: Term, known: Sequence[tuple[int, Term]], other: Value) -> list[Item]:
    """The wanted magnitude by its equation with the known vectors; nothing where the other unknown one is not oblique.

    ``known`` are the vectors with their signs on the side of the other unknown one, which has the direction ``other``.
    """
    normal = Geometry.turned(wanted.angle, 90.0)
    unit = Term(wanted.name, Value(None, "number", 1.0), other, wanted.way)
    leaning, ahead = share_of(unit, normal), share_of(unit, wanted.angle)
    if leaning is None or leaning.angle is None or ahead is None:
        return []
    leaning = renamed(book, leaning)
    angle = leaning.angle
    assert angle is not None, "an oblique vector makes an angle with each axis"
    along, across = (_signed_shares(book, known, axis) for axis in (wanted.angle, normal))
    if not across:
        return []
    turn = -1 if leaning.sign * ahead.sign > 0 else 1
    flip, inner = across[0]
    if len(across) > 1:
        flip = 1 if sum(sign * part.number(True) for sign, part in across) >= 0 else -1
        inner = ordered_sum([(flip * sign, part) for sign, part in across])
    tangent = Applied("tan", angle)
    product = inner * tangent if leaning.function == "cos" else inner / tangent
    whole = ordered_sum([*along, (turn * flip, product)])
    if abs(whole.number(True) - size.exact) > _AGREE * size.exact:
        return []
    return [Balance(*(Value(None, "number", item.number(True), item, size.exact) for item in (size, whole)))]


def _signed_shares(book: Book, known: Sequence[tuple[int, Term]], axis: Value) -> list[tuple[int, Expression]]:
    """The projections of vectors with signs of their own."""
    found = []
    for side, term in known:
        own = projected([renamed(book, share) for share in shares([term], axis)])
        found += [(side * sign, part) for sign, part in own]
    return found
