"""Components of velocities and accelerations at contacts and along threads: sums with signs, names, words."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from msgspec.structs import replace

from variantgen.algebra.expression import Expression, Total, Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.angles import degrees
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.groups.contact import ContactSide, NoSlipContact, contact_name, letter_of
from variantgen.methods.groups.contacts_of_scene import contact_of
from variantgen.methods.groups.group import ContactGroup
from variantgen.methods.solution.book import Book, Rate
from variantgen.methods.steps.step import Body, Fact, Point, Sentence, Term, VectorOf, Word
from variantgen.methods.vectors.contacts.diameter import beyond_centre, other_end
from variantgen.methods.vectors.directions import QUARTERS, on_paper
from variantgen.methods.vectors.point_paths import on_path
from variantgen.methods.vectors.points import modulus
from variantgen.methods.vectors.turning_speed import related, turning_speed
from variantgen.methods.vectors.vector_equation import named_shares, share_of

_NOTHING = 1e-10  # of the natural scale
Parts = list[tuple[int, Expression]]


class Component(NamedTuple):
    """A component along a line: its magnitude (None: zero) and its sign on that line."""

    size: Value | None
    sign: int


ZERO = Component(None, 0)


def views_of(book: Book) -> tuple[str, ...]:
    """The figure that shows the points at the contacts of a body: that of their velocities."""
    return ("contact_velocities",) if book.order == 1 else ()


def sides_of(book: Book, number: int, group: ContactGroup) -> tuple[ContactSide, ContactSide]:
    """The known and the sought side of a contact. Raises LookupError where no side is sought."""
    touch = _contact(book, number)
    for known, sought in touch.ways:
        if (group.body and sought.body == group.body) or (not group.body and sought.centre == group.point):
            return known, sought
    raise LookupError("the contact has no side that is sought")


def _contact(book: Book, number: int) -> NoSlipContact:
    found = contact_of(book.task, number)
    assert found is not None, "a group without a law"
    return found


def say_same(book: Book, group: ContactGroup, number: int, known: ContactSide, sought: ContactSide) -> None:
    """The law of the contact or thread in words."""
    touch = _contact(book, number)
    facts: dict[str, Fact] = {"contact": letter_of(book, sought, known.is_rest), "point": Point(known.name)}
    if sought.body or known.body:
        facts["body"] = Body(sought.body or known.body)
    if known.body and sought.body:
        facts["other"] = Body(known.body)
    if touch.rail:
        facts["rail"] = Body(touch.rail)
    word = "rest" if known.is_rest else "same"
    if book.order == 2 and known.is_rest and sought.body:
        facts |= related(book, sought.body, sought.centre, "tau")
    if touch.reason and book.order == 1 and not _is_said(book, touch.reason):
        book.say(touch.reason, False)
    turning = [side for side in (known, sought) if side.lever]
    if touch.place and book.order == 1:
        for side in turning:
            where = on_paper(degrees(-1j * side.lever * side.line))  # of the centre
            key = f"{touch.place}_{where}" if where in QUARTERS else touch.place
            book.say(key, False, contact=Point(side.name), body=Body(side.body))
    key = f"{touch.kind}.{word}_{book.letter}"
    # The differentiated condition is written in full once a step; an earlier step may be left out of the solution.
    again = book.order == 2 and word == "same" and bool(touch.reason) and _is_said(book, key)
    book.say(f"{touch.kind}.again_a" if again else key, False, **facts)


def _is_said(book: Book, key: str) -> bool:
    """Whether a sentence has been said in the step that is being written."""
    return any(isinstance(item, Sentence) and item.key == key for item in book.items)


def component(book: Book, side: ContactSide) -> Component:
    """The component of a known side along its line, with the lines that derive it."""
    if side.is_rest:
        return ZERO
    parts = centre_parts(book, side)
    end = other_end(book, side) if side.lever and len(parts) == 1 and isinstance(parts[0][1], Value) else None
    if end is not None:
        parts = beyond_centre(book, side, end, parts[0])
    elif side.lever and (rate := book.rates[side.body]).sense:
        about = "" if side.centre in book.task.fixed else side.centre
        name = replace(contact_name(book, side), about=about)
        radius = book.geometry.radius(side.centre, side.radius, side.body)
        turning = turning_speed(book, name, rate.size, radius)
        if parts:
            say_sum(book, side)
        parts.append((rate.sense * side.lever, turning))
    return combined(book, contact_name(book, side), parts)


def found_component(book: Book, known: ContactSide) -> Component:
    """The component of the known side, with the reason where there is none."""
    found = component(book, known)
    if found.size is None and _is_uniform(book, known):
        book.say("contact.uniform", body=Body(known.body), contact=Point(known.name))
    return found


def _is_uniform(book: Book, side: ContactSide) -> bool:
    """Whether a side has no acceleration along the contact because its body turns uniformly about a fixed point."""
    if book.order == 1 or not side.lever or side.centre not in book.task.fixed:
        return False
    rate = book.omega.get(side.body)
    return rate is not None and bool(rate.sense)


def say_sum(book: Book, side: ContactSide, key: str = "sum") -> None:
    """The pole formula for the point at the contact, on the tangent or along the thread, which has no radius.

    The ``key`` is a ``balance`` where the sum is zero.
    """
    name = contact_name(book, side)
    facts: dict[str, Fact] = {"contact": Point(side.name), "centre": Point(side.centre), "vector": VectorOf(name)}
    facts |= {"first": VectorOf(Name(book.letter, side.centre)), "second": VectorOf(replace(name, about=side.centre))}
    file = "belt" if side.belt else "rope" if side.radial is None else "contact"
    book.say(f"{file}.{key}_{book.letter}", **facts)


def centre_parts(book: Book, side: ContactSide) -> Parts:
    """The projections of the vectors of the centre on the line of the side."""
    parts: Parts = []
    for share in named_shares(book, book.vectors[side.centre], side.axis(book)):
        parts.append((share.sign, share.size))
    return parts


def combined(book: Book, name: Name, parts: Sequence[tuple[int, Expression]]) -> Component:
    """A sum of parts with signs as a magnitude and a sign; a single value stays itself."""
    exact = sum(sign * part.number(True) for sign, part in parts)
    if not parts or abs(exact) <= _NOTHING * book.size_of(book.measure):
        return ZERO
    sign = 1 if exact > 0 else -1
    if len(parts) == 1 and isinstance(parts[0][1], Value) and parts[0][1].exact > 0:
        return Component(parts[0][1], sign)
    return Component(book.derive(name, book.measure, signed_sum(parts, sign)), sign)


def signed_sum(parts: Sequence[tuple[int, Expression]], flip: int = 1) -> Expression:
    """A sum with all signs multiplied by ``flip``, a positive term first where there is one."""
    terms = sorted(((sign * flip, part) for sign, part in parts), key=lambda term: -term[0])
    return terms[0][1] if len(terms) == 1 and terms[0][0] > 0 else Total(tuple(terms))


def renamed(book: Book, found: Component, side: ContactSide) -> Component:
    """The component under the name of the point on the other side."""
    name = contact_name(book, side)
    if found.size is None or found.size.name == name:
        return found
    return Component(book.derive(name, book.measure, found.size), found.sign)


def enter_rate(
    book: Book, body: str, size: Expression | None, sense: int, arm: Value, shown_by: Name | None = None
) -> None:
    """``omega = v / r`` with its sense in words, which a vector may show; zero where nothing turns."""
    kind = "omega" if book.order == 1 else "epsilon"
    if size is None or sense == 0:
        book.rates[body] = Rate(Value(Name(kind, body), book.rate_measure, 0.0), 0)
        book.say(f"rates.no_{kind}", False, body=Body(body))
        return
    rate = Rate(book.derive(Name(kind, body), book.rate_measure, size / arm), sense)
    book.rates[body] = rate
    facts: dict[str, Fact] = {"body": Body(body), "rate": Name(kind, body)}
    if shown_by is None:
        book.say(f"rates.{kind}_{rate.word}_sum", False, **facts)
    else:
        book.say(f"rates.{kind}_{rate.word}", False, vector=VectorOf(shown_by), **facts)


def enter_with_way(
    book: Book,
    group: ContactGroup,
    side: ContactSide,
    parts: Parts,
    named: Sequence[tuple[VectorOf, tuple[int, Expression]]],
) -> None:
    """The vector of the centre, and which of the ``named`` components it points along, or else against."""
    way = sum(sign * part.number(True) for sign, part in parts)
    enter_centre(book, group, side, parts)
    moving = abs(way) > _NOTHING * book.size_of(book.measure)
    ahead = [(name, sign * way > 0) for name, (sign, _) in named if moving]
    other, along = next((found for found in ahead if found[1]), ahead[0] if ahead else (None, False))
    if other is not None:
        own = book.vectors[group.point][-1]
        facts: dict[str, Fact] = {"vector": VectorOf(own.name), "other": other, "way": Word(on_paper(own.angle.exact))}
        book.say(f"contact.{'way' if along else 'against'}_{book.letter}", True, **facts)


def enter_centre(book: Book, group: ContactGroup, side: ContactSide, parts: Parts) -> None:
    """The vector of the centre on its path from its component along the line of a side."""
    assert group.point_path is not None
    normal, path = on_path(book, group.point_path)
    axis = side.axis(book)
    for share in named_shares(book, normal, axis):
        parts.append((-share.sign, share.size))
    exact = sum(sign * part.number(True) for sign, part in parts)
    if not parts or abs(exact) <= _NOTHING * book.size_of(book.measure):
        book.vectors[group.point] = normal
        return
    along = share_of(path, axis)
    assert along is not None, "the path of the centre is across the thread or tangent"
    whole = signed_sum(parts, 1 if exact > 0 else -1)
    size = book.derive(path.name, book.measure, whole if along.factor is None else whole / along.factor)
    angle = path.angle if (exact > 0) == (along.sign > 0) else Geometry.turned(path.angle, 180.0)
    book.vectors[group.point] = (*normal, Term(path.name, size, angle, path.way))
    if normal and any(q.point == group.point and q.kind == book.letter for q in book.task.sought):
        modulus(book, Name(book.letter, group.point), book.vectors[group.point])
