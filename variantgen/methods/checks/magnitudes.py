"""A sanity check of magnitudes: a bound that a rigid body sets to a vector, by numbers that no one line has joined.

It applies where no other check stands (:mod:`variantgen.methods.checks.result_check`) and costs one line. Three bounds:

- a point C between A and B of a body has a vector between theirs, ``a_C < max(a_A, a_B)``, where no one of the three
  was worked out by both others: half their sum could not break the bound;
- of B and D, none of which was the base point of the other, ``a_D - a_B < BD sqrt(epsilon^2 + omega^4) < a_D + a_B``,
  or ``omega BD`` for velocities, where BD is given or equal to a given side;
- no point at the distance of a contact from the centre of a wheel is faster than the fastest contact, nor slower than
  the slowest, ``v_K < v_M < v_L``, where the centre moves along the tangents there and M was found from the centre.

What is not clear by a margin is not said.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import combinations, pairwise, permutations

from variantgen.algebra.expression import Expression, SquareRoot, Total, Value, total
from variantgen.algebra.name import Name
from variantgen.algebra.values import in_order
from variantgen.methods.groups.contact import contact_name
from variantgen.methods.groups.contacts_of_scene import contacts_of_scene
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.step import (
    Ascending,
    Derived,
    Fact,
    Item,
    Point,
    Segment,
    Sentence,
    Step,
)

_MARGIN = 0.01  # of the larger number: nearer ones do not show which is larger
_SAME = 1e-9  # of the size: nearer places are one


def magnitudes(book: Book, steps: Sequence[Step]) -> list[Item]:
    """The first bound that holds, for accelerations before velocities; nothing where none is known."""
    shown = {item.value.name for step in steps for item in step.items if isinstance(item, Derived)}
    for order in range(book.task.order, 0, -1):
        at_order = book.at(order)
        for found in (_between(at_order, shown), _apart(at_order, shown), _around(at_order, shown)):
            for sentence, values in found:
                if _is_rising(values):
                    return [sentence, Ascending(tuple(values))]
    return []


def _is_rising(values: Sequence[Value]) -> bool:
    """Whether each number is smaller than the next by a margin."""
    return all(low.exact < high.exact * (1.0 - _MARGIN) for low, high in pairwise(values))


def _magnitudes(book: Book, points: Sequence[str], shown: Collection[Name | None]) -> list[Value]:
    """The magnitudes of the vectors of points; nothing unless each is a datum or has a line of its own."""
    found = []
    for point in points:
        terms = book.vectors.get(point, ())
        name = Name(book.letter, point)
        if len(terms) == 1 and terms[0].name.kind == "parameter":
            found.append(terms[0].size)
        elif name in shown:
            found.append(book.values.get(name))
    known = [value for value in found if value is not None]
    return known if len(known) == len(points) else []


def _are_apart(first: Value, second: Value) -> bool:
    """Whether neither of two values was worked out by the other."""
    return first not in in_order([second]) and second not in in_order([first])


def _number(value: Value) -> Value:
    """A known value in a comparison: its number alone."""
    return Value(None, "number", value.exact, value, value.size)


def _between(book: Book, shown: Collection[Name | None]) -> Iterator[tuple[Sentence, list[Value]]]:
    """A point between two others of its body."""
    place = book.task.now.z
    for members in book.task.scene.bodies.values():
        for first, second, point in permutations(members, 3):
            share = (place[point] - place[first]) / (place[second] - place[first] or 1.0)
            if first > second or abs(share.imag) > _SAME or not _SAME < share.real < 1.0 - _SAME:
                continue
            found = _magnitudes(book, (point, first, second), shown)
            if not found or not _are_apart(*found[1:]) or set(found[1:]) <= set(in_order(found[:1])):
                continue
            facts: dict[str, Fact] = {"point": Point(point), "segment": Segment(first, second)}
            facts |= {"vector": Name(book.letter, point)}
            facts |= {"first": Name(book.letter, first), "second": Name(book.letter, second)}
            values = [_number(found[0]), _number(max(found[1:], key=lambda value: value.exact))]
            yield Sentence("check.between", facts, detail=False), values


def _apart(book: Book, shown: Collection[Name | None]) -> Iterator[tuple[Sentence, list[Value]]]:
    """Two points of a body at a given distance, found without each other, and the vector of one about the other."""
    for body, members in book.task.scene.bodies.items():
        about = _about_factor(book, body, shown)
        if about is None:
            continue
        for first, second in combinations(members, 2):
            distance = _distance(book, members, first, second)
            ends = _magnitudes(book, (first, second), shown)
            if not ends or not _are_apart(*ends) or _is_base_point(book, first, second) or not _is_given(distance):
                continue
            low, high = sorted(ends, key=lambda value: value.exact)
            expression = distance * about
            name = Name(book.letter, second, first)
            middle = Value(name, book.measure, expression.number(True), expression, book.scale)
            facts: dict[str, Fact] = {"vector": name}
            facts |= {"first": Name(book.letter, first), "second": Name(book.letter, second)}
            ends_of_range = [_sum(high, -1, low), middle, _sum(high, 1, low)]
            yield Sentence("check.apart", facts, detail=False), ends_of_range


def _distance(book: Book, members: Sequence[str], first: str, second: str) -> Value:
    """The distance of two points, or a given one of the body that is equal to it, as in an equilateral triangle."""
    own = book.geometry.length(first, second)
    if _is_given(own):
        return own
    others = (book.geometry.length(*ends) for ends in combinations(members, 2))
    return next((o for o in others if _is_given(o) and abs(o.exact - own.exact) <= _SAME * own.exact), own)


def _is_given(value: Value) -> bool:
    """Whether a value is a datum, or equal to one."""
    return value.expression is None or isinstance(value.expression, Value)


def _is_base_point(book: Book, first: str, second: str) -> bool:
    """Whether one of two points was the base point of the other."""
    return any(name.kind == book.letter and {name.of, name.about} == {first, second} for name in book.values)


def _sum(first: Value, sign: int, second: Value) -> Value:
    whole = Total(((1, first), (sign, second)))
    return Value(None, "number", whole.number(True), whole, first.size)


def _about_factor(book: Book, body: str, shown: Collection[Name | None]) -> Expression | None:
    """By what a distance is multiplied: ``omega``, or ``sqrt(epsilon^2 + omega^4)``; None where that is not known."""
    rates = [book.omega.get(body), *([book.epsilon.get(body)] if book.order == 2 else [])]
    turning = [rate for rate in rates if rate is not None and rate.sense]
    seen = all(rate.size.expression is None or rate.size.name in shown for rate in turning)
    if None in rates or not turning or not seen:
        return None
    if book.order == 1:
        return turning[0].size
    powers = [rate.size ** (2 if rate is book.epsilon[body] else 4) for rate in reversed(turning)]
    if len(turning) == 1:
        return turning[0].size if turning[0] is book.epsilon[body] else turning[0].size ** 2
    return SquareRoot(total(powers))


def _around(book: Book, shown: Collection[Name | None]) -> Iterator[tuple[Sentence, list[Value]]]:
    """A point of a wheel, and the contacts at its distance from the centre where velocities are least and largest."""
    if book.order == 2:
        return
    for body, members in book.task.scene.bodies.items():
        for point, centre in permutations(members, 2):
            found = _magnitudes(book, (point,), shown)
            bounds = _extremes(book, body, point, centre, shown) if found else {}
            if "fastest" in bounds and Name("v", point, centre) in book.values:
                facts: dict[str, Fact] = {"segment": Segment(centre, point)}
                facts |= {key: Point(value.name.of) for key, value in bounds.items() if value.name is not None}
                values = [bounds.get("slowest"), found[0], bounds["fastest"]]
                key = "check.slowest_and_fastest" if values[0] is not None else "check.fastest"
                yield Sentence(key, facts, detail=False), [_number(value) for value in values if value is not None]


def _extremes(book: Book, body: str, point: str, centre: str, shown: Collection[Name | None]) -> dict[str, Value]:
    """The velocities of contacts on the circle of a point about the centre of a wheel, the least and the largest."""
    now, found = book.task.now, {}
    distance, speed = abs(now.z[point] - now.z[centre]), abs(now.v[centre])
    for contact in contacts_of_scene(book.task).values():
        for _, side in contact.ways:
            name = contact_name(book, side)
            if (side.body, side.centre) != (body, centre) or not side.lever or name not in shown:
                continue
            if side.name == point:  # its velocity is that of the other side
                return {}
            on_circle = abs(side.radius - distance) <= _SAME * distance
            if on_circle and abs((now.v[centre].conjugate() * side.line).imag) <= _SAME * speed:
                value = book.values[name]
                largest = value.exact > max(speed, abs(now.omega[body]) * distance)
                found["fastest" if largest else "slowest"] = value
    return found
