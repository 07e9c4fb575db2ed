"""Velocities and accelerations across a contact or along a thread: from the known side to a rate or a centre.

Along the common tangent (the thread) ``v_K = v_C + v_KC`` on both sides, with ``v_KC = omega r``; for accelerations the
tangential components stand in the same relation, because the radii do not change.
"""

from __future__ import annotations

from msgspec.structs import replace

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.methods.groups.contact import ContactSide, contact_name
from variantgen.methods.groups.group import ContactGroup
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import Body, Fact, Point, VectorOf
from variantgen.methods.vectors.contacts.contact_parts import (
    Parts,
    centre_parts,
    combined,
    enter_centre,
    enter_rate,
    enter_with_way,
    found_component,
    renamed,
    say_same,
    say_sum,
    sides_of,
    views_of,
)
from variantgen.methods.vectors.contacts.two_contacts import solve_two_contacts
from variantgen.methods.vectors.points import turns_uniformly, vector
from variantgen.methods.vectors.turning_speed import turning_speed


def solve_contact(book: Book, group: ContactGroup) -> None:
    """Find the rate of the body, the vector of the centre, or both."""
    known, sought = sides_of(book, group.joint, group)
    if group.second >= 0:
        solve_two_contacts(book, group)
        return
    if not known.is_rest:
        vector(book, known.centre)
    if group.body:
        _solve_rate(book, group, known, sought)
    else:
        _solve_centre(book, group, known, sought)


def _solve_rate(book: Book, group: ContactGroup, known: ContactSide, sought: ContactSide) -> None:
    """``omega = v_KC / r`` with ``v_KC = v_K - v_C`` along the tangent."""
    kind = "omega" if book.order == 1 else "epsilon"
    vector(book, sought.centre)
    with book.step(f"contact.{kind}", *views_of(book), body=Body(group.body)):
        say_same(book, group, group.joint, known, sought)
        found = found_component(book, known)
        if not known.is_rest:
            found = renamed(book, found, sought)
        parts: Parts = [(found.sign, found.size)] if found.size else []
        carried = centre_parts(book, sought)
        if carried and not known.is_rest:
            say_sum(book, sought, "sum" if found.size else "balance")
        name = replace(contact_name(book, sought), about=sought.centre if carried else "")
        if known.is_rest and len(carried) == 1 and isinstance(carried[0][1], Value):
            parts = [(-carried[0][0], carried[0][1])]  # v_KC is v_C turned back: no line of its own
        else:
            parts += [(-sign, part) for sign, part in carried]
        turning = combined(book, name, parts)
        radius = book.geometry.radius(sought.centre, sought.radius, sought.body)
        shown_by = turning.size.name if isinstance(turning.size, Value) else None
        enter_rate(book, group.body, turning.size, turning.sign * sought.lever, radius, shown_by)


def _solve_centre(book: Book, group: ContactGroup, known: ContactSide, sought: ContactSide) -> None:
    """``v_C = v_K - v_CK`` along the tangent; of a load or a point of a guide simply the velocity of the thread."""
    with book.step(f"contact.{book.letter}", *views_of(book), point=Point(group.point)):
        say_same(book, group, group.joint, known, sought)
        found = found_component(book, known)
        parts: Parts = [(found.sign, found.size)] if found.size else []
        names = [VectorOf(contact_name(book, sought))] if found.size else []
        if sought.lever and (rate := book.rates[sought.body]).sense:
            name = replace(contact_name(book, sought), about=sought.centre)
            radius = book.geometry.radius(sought.centre, sought.radius, sought.body)
            say_sum(book, sought)
            turning = turning_speed(book, name, rate.size, radius)
            parts.append((-rate.sense * sought.lever, turning))
        elif sought.lever and book.order == 2:
            _say_uniform(book, sought)
        if sought.lever:
            enter_with_way(book, group, sought, parts, list(zip(names, parts, strict=False)))
        else:
            enter_centre(book, group, sought, parts)


def _say_uniform(book: Book, side: ContactSide) -> None:
    """Why the centre of a wheel that turns has the acceleration of its point of contact along the tangent."""
    if side.radial is not None and book.omega[side.body].sense:
        key = "contact.uniform_centre" if turns_uniformly(book, side.body) else "contact.uniform_centre_now"
        facts: dict[str, Fact] = {"body": Body(side.body), "epsilon": Name("epsilon", side.body)}
        book.say(key, contact=Point(side.name), centre=Point(side.centre), **facts)
