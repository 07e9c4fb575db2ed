"""A check of compound motion on a straight path: the tangential acceleration of the point in two ways.

It is the component of ``a`` along ``v``, by the vectors that were found, and the rate of the speed. On axes that turn
with the carrier the components of v have derivatives of their own: ``epsilon OE`` and ``epsilon EM`` of the carrier's
part, ``omega v_rel`` because the arm EM grows, ``a_rel`` of the relative one. So ``v a = v (a^tau + omega v_rel +
a_rel)``: no normal acceleration is in it, and half of that of Coriolis, which the two sides therefore see. It applies
where all vectors lie on two axes, where no axis is left for another check, and costs one line.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from variantgen.algebra.expression import Expression, Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import (
    Balance,
    Body,
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
from variantgen.methods.vectors.natural_sum import ordered_sum, signed
from variantgen.methods.vectors.points import positive
from variantgen.methods.vectors.vector_equation import shares

_COMPONENTS = ("on_n", "on_tau", "xi", "eta")
_SAME = 1e-9  # relative: nearer numbers are one

Signed = tuple[int, Expression]


def growth_of_speed(book: Book, steps: Sequence[Step]) -> list[Item]:
    """Both ways for a point that slides straight on a body that turns; nothing where there is none."""
    items = [item for step in steps for item in step.items]
    sums = {line.left[0].name: line.right for line in items if isinstance(line, VectorLine) and len(line.left) == 1}
    shown = {item.value.name: item.value for item in items if isinstance(item, Derived)}
    for (point, carrier), relative in book.relative.items():
        names = Name("v", point), Name("a", point)
        own, whole = (sums.get(name, ()) for name in names)
        changes = _changes(book, point, carrier, whole)
        if names[0] not in shown or len(relative) != 1 or not own or not changes:
            continue
        if any(term.size is None for term in (*own, *whole)):
            continue
        along = relative[0].angle
        axes = (along, Geometry.turned(along, 90.0))
        if any(share.angle is not None for axis in axes for share in shares((*own, *whole), axis)):
            continue
        known = [[shown[n] for n in map(name.component, _COMPONENTS) if n in shown] for name in names]
        ways = [
            [_product(_along(own, axis, known[0]), _along(vectors, axis, found)) for axis in axes]
            for vectors, found in ((whole, known[1]), (changes, ()))
        ]
        products = [[part for part in way if part is not None] for way in ways]
        if not all(products):  # a is square to v in one of the ways: the other one has nothing to compare
            continue
        speed = shown[names[0]]
        scale = max(part.number(True) for _, part in products[0]) / speed.exact
        sides = [ordered_sum(way) / speed for way in products]
        facts: dict[str, Fact] = {"velocity": VectorOf(names[0]), "acceleration": VectorOf(names[1])}
        facts |= {"point": Point(point), "carrier": Body(carrier)}
        balance = Balance(*(Value(None, "number", side.number(True), side, scale) for side in sides))
        return [Sentence("check.growth_of_speed", facts, detail=False), balance]
    return []


def _changes(book: Book, point: str, carrier: str, whole: Sequence[Term]) -> list[Term]:
    """The derivatives of the parts of the velocity as the carrier sees them; nothing where one is not known."""
    rate, relative = book.omega.get(carrier), book.relative.get((point, carrier), ())
    coriolis = {term.name for term in book.coriolis.get((point, carrier), ())}
    carried = {term.name for term in book.relative_acceleration.get((point, carrier), ())}
    if rate is None or len(coriolis) != 1 or len(relative) != 1 or relative[0].size is None:
        return []
    found = []
    for term in whole:
        if term.name in coriolis:
            half = rate.size * relative[0].size
            size = Value(None, "acceleration", half.number(True), half, book.task.largest_acceleration)
            found.append(Term(term.name, size, term.angle, term.way))
        elif term.name in carried or term.name.part.endswith("tau"):
            found.append(term)
    return found


def _along(terms: Iterable[Term], axis: Value, known: Sequence[Value]) -> Signed | None:
    """The sum of vectors on an axis as a sign and a magnitude: one of the ``known`` ones, or a sum; None for zero."""
    parts = signed(shares(list(terms), axis))
    total = sum(sign * part.number(True) for sign, part in parts)
    if not parts or abs(total) <= _SAME * max(part.number(True) for _, part in parts):
        return None
    flip = 1 if total > 0 else -1
    found = next((value for value in known if abs(abs(value.exact) - abs(total)) <= _SAME * abs(total)), None)
    return flip, ordered_sum([(flip * sign, part) for sign, part in parts]) if found is None else positive(found)


def _product(first: Signed | None, second: Signed | None) -> Signed | None:
    """The product of two components; None where one is zero."""
    if first is None or second is None:
        return None
    return first[0] * second[0], first[1] * second[1]
