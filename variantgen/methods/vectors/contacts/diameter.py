"""The two ends of a diameter of a wheel: the centre has half the sum of their velocities, ``v_L = 2 v_C - v_K``.

It applies to a contact across the centre from another contact of the wheel, where the component there is known, or is
zero because the other body rests, and the velocity of the centre lies along the tangents. Tangential accelerations are
in the same relation. It costs one line, without the rotation about the centre.
"""

from __future__ import annotations

from typing import NamedTuple

from variantgen.algebra.expression import Constant, Expression, Value
from variantgen.methods.groups.contact import ContactSide, contact_name, letter_of, place_of
from variantgen.methods.groups.contacts_of_scene import contacts_of_scene
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Fact, Point, Segment, VectorOf

_SAME = 1e-9  # of the radius: places closer than that are one


class OtherEnd(NamedTuple):
    """The contact at the other end of a diameter, with its component; none where the other body rests."""

    side: ContactSide
    component: Value | None


def other_end(book: Book, side: ContactSide) -> OtherEnd | None:
    """The contact across the centre from that of a side, if the component there is known already."""
    if not book.style.is_free or book.graphics is not None:
        return None
    opposite = 2.0 * book.task.now.z[side.centre] - place_of(book.task, side)
    for contact in contacts_of_scene(book.task).values():
        for other, own in contact.ways:
            if (own.body, own.centre) != (side.body, side.centre) or not own.lever:
                continue
            if abs(place_of(book.task, own) - opposite) > _SAME * side.radius:
                continue
            found = book.values.get(contact_name(book, own))
            if other.is_rest or found is not None:
                return OtherEnd(own, None if other.is_rest else found)
    return None


def beyond_centre(
    book: Book, side: ContactSide, end: OtherEnd, at_centre: tuple[int, Expression]
) -> list[tuple[int, Expression]]:
    """The component of a side by that of the centre (sign and size) and of the other end, said in words."""
    letter = letter_of(book, end.side, end.component is None)
    facts: dict[str, Fact] = {"contact": Point(side.name), "centre": Point(side.centre), "other": letter}
    sign, size = at_centre
    parts: list[tuple[int, Expression]] = [(sign, Constant(2.0) * size)]
    if end.component is None:
        _say(book, "contact.twice", facts)
        return parts
    facts |= {"segment": Segment(end.side.name, side.name), "vector": VectorOf(contact_name(book, side))}
    _say(book, "contact.half", facts)
    radius = place_of(book.task, end.side) - book.task.now.z[side.centre]
    turn = book.exact_rate(side.body)
    ahead = (side.line.conjugate() * (book.exact(side.centre) + 1j * turn * radius)).real > 0
    return [*parts, (-1 if ahead else 1, end.component)]


def _say(book: Book, key: str, facts: dict[str, Fact]) -> None:
    """The reason, for velocities: what holds for them at any time holds for tangential accelerations."""
    if book.order == 1:
        book.say(key, False, **facts)
