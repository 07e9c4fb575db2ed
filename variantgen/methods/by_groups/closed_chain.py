"""Three angular velocities and accelerations: a chain of three links between two fixed pivots, in coordinates.

Kirsanov, section 2.5, formulas 2.9 (velocities) and 2.10 (accelerations). For the links 1, 2, 3 of the chain O-A-B-C,
with rates about the z axis (counter-clockwise positive)::

    sum omega_i (y_end - y_start) = 0,    sum omega_i (x_end - x_start) = 0
    sum epsilon_i (x_end - x_start) - sum omega_i^2 (y_end - y_start) = 0
    sum epsilon_i (y_end - y_start) + sum omega_i^2 (x_end - x_start) = 0

because the links add up to the constant vector OC. The rates of one link are known, those of the others follow from two
linear equations. The method takes the place of the vector equation for such dyads; everything else of a mechanism is
solved as usual. A link that slides has no such equation: the method does not apply to a chain with a slider.
"""

from __future__ import annotations

from itertools import pairwise

from msgspec import Struct

from variantgen.algebra.expression import Expression, Raised, Value
from variantgen.algebra.linear import linear
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import Maybe, added, product
from variantgen.methods.groups.group import Dyad
from variantgen.methods.solution.book import Book, Rate
from variantgen.methods.steps.shown_system import ZERO, enter_solution, system_of
from variantgen.methods.steps.step import Body, Derived, EquationLine, Fact, Point, Segment
from variantgen.methods.steps.step_geometry import ChainGraph

_KIND = {1: "omega", 2: "epsilon"}


class Loop(Struct, frozen=True):
    """Three links between the fixed first and last of four points; the rates of the first link are known."""

    bodies: tuple[str, str, str]
    points: tuple[str, str, str, str]


def applies(book: Book, group: Dyad) -> bool:
    """Whether a dyad closes a chain of three links between fixed pivots."""
    return loop_of(book, group) is not None


def loop_of(book: Book, group: Dyad) -> Loop | None:
    """The chain that a dyad closes, from the link with known rates: O-A of the pole, A-B the dyad, B-C of the path."""
    fixed, bodies = book.task.fixed, book.task.scene.bodies
    if group.point_path.straight or not group.point_path.body or group.point_path.centre not in fixed:
        return None
    for first, members in bodies.items():
        if group.pole in members and first in book.omega and first not in (group.body, group.point_path.body):
            pivot = book.task.linkage.pivot(first)
            if pivot is not None:
                points = (pivot, group.pole, group.point_path.point, group.point_path.centre)
                return Loop((first, group.body, group.point_path.body), points)
    return None


def solve_dyad(book: Book, group: Dyad) -> None:
    """Find the rates of the second and the third link."""
    loop = loop_of(book, group)
    assert loop is not None
    kind = _KIND[book.order]
    ends: dict[str, Fact] = {"start": Point(loop.points[0]), "end": Point(loop.points[3])}
    with book.step(f"three_rates.{kind}", "rate_chain", **ends):
        links = tuple(Segment(*ends) for ends in pairwise(loop.points))
        book.say(f"three_rates.equations_{kind}", book.order > 1, links=links, **ends)
        if book.order == 1:
            book.items.append(ChainGraph(loop.points[0], loop.points[1:]))
        known = _signed(book, loop.bodies[0])
        unknowns = [_unknown(book, body) for body in loop.bodies[1:]]
        _solve(book, unknowns, _equations(book, loop, [known, *unknowns]))
        for body, value in zip(loop.bodies[1:], unknowns, strict=True):
            _enter(book, body, value)


def _signed(book: Book, body: str) -> Maybe:
    """The known rate with its sign, as a value; nothing where it is zero."""
    rate = book.rates[body]
    if not rate.sense:
        return None
    name = Name(_KIND[book.order], body, part="z")
    if name in book.values:
        return book.values[name]
    return book.derive(name, book.rate_measure, rate.size if rate.sense > 0 else -rate.size)


def _unknown(book: Book, body: str) -> Value:
    name = Name(_KIND[book.order], body, part="z")
    return Value(name, book.rate_measure, 1.0, None, book.size_of(book.rate_measure))


def _equations(book: Book, loop: Loop, rates: list[Maybe]) -> list[Expression]:
    """Left-hand sides of the two equations, whose right-hand sides are zero."""
    steps = [_shift(book, start, end) for start, end in zip(loop.points, loop.points[1:], strict=False)]
    turning = [added(*((1, product(step[axis], r)) for step, r in zip(steps, rates, strict=True))) for axis in (0, 1)]
    if book.order == 1:
        return [turning[axis] or ZERO for axis in (1, 0)]
    squares = [_square(book, body) for body in loop.bodies]
    swung = [added(*((1, product(sq, step[axis])) for step, sq in zip(steps, squares, strict=True))) for axis in (0, 1)]
    sums = added((1, turning[0]), (-1, swung[1])), added((1, turning[1]), (1, swung[0]))
    return [side or ZERO for side in sums]


def _square(book: Book, body: str) -> Maybe:
    """The square of an angular velocity; nothing where it is zero."""
    rate = book.omega[body]
    return Raised(rate.size, 2) if rate.sense else None


def _shift(book: Book, start: str, end: str) -> tuple[Maybe, Maybe]:
    """The coordinates of one point less those of another, without zeros."""
    pairs = zip(book.geometry.coordinates(start), book.geometry.coordinates(end), strict=True)
    x, y = (added((1, None if b.exact == 0 else b), (-1, None if a.exact == 0 else a)) for a, b in pairs)
    return x, y


def _solve(book: Book, unknowns: list[Value], sides: list[Expression]) -> None:
    """Show the equations in symbols and in numbers, and solve them."""
    book.items.extend(EquationLine(side, ZERO) for side in sides)
    book.say("three_rates.numbers", True)
    system = system_of(unknowns, [linear(side, unknowns) for side in sides])
    book.items.append(system)
    enter_solution(unknowns, system.rows, system.right)
    book.say("three_rates.solved", True)
    book.items.extend(Derived(value, symbolic=False, numeric=False) for value in unknowns)


def _enter(book: Book, body: str, value: Value) -> None:
    """Enter a rate that has been found, with its sense in words."""
    kind = _KIND[book.order]
    assert value.name is not None
    book.values[value.name] = value
    sense = (value.exact > 0) - (value.exact < 0)
    size = value if sense >= 0 else book.derive(Name(kind, body), value.measure, -value)
    book.rates[body] = Rate(size, sense)
    key = f"rates.no_{kind}" if not sense else f"rates.{kind}_{book.rates[body].word}_sum"
    book.say(key, False, body=Body(body), rate=Name(kind, body))
