"""A check of accelerations: that of a rim point with the contact at rest as base point instead of the axle.

The contact P of a wheel with something at rest has an acceleration along the radius PO only, ``a_P = omega^2 r`` and
what the axle has along PO. So ``a_M = a_P + a^n_MP + a^tau_MP`` with ``omega^2 MP`` and ``epsilon MP``: other vectors
and another triangle than in ``a_M = a_O + a^n_MO + a^tau_MO``, on the same axis. What was found by the acceleration
centre of a plate is found again with the point of given acceleration as base point.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from variantgen.algebra.expression import Applied, Expression, Ratio, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import hypotenuse
from variantgen.methods.centres.known_centre import resting_contacts
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.groups.contact import resting_letter
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.named_angles import renamed
from variantgen.methods.solution.rays import Centre, CentreRay
from variantgen.methods.steps.step import (
    Balance,
    Derived,
    Fact,
    Item,
    NumberOf,
    Point,
    Sentence,
    Step,
    Term,
    VectorLine,
    VectorOf,
)
from variantgen.methods.vectors.contacts.contact_parts import signed_sum
from variantgen.methods.vectors.natural_sum import first_along
from variantgen.methods.vectors.points import sum_of
from variantgen.methods.vectors.vector_equation import share_of, shares

_NOTHING = 1e-9  # of the largest acceleration: a smaller one is none
_NEAR = 1e-9  # of the size: nearer places are one


def other_base_point(book: Book, steps: Sequence[Step]) -> list[Item]:
    """The last such equation of a wheel on one of its axes, with both base points; nothing where there is none."""
    if book.task.order < 2:
        return []
    book = book.at(2)
    written = [item for step in steps for item in step.items]
    shown = {item.value.name for item in written if isinstance(item, Derived)}
    for line in (item for item in reversed(written) if isinstance(item, VectorLine)):
        pole = line.right[-1].name.about
        if len(line.left) == 1 and line.left[0].size is None and pole:
            items = _compared(book, line, line.left[0].point, pole, shown)
            if items:
                return items
    return _beside_centre(book, shown)


def _beside_centre(book: Book, shown: Collection[Name | None]) -> list[Item]:
    """The magnitude of an acceleration found by the acceleration centre, with the given point as base point."""
    for (kind, body), centre in book.centres.items():
        pole = next(iter(centre.rays), "")
        if kind != "Q" or not book.acceleration.get(pole):
            continue
        rates = (book.omega[body], book.epsilon[body])
        for point in (
            q.point for q in book.task.sought if q.kind == "a" and q.point in centre.rays and q.point != pole
        ):
            known = book.values.get(Name("a", point))
            if known is None or book.geometry.stated(pole, point) is None:
                continue
            if not all(_is_seen(rate.size, shown) for rate in rates if rate.sense):
                continue
            ray = CentreRay(book.geometry.length(point, pole), book.geometry.direction(point, pole))
            terms = [(term, term.size) for term in book.acceleration[pole] if term.size is not None]
            whole = _magnitude(book, [*terms, *_about(book, body, point, ray, shown)])
            sides = [Value(None, "number", item.number(True), item, known.exact) for item in (known, whole)]
            if abs(sides[0].exact - sides[1].exact) <= _NOTHING * book.task.largest_acceleration:
                facts: dict[str, Fact] = {"vector": VectorOf(Name("a", point)), "pole": Point(pole)}
                return [Sentence("check.base_point", facts, detail=False), Balance(sides[0], sides[1])]
    return []


def _magnitude(book: Book, terms: Sequence[tuple[Term, Expression]]) -> Expression:
    """The root of the squares of the sums on two natural axes."""
    first = first_along([term for term, _ in terms]).angle
    sums = []
    for axis in (first, Geometry.turned(first, 90.0)):
        found = [_on_axis(book, term, size, axis) for term, size in terms]
        parts = [part for part in found if part is not None]
        if parts:
            total = sum(sign * part.number(True) for sign, part in parts)
            sums.append(signed_sum(parts, 1 if total >= 0 else -1))
    return hypotenuse(sums)


def _compared(book: Book, line: VectorLine, point: str, pole: str, shown: Collection[Name | None]) -> list[Item]:
    """Both sums on the first natural axis of the equation; nothing where a reader has not seen what they need."""
    body = next((b for b, members in book.task.scene.bodies.items() if {point, pole} <= set(members)), "")
    centre = book.centres.get(("P", body))
    if centre is None or not {point, pole} <= set(centre.rays) or not _is_contact(book, centre, pole):
        return []
    if not all(_is_seen(value, shown) for value in (centre.rays[point].arm, book.omega[body].size)):
        return []
    along = first_along(line.right)
    contact = _of_contact(book, centre, line, pole)
    terms = [*([contact] if contact else []), *_about(book, body, point, centre.rays[point], shown)]
    found = [_on_axis(book, term, size, along.angle) for term, size in terms]
    parts = [part for part in found if part is not None]
    own = book.values.get(Name("a", point, part="on_n"))
    whole = own or sum_of([renamed(book, share) for share in shares(line.right, along.angle)])
    if not parts:
        return []
    scale = book.task.largest_acceleration
    sides = [Value(None, "number", item.number(True), item, scale) for item in (whole, signed_sum(parts))]
    if abs(sides[0].exact - sides[1].exact) > _NOTHING * scale:
        return []
    facts: dict[str, Fact] = {"vector": VectorOf(Name("a", point)), "along": VectorOf(along.name), "pole": Point(pole)}
    facts["centre"] = Point(resting_letter(book.task, centre.body, centre.at)) if centre.at else centre.fact
    key = "check.other_base_point" if contact else "check.other_base_point_at_rest"
    if contact and contact[0].size is not None:
        facts |= {"size": NumberOf(contact[0].size, not _is_met(book, contact[0].size, shown)), "way": contact[0].way}
    return [Sentence(key, facts, detail=False), Balance(sides[0], sides[1])]


def _is_contact(book: Book, centre: Centre, pole: str) -> bool:
    """Whether the centre is where the wheel about the pole touches something at rest without slip."""
    place, near = centre.place(book.task), _NEAR * book.task.size
    contacts = resting_contacts(book.task, centre.body, True)
    return any(axle == pole and abs(contact - place) < near for axle, contact in contacts)


def _of_contact(book: Book, centre: Centre, line: VectorLine, pole: str) -> tuple[Term, Expression] | None:
    """The acceleration of the contact along the radius; None where it has none."""
    ray = centre.rays[pole]
    back = Geometry.turned(ray.angle, 180.0)
    at_pole = [term for term in line.right if term.point == pole and not term.name.about]
    parts: list[tuple[int, Expression]] = [(s.sign, s.size) for s in shares(at_pole, back) if s.angle is None]
    parts.append((1, book.omega[centre.body].size ** 2 * ray.arm))
    exact = sum(sign * part.number(True) for sign, part in parts)
    if abs(exact) <= _NOTHING * book.task.largest_acceleration:
        return None
    whole = signed_sum(parts, 1 if exact > 0 else -1)
    size = Value(None, "acceleration", whole.number(True), whole, book.task.largest_acceleration)
    way = Sentence("check.towards" if exact > 0 else "check.away", {"pole": Point(pole)})
    return Term(Name("a", pole), size, back if exact > 0 else ray.angle, way), size


def _is_met(book: Book, size: Value, shown: Collection[Name | None]) -> bool:
    """Whether a line of the solution has the number: that of the contact, or a normal acceleration of its size."""
    met = (value.exact for name, value in book.values.items() if name.kind == "a" and name in shown)
    return any(abs(number - size.exact) <= _NOTHING * size.size for number in met)


def _is_seen(value: Value, shown: Collection[Name | None]) -> bool:
    """Whether a value is given, or has a line."""
    return value.expression is None or isinstance(value.expression, Value) or value.name in shown


def _about(
    book: Book, body: str, point: str, ray: CentreRay, shown: Collection[Name | None]
) -> Iterator[tuple[Term, Expression]]:
    """``omega^2 MP`` along the way from a point to a base point and ``epsilon MP``, or ``a_O MP / r``, across it."""
    omega, epsilon = book.omega[body], book.epsilon[body]
    found: list[tuple[Expression, Value]] = []
    if omega.sense:
        found.append((omega.size**2 * ray.arm, ray.angle))
    if epsilon.sense:
        across: Expression = epsilon.size * ray.arm
        match epsilon.size.expression:
            case Ratio(Value() as tangential, Value() as radius) if not _is_seen(epsilon.size, shown):
                same = abs(ray.arm.exact - radius.exact) <= _NOTHING * radius.exact  # of an equilateral triangle
                across = tangential if same else tangential * ray.arm / radius
        found.append((across, Geometry.turned(ray.angle, -90.0 * epsilon.sense)))
    for size, angle in found:
        yield Term(Name("a", point), Value(None, "acceleration", size.number(True)), angle, Sentence("")), size


def _on_axis(book: Book, term: Term, size: Expression, axis: Value) -> tuple[int, Expression] | None:
    """The projection of a vector with its arithmetic, also that of an angle without a name: nothing derives it before.

    None for a vector across the axis.
    """
    share = share_of(term, axis)
    if share is None:
        return None
    share = renamed(book, share)
    if share.angle is None:
        return share.sign, size
    spelled = share.angle.expression if share.angle.name is None else None
    return share.sign, size * Applied(share.function, spelled or share.angle)
