"""A body with two contacts: a wheel between racks, a movable pulley, a spool (guide, section 4.1, way (c) of 3.1.4).

The points of contact and the centre lie across the velocities: ``omega = (v_K - v_L) / KL``, and the velocity of the
centre lies between; the distances do not change, so that accelerations along the tangents are in the same relations.
"""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.algebra.expression import Constant, Total, Value
from variantgen.methods.geometry.geometry import degrees
from variantgen.methods.groups.contact import ContactSide, contact_name, letter_of
from variantgen.methods.groups.group import ContactGroup
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Body, Fact, Point, Segment, VectorOf, Word
from variantgen.methods.vectors.contacts.contact_parts import (
    Parts,
    enter_rate,
    enter_with_way,
    found_component,
    renamed,
    say_same,
    sides_of,
    signed_sum,
    views_of,
)
from variantgen.methods.vectors.directions import on_paper
from variantgen.methods.vectors.points import vector


def solve_two_contacts(book: Book, group: ContactGroup) -> None:
    """Two contacts of one body: ``omega = (v_K - v_L) / KL``, and the velocity of the centre between them."""
    pairs = [sides_of(book, number, group) for number in (group.joint, group.second)]
    for known, _ in pairs:
        if not known.is_rest:
            vector(book, known.centre)
    line = pairs[0][1].line
    facts: dict[str, Fact] = {"body": Body(group.body), "point": Point(group.point)}
    with book.step(f"contact.wheel_{book.letter}", *views_of(book), **facts):
        parts: Parts = []
        arms: list[float] = []
        for number, (known, sought) in zip((group.joint, group.second), pairs, strict=True):
            say_same(book, group, number, known, sought)
            found = renamed(book, found_component(book, known), sought)
            flip = 1 if (line.conjugate() * sought.line).real > 0 else -1
            parts += [(found.sign * flip, found.size)] if found.size else [(0, Constant(0.0))]
            arms.append(sought.radius * sought.lever * flip)
        _enter_two(book, group, [sought for _, sought in pairs], parts, arms)


def _enter_two(
    book: Book, group: ContactGroup, sides: Sequence[ContactSide], parts: Parts, arms: Sequence[float]
) -> None:
    """The rate and the vector of the centre from the components at the two contacts."""
    moving = [part for part in parts if part[0]]
    gap = arms[0] - arms[1]
    difference: Parts = [part for part in (parts[0], (-parts[1][0], parts[1][1])) if part[0]]
    exact = sum(sign * part.number(True) for sign, part in difference) / gap
    sense = 0 if abs(exact * gap) <= 1e-10 * book.size_of(book.measure) else (1 if exact > 0 else -1)
    names = VectorOf(contact_name(book, sides[0])), VectorOf(contact_name(book, sides[1]))
    still = next((side for side, part in zip(sides, parts, strict=True) if not part[0]), None)
    key = "by_rest" if still is not None else "by_two"
    facts: dict[str, Fact] = {"body": Body(group.body), "first": names[0], "second": names[1]}
    ways = [Word(on_paper(degrees(sides[0].line * (sign or 1)))) for sign, _ in parts]
    key += "_alike" if key == "by_two" and ways[0] == ways[1] else ""
    facts |= {"first_way": ways[0], "second_way": ways[1], "segment": Segment(sides[0].name, sides[1].name)}
    contact = letter_of(book, still or sides[1], still is not None)
    facts |= {"contact": contact, "centre": Point(group.point)}
    book.say(f"contact.{key}_{book.letter}", False, **facts)
    size = signed_sum(difference, 1 if exact * gap > 0 else -1) if sense else None
    enter_rate(book, group.body, size, sense, _span(book, sides, arms))
    found = _centre(book, group, sides, arms, parts, moving)
    enter_with_way(book, group, sides[0], found, list(zip(names, parts, strict=True)))


def _span(book: Book, sides: Sequence[ContactSide], arms: Sequence[float]) -> Value:
    """The distance of the two contacts."""
    first, second = sides
    if first.name in book.task.now.z and second.name in book.task.now.z and arms[0] * arms[1] < 0:
        return book.geometry.length(first.name, second.name)
    radii = [book.geometry.radius(side.centre, side.radius, side.body) for side in sides]
    if radii[0] is radii[1]:
        return book.geometry.defined(first.name, second.name, Constant(2.0) * radii[0])
    sign = 1 if arms[0] * arms[1] < 0 else -1
    large = sorted(radii, key=lambda radius: -radius.exact)
    return book.geometry.defined(first.name, second.name, Total(((1, large[0]), (sign, large[1]))))


def _centre(
    book: Book, group: ContactGroup, sides: Sequence[ContactSide], arms: Sequence[float], parts: Parts, moving: Parts
) -> Parts:
    """The component of the centre: half the sum on a diameter, or from one contact and the rate."""
    rate = book.rates[group.body]
    if not rate.sense:
        return moving[:1]
    if len(moving) == 2 and abs(arms[0] + arms[1]) < 1e-9 * abs(arms[0]):
        exact = sum(sign * part.number(True) for sign, part in moving)
        sign = 1 if exact >= 0 else -1
        return [(sign, signed_sum(moving, sign) / Constant(2.0))]
    i = 1 if not parts[1][0] or parts[0][0] else 0
    radius = book.geometry.radius(sides[i].centre, sides[i].radius, sides[i].body)
    turning = (-rate.sense * (1 if arms[i] > 0 else -1), rate.size * radius)
    return [part for part in (parts[i], turning) if part[0]]
