"""A check of a train of gears: the speeds at a pitch point as they are seen from the arm (the formula of Willis).

The arm H has the centres of two gears in mesh. Seen from it both turn about points at rest, with ``omega_1 - omega_H``
and ``omega_2 - omega_H``, and their rims have one speed: ``(omega_1 - omega_H) r_1 = -(omega_2 - omega_H) r_2``; of a
gear in a ring both sides have one sign. The same holds for angular accelerations, which are taken where they are known.
No velocity of a centre is in it, by which the solution has gone.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from variantgen.algebra.expression import Expression, Total, Value
from variantgen.algebra.name import Name
from variantgen.methods.groups.contact import ContactSide
from variantgen.methods.groups.contacts_of_scene import contacts_of_scene
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Balance, Body, Derived, Fact, Item, Point, Sentence, Step


def from_the_arm(book: Book, steps: Sequence[Step]) -> list[Item]:
    """Both speeds at the last pitch point of which both gears and the arm turn; nothing where there is none."""
    shown = {item.value.name for step in steps for item in step.items if isinstance(item, Derived)}
    for order in range(book.task.order, 0, -1):
        at_order = book.at(order)
        for contact in reversed(contacts_of_scene(book.task).values()):
            sides = (contact.first, contact.second)
            arm = _arm(book, *(side.centre for side in sides))
            if not arm or not all(_is_seen(at_order, body, shown) for body in (arm, *(side.body for side in sides))):
                continue
            whole = [_speed(at_order, side, arm) for side in sides]
            found = [Value(None, "number", item.number(True), item) for item in whole]
            facts: dict[str, Fact] = {"carrier": Body(arm), "contact": Point(sides[0].name)}
            facts |= {"body": Body(sides[0].body), "other": Body(sides[1].body)}
            return [Sentence(f"check.from_the_arm_{at_order.letter}", facts, detail=False), Balance(found[0], found[1])]
    return []


def _arm(book: Book, first: str, second: str) -> str:
    """The body that has both centres; nothing where there is none."""
    bodies = book.task.scene.bodies.items()
    return next((name for name, members in bodies if first != second and {first, second} <= set(members)), "")


def _is_seen(book: Book, body: str, shown: Collection[Name | None]) -> bool:
    """Whether a body turns at a rate that is given, or has a line."""
    rate = book.rates.get(body)
    return rate is not None and bool(rate.sense) and (rate.size.expression is None or rate.size.name in shown)


def _speed(book: Book, side: ContactSide, arm: str) -> Expression:
    """``|omega - omega_H| r``, or the same of angular accelerations."""
    own, carried = book.rates[side.body], book.rates[arm]
    flip = 1 if own.sense * own.size.exact >= carried.sense * carried.size.exact else -1
    parts = [(flip * own.sense, own.size), (-flip * carried.sense, carried.size)]
    turning = Total(tuple(sorted(parts, key=lambda part: -part[0])))
    return turning * book.geometry.radius(side.centre, side.radius, side.body)
