"""Velocities and accelerations across a contact or along a thread: from the known side to a rate or a centre.

Along the common tangent (the thread) ``v_K = v_C + v_KC`` on both sides, with ``v_KC = omega r``; for accelerations the
tangential components stand in the same relation, because the radii do not change.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from variantgen.methods.book import Book, Rate
from variantgen.methods.contact import Side, Touch
from variantgen.methods.expression import Constant, Expression, Total, Value, cos
from variantgen.methods.geometry import Geometry
from variantgen.methods.group import Joined
from variantgen.methods.law import touch_of
from variantgen.methods.name import Name
from variantgen.methods.points import modulus, vector
from variantgen.methods.step import Body, Fact, Point, Sentence, Term, VectorOf
from variantgen.methods.tracks import on_track
from variantgen.methods.vector_equation import share_of, shares

Parts = list[tuple[int, Expression]]


class Component(NamedTuple):
    """A component along a line: its magnitude (None: zero) and its sign on that line."""

    size: Value | None
    sign: int


ZERO = Component(None, 0)


def solve_joined(book: Book, group: Joined) -> None:
    """Find the rate of the body, the vector of the centre, or both."""
    known, sought = way_of(book, group.joint, group)
    if group.second >= 0:
        _solve_two(book, group)
        return
    if not known.is_rest:
        vector(book, known.centre)
    if group.body:
        _solve_rate(book, group, known, sought)
    else:
        _solve_centre(book, group, known, sought)


def way_of(book: Book, number: int, group: Joined) -> tuple[Side, Side]:
    """The known and the sought side of a contact."""
    touch = _touch(book, number)
    for known, sought in touch.ways:
        if (group.body and sought.body == group.body) or (not group.body and sought.centre == group.point):
            return known, sought
    raise LookupError("the contact has no side that is sought")


def _touch(book: Book, number: int) -> Touch:
    found = touch_of(book.task, number)
    assert found is not None, "a group without a law"
    return found


def say_same(book: Book, group: Joined, number: int, known: Side, sought: Side) -> None:
    """The law of the contact or thread in words."""
    kind = _touch(book, number).kind
    facts: dict[str, Fact] = {"contact": Point(sought.name), "point": Point(known.name)}
    if sought.body or known.body:
        facts["body"] = Body(sought.body or known.body)
    if known.body and sought.body:
        facts["other"] = Body(known.body)
    word = "rest" if known.is_rest else "same"
    book.say(f"{kind}.{word}_{book.letter}", False, **facts)
    turning = [side for side in (known, sought) if side.lever]
    said = any(isinstance(item, Sentence) and item.key == "contact.normal" for item in book.items)
    if book.order == 2 and turning and not known.is_rest and not said:
        book.say("contact.normal")
    if kind == "rope" and book.order == 1:
        for side in turning:
            book.say("rope.leaves", contact=Point(side.name), body=Body(side.body))


def contact_name(book: Book, side: Side) -> Name:
    """The name of the vector of a side: tangential for an acceleration of a point of a turning body."""
    return Name(book.letter, side.name, part="tau" if book.order == 2 and side.lever else "")


def component(book: Book, side: Side) -> Component:
    """The component of a known side along its line, with the lines that derive it."""
    if side.is_rest:
        return ZERO
    parts = centre_parts(book, side)
    if side.lever and (rate := book.rates[side.body]).sense:
        about = "" if side.centre in book.task.fixed else side.centre
        name = contact_name(book, side)._replace(about=about)
        radius = book.geometry.radius(side.centre, side.radius, side.body)
        turning = book.derive(name, book.measure, rate.size * radius)
        if parts:
            _say_sum(book, side)
        parts.append((rate.sense * side.lever, turning))
    return combined(book, contact_name(book, side), parts)


def _say_sum(book: Book, side: Side) -> None:
    """The pole formula for the point at the contact, on the tangent."""
    name = contact_name(book, side)
    facts: dict[str, Fact] = {"contact": Point(side.name), "centre": Point(side.centre), "vector": VectorOf(name)}
    facts |= {"first": VectorOf(Name(book.letter, side.centre)), "second": VectorOf(name._replace(about=side.centre))}
    book.say(f"contact.sum_{book.letter}", **facts)


def centre_parts(book: Book, side: Side) -> Parts:
    """The projections of the vectors of the centre on the line of the side."""
    parts: Parts = []
    for share in shares(book.vectors[side.centre], side.axis(book)):
        assert share.term.size is not None
        parts.append((share.sign, share.term.size if share.angle is None else share.term.size * cos(share.angle)))
    return parts


def combined(book: Book, name: Name, parts: Sequence[tuple[int, Expression]]) -> Component:
    """A sum of parts with signs as a magnitude and a sign; a single value stays itself."""
    exact = sum(sign * part.number(True) for sign, part in parts)
    if not parts or abs(exact) <= 1e-10 * book.size_of(book.measure):
        return ZERO
    sign = 1 if exact > 0 else -1
    if len(parts) == 1 and isinstance(parts[0][1], Value) and parts[0][1].exact > 0:
        return Component(parts[0][1], sign)
    return Component(book.derive(name, book.measure, signed_sum(parts, sign)), sign)


def signed_sum(parts: Sequence[tuple[int, Expression]], flip: int = 1) -> Expression:
    """A sum with all signs multiplied by ``flip``, a positive term first where there is one."""
    terms = sorted(((sign * flip, part) for sign, part in parts), key=lambda term: -term[0])
    return terms[0][1] if len(terms) == 1 and terms[0][0] > 0 else Total(tuple(terms))


def renamed(book: Book, found: Component, side: Side) -> Component:
    """The component under the name of the point on the other side."""
    name = contact_name(book, side)
    if found.size is None or found.size.name == name:
        return found
    return Component(book.derive(name, book.measure, found.size), found.sign)


def _solve_rate(book: Book, group: Joined, known: Side, sought: Side) -> None:
    """``omega = v_KC / r`` with ``v_KC = v_K - v_C`` along the tangent."""
    kind = "omega" if book.order == 1 else "epsilon"
    vector(book, sought.centre)
    with book.step(f"contact.{kind}", body=Body(group.body)):
        say_same(book, group, group.joint, known, sought)
        found = component(book, known)
        if not known.is_rest:
            found = renamed(book, found, sought)
        parts: Parts = [(found.sign, found.size)] if found.size else []
        carried = centre_parts(book, sought)
        if carried and not known.is_rest:
            _say_sum(book, sought)
        name = contact_name(book, sought)._replace(about=sought.centre if carried else "")
        if known.is_rest and len(carried) == 1 and isinstance(carried[0][1], Value):
            parts = [(-carried[0][0], carried[0][1])]  # v_KC is v_C turned back: no line of its own
        else:
            parts += [(-sign, part) for sign, part in carried]
        turning = combined(book, name, parts)
        radius = book.geometry.radius(sought.centre, sought.radius, sought.body)
        enter_rate(book, group.body, turning.size, turning.sign * sought.lever, radius)


def enter_rate(book: Book, body: str, size: Expression | None, sense: int, arm: Value) -> None:
    """``omega = v / r`` with its sense in words; zero where nothing turns."""
    kind = "omega" if book.order == 1 else "epsilon"
    if size is None or sense == 0:
        book.rates[body] = Rate(Value(Name(kind, body), book.rate_measure, 0.0), 0)
        book.say(f"rates.no_{kind}", False, body=Body(body))
        return
    rate = Rate(book.derive(Name(kind, body), book.rate_measure, size / arm), sense)
    book.rates[body] = rate
    book.say(f"rates.{kind}_{rate.word}_sum", False, body=Body(body))


def _solve_centre(book: Book, group: Joined, known: Side, sought: Side) -> None:
    """``v_C = v_K - v_CK`` along the tangent; of a load or a point of a guide simply the velocity of the thread."""
    with book.step(f"contact.{book.letter}", point=Point(group.point)):
        say_same(book, group, group.joint, known, sought)
        found = component(book, known)
        parts: Parts = [(found.sign, found.size)] if found.size else []
        names = [VectorOf(contact_name(book, sought))] if found.size else []
        if sought.lever and (rate := book.rates[sought.body]).sense:
            name = contact_name(book, sought)._replace(about=sought.centre)
            radius = book.geometry.radius(sought.centre, sought.radius, sought.body)
            _say_sum(book, sought)
            turning = book.derive(name, book.measure, rate.size * radius)
            parts.append((-rate.sense * sought.lever, turning))
        if sought.lever:
            _enter_with_way(book, group, sought, parts, list(zip(names, parts, strict=False)))
        else:
            enter_centre(book, group, sought, parts)


def _enter_with_way(
    book: Book, group: Joined, side: Side, parts: Parts, named: Sequence[tuple[VectorOf, tuple[int, Expression]]]
) -> None:
    """The vector of the centre, and which of the ``named`` components it points along."""
    way = sum(sign * part.number(True) for sign, part in parts)
    enter_centre(book, group, side, parts)
    other = next((name for name, (sign, _) in named if sign * way > 0), None)
    if other is not None:
        own = VectorOf(Name(book.letter, group.point))
        book.say(f"contact.way_{book.letter}", True, vector=own, other=other)


def enter_centre(book: Book, group: Joined, side: Side, parts: Parts) -> None:
    """The vector of the centre on its path from its component along the line of a side."""
    assert group.track is not None
    normal, path = on_track(book, group.track)
    axis = side.axis(book)
    for share in shares(normal, axis):
        assert share.term.size is not None
        parts.append((-share.sign, share.term.size if share.angle is None else share.term.size * cos(share.angle)))
    exact = sum(sign * part.number(True) for sign, part in parts)
    if not parts or abs(exact) <= 1e-10 * book.size_of(book.measure):
        book.vectors[group.point] = normal
        return
    along = share_of(path, axis)
    assert along is not None, "the path of the centre is across the thread or tangent"
    whole = signed_sum(parts, 1 if exact > 0 else -1)
    size = book.derive(path.name, book.measure, whole if along.angle is None else whole / cos(along.angle))
    angle = path.angle if (exact > 0) == (along.sign > 0) else Geometry.turned(path.angle, 180.0)
    book.vectors[group.point] = (*normal, Term(path.name, size, angle, path.way))
    if normal and any(q.point == group.point and q.kind == book.letter for q in book.task.asked):
        modulus(book, Name(book.letter, group.point), book.vectors[group.point])


def _solve_two(book: Book, group: Joined) -> None:
    """Two contacts of one body: ``omega = (v_K - v_L) / KL``, and the velocity of the centre between them."""
    pairs = [way_of(book, number, group) for number in (group.joint, group.second)]
    for known, _ in pairs:
        if not known.is_rest:
            vector(book, known.centre)
    line = pairs[0][1].line
    with book.step(f"contact.wheel_{book.letter}", body=Body(group.body), point=Point(group.point)):
        parts: Parts = []
        arms: list[float] = []
        for number, (known, sought) in zip((group.joint, group.second), pairs, strict=True):
            say_same(book, group, number, known, sought)
            found = renamed(book, component(book, known), sought)
            flip = 1 if (line.conjugate() * sought.line).real > 0 else -1
            parts += [(found.sign * flip, found.size)] if found.size else [(0, Constant(0.0))]
            arms.append(sought.radius * sought.lever * flip)
        _enter_two(book, group, [sought for _, sought in pairs], parts, arms)


def _enter_two(book: Book, group: Joined, sides: Sequence[Side], parts: Parts, arms: Sequence[float]) -> None:
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
    facts |= {"contact": Point((still or sides[1]).name), "centre": Point(group.point)}
    book.say(f"contact.{key}_{book.letter}", False, **facts)
    size = signed_sum(difference, 1 if exact * gap > 0 else -1) if sense else None
    enter_rate(book, group.body, size, sense, _span(book, sides, arms))
    found = _centre(book, group, sides, arms, parts, moving)
    _enter_with_way(book, group, sides[0], found, list(zip(names, parts, strict=True)))


def _span(book: Book, sides: Sequence[Side], arms: Sequence[float]) -> Value:
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
    book: Book, group: Joined, sides: Sequence[Side], arms: Sequence[float], parts: Parts, moving: Parts
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
