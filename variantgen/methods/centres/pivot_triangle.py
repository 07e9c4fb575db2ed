"""The velocity centre P of a rod between two links: the triangle of P and the fixed pivots O and C.

OC is given, and so is one angle at it; AP and BP follow from OP and CP by the links, and one law of sines is enough.
The angles of the triangle ABP come last, by its height: only accelerations need them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property

from msgspec import Struct

from variantgen.algebra.expression import Applied, Constant, Expression, Total, Value
from variantgen.algebra.name import Name
from variantgen.algebra.normal_form import summed
from variantgen.methods.centres.centre import note_angle
from variantgen.methods.centres.triangle_shapes import say_shape, shapes
from variantgen.methods.geometry.angle_sums import angle_sum, difference, is_short, is_single, supplement, valued
from variantgen.methods.geometry.angles import AngleForm, corner_name
from variantgen.methods.geometry.geometry import Geometry
from variantgen.methods.geometry.trigonometry import by_height
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.named_angles import note_sum
from variantgen.methods.solution.rays import Centre, CentreRay
from variantgen.methods.steps.step import Derived, Segment, Term, triangle

_SHARP = 0.2  # of OP: a shorter AP is no good difference of OP and OA
_FAR = 2.0  # rods: from arms that are longer the angles of the thin triangle ABP come with few digits


def solve(book: Book, centre: Centre, terms: tuple[Term, Term], rays: tuple[Value, Value], place: complex) -> bool:
    """Find AP and BP by the pivots, if both points are on links about fixed ones at a given distance.

    ``rays`` are the directions from the points to the centre, which is at ``place``.
    """
    links = [_Link(book, term, place) for term in terms]
    (a, o), (b, c) = ((link.point, link.pivot) for link in links)
    if not o or not c or o == c or book.geometry.stated(o, c) is None or not all(link.is_sharp for link in links):
        return False
    if links[0].is_between != links[1].is_between:  # the triangles OCP and ABP have different angles at P
        return False
    z = book.task.now.z
    if book.task.order == 2 and max(abs(place - z[a]), abs(place - z[b])) > _FAR * abs(z[a] - z[b]):
        return False
    angles = [link.angle(centre, other.pivot) for link, other in zip(links, links[::-1], strict=True)]
    if not any(_is_given(angle) for angle in angles):
        return False
    rest = AngleForm((), 180.0).minus(_own(angles[0])).minus(_own(angles[1]))
    at_p = valued(centre.vertex(a, b), rest)
    side = book.geometry.length(o, c)
    shape, needed, arms = next(case for case in shapes(side, angles[0], angles[1], at_p) if case[0])
    if shape == "by_sines":
        corners = triangle(o, c, centre.kind, centre.body)
        book.say("perpendiculars.pivots", True, triangle=corners, segment=Segment(o, c))
    else:
        say_shape(book, centre, shape, (o, c))
    for angle in needed:
        if angle.name is not None and angle.name.kind == "angle":
            note_angle(book, angle)
    for link, arm, ray in zip(links, arms, rays, strict=True):
        length = book.derive(centre.length(link.point), "length", link.rest(arm))
        centre.rays[link.point] = CentreRay(length, ray)
    _note_corners(book, centre, links, at_p)
    return True


def _note_corners(book: Book, centre: Centre, links: Sequence[_Link], at_p: Value) -> None:
    """The angles at A and B of the triangle A B P, for what is projected later; acute ones where there are such."""
    first, second = links
    geometry = book.geometry
    inner = {
        link.point: difference(None, centre.rays[link.point].angle, geometry.direction(link.point, other.point))
        for link, other in ((first, second), (second, first))
    }
    if all(is_short(angle_sum(angle)) for angle in inner.values()):
        return
    note_angle(book, at_p)
    found = _at_end(book, centre, first, second, at_p)
    if not _is_arcsine(found) and _is_arcsine(other := _at_end(book, centre, second, first, at_p)):
        first, second, found = second, first, other
    a, b = first.point, second.point
    if first.is_exterior(inner[a]):
        assert isinstance(found, Total), "an obtuse angle is 180 degrees less an acute one"
        found = found.terms[1][1]
    at_a = first.note(centre, b, inner[a], lambda name: Value(name, "angle", found.number(True), found))
    half_turn, whole = AngleForm((), 180.0), AngleForm(((at_a, 1.0),))
    rest = half_turn.minus(half_turn.minus(whole) if first.is_exterior(inner[a]) else whole)
    rest = rest.minus(AngleForm(((at_p, 1.0),)))
    own = half_turn.minus(rest) if second.is_exterior(inner[b]) else rest
    second.note(centre, a, inner[b], lambda name: valued(name, own))


def _at_end(book: Book, centre: Centre, link: _Link, other: _Link, at_p: Value) -> Expression:
    """The angle of the triangle A B P at the point of a link, by the height from that of the other one."""
    arms = [centre.rays[end.point].arm for end in (link, other)]
    return by_height(arms[0], book.geometry.length(link.point, other.point), arms[1], at_p)


def _is_arcsine(angle: Expression) -> bool:
    """Whether an angle is found by one sine: an angle near to a right one or obtuse takes the base of the height."""
    return isinstance(angle, Applied) and angle.function == "arcsin"


class _Link(Struct, frozen=True, dict=True):
    """A link from a fixed pivot to the point of which ``term`` is the velocity; the centre is at ``place``."""

    book: Book
    term: Term
    place: complex

    @property
    def point(self) -> str:
        """The moving end."""
        return self.term.point

    @cached_property
    def pivot(self) -> str:
        """The fixed end, or nothing where the velocity is not across such a link."""
        return _pivot(self.book, self.term)

    @cached_property
    def share(self) -> float:
        """How far the centre is from the pivot in links, negative beyond it."""
        z = self.book.task.now.z
        return ((self.place - z[self.pivot]) / (z[self.point] - z[self.pivot])).real

    @property
    def is_between(self) -> bool:
        """Whether the centre lies on the link."""
        return 0.0 < self.share < 1.0

    @property
    def is_sharp(self) -> bool:
        """Whether the distance of the centre from the point is a good sum or difference of that from the pivot."""
        return not self.pivot or abs(self.share - 1.0) > _SHARP * abs(self.share)

    def angle(self, centre: Centre, other: str) -> Value:
        """The angle at the pivot between the line to the centre and that to the other pivot."""
        geometry, pivot, point = self.book.geometry, self.pivot, self.point
        line = geometry.direction(pivot, point)
        ray = line if self.share > 0 else Geometry.turned(line, 180.0)
        angle = difference(None, ray, geometry.direction(pivot, other))
        if is_single(angle_sum(angle)) or supplement(angle) is not None:
            return angle
        name = corner_name(pivot, other, point) if self.share > 0 else centre.corner(pivot, other)
        return valued(name, angle_sum(angle))

    def is_exterior(self, inner: Value) -> bool:
        """Whether the angle of the mechanism at the point is acute, and that of the triangle with P its supplement."""
        return self.share > 1.0 and inner.exact > 90.0

    def note(self, centre: Centre, other: str, inner: Value, line: Callable[[Name], Value]) -> Value:
        """Show the angle at the point between the rod to the ``other`` one and the link, by its line."""
        beyond = self.share > 1.0 and not self.is_exterior(inner)
        angle = line(centre.corner(self.point, other) if beyond else corner_name(self.point, self.pivot, other))
        assert angle.name is not None
        self.book.items.append(Derived(angle))
        self.book.values[angle.name] = angle
        same = Value(None, "angle", 180.0 - inner.exact, Constant(180.0, "angle") - inner)
        note_sum(self.book, angle, same if self.is_exterior(inner) else inner)
        return angle

    def rest(self, arm: Expression) -> Expression:
        """The distance of the centre from the point by that from the pivot."""
        link = self.book.geometry.length(self.pivot, self.point)
        if self.share < 0:
            return summed([(1, link), (1, arm)])
        return summed([(1, arm), (-1, link)] if self.share > 1 else [(1, link), (-1, arm)])


def _own(angle: Value) -> AngleForm:
    """An angle in a sum: by its name, or taken apart where it has none."""
    return angle_sum(angle) if angle.name is None else AngleForm(((angle, 1.0),))


def _is_given(angle: Value) -> bool:
    """Whether an angle or its supplement is given, or a right angle."""
    parts = angle_sum(angle).parts
    return not parts or (len(parts) == 1 and isinstance(parts[0][0], Value) and parts[0][0].expression is None)


def _pivot(book: Book, term: Term) -> str:
    """The fixed pivot of the link across which a velocity is, or nothing."""
    segment = term.way.facts.get("segment") if term.way.key == "ways.across" else None
    if not isinstance(segment, Segment) or segment.centre_of:
        return ""
    ends = {segment.start, segment.end} - {term.point}
    return next((name for name in ends if name in book.task.fixed), "")
