"""Theorem on projections of velocities: ``v_A cos alpha = v_B cos beta`` on the line AB (guide, 3.1.3, formula 60)."""

from __future__ import annotations

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.methods.geometry.angle_sums import difference
from variantgen.methods.geometry.geometry import Geometry, between
from variantgen.methods.groups.group import Dyad
from variantgen.methods.groups.wanted import is_rate_wanted
from variantgen.methods.solution.book import Book, resultant
from variantgen.methods.solution.named_angles import named
from variantgen.methods.steps.step import Body, Fact, Point, Projection, Segment, Sentence, Share, Term, VectorOf
from variantgen.methods.vectors.contacts.contact_parts import enter_rate
from variantgen.methods.vectors.natural_sum import ordered_sum, signed
from variantgen.methods.vectors.point_paths import on_path
from variantgen.methods.vectors.points import vector
from variantgen.methods.vectors.vector_equation import named_shares, share_of

_NOTHING = 1e-10  # of the natural scale
_SQUARE = 1e-9  # cosine of an angle that is a right one, but for rounding


def applies(book: Book, group: Dyad) -> bool:
    """Whether the projections on the line of the points give the velocity: not if it is across that line."""
    now, point = book.task.now, group.point_path.point
    side = now.z[point] - now.z[group.pole]
    path = group.point_path.line if group.point_path.straight else 1j * (now.z[point] - now.z[group.point_path.centre])
    return book.order == 1 and not _are_square(side, path)


def _are_square(first: complex, second: complex) -> bool:
    """Whether two vectors are across each other, but for rounding."""
    return abs((first.conjugate() * second).real) <= _SQUARE * abs(first) * abs(second)


def solve_dyad(book: Book, group: Dyad) -> None:
    """Find the velocity of the point on its path; omega, which the theorem leaves open, by the components across."""
    body, pole, point = group.body, group.pole, group.point_path.point
    known = vector(book, pole)
    facts: dict[str, Fact] = {
        "body": Body(body),
        "pole": Point(pole),
        "point": Point(point),
        "vector": VectorOf(Name("v", pole)),
        "sought": VectorOf(Name("v", point)),
        "segment": Segment(pole, point),
    }
    with book.step("projections.link", "velocity_projections", **facts):
        _, path = on_path(book, group.point_path)
        side = book.geometry.vector(pole, point)
        if not known or _are_square(side, resultant(known)):
            book.say("projections.nothing" if known else "projections.at_rest", False, **facts)
            book.velocity[point] = ()
        else:
            _equate(book, pole, path, facts)
    if is_rate_wanted(book.task, 1, body, {point, pole}):
        with book.step("projections.rotation", "velocity_projections", **facts):
            _compare_across(book, body, pole, point)


def _equate(book: Book, pole: str, path: Term, facts: dict[str, Fact]) -> None:
    """Project both velocities on their line, to the side where the projections are positive."""
    known, point = book.velocity[pole], path.point
    ahead = book.geometry.direction(pole, point)
    back = (resultant(known) * book.geometry.vector(pole, point).conjugate()).real < 0
    axis = Geometry.turned(ahead, 180.0) if back else ahead
    start, end = (point, pole) if back else (pole, point)
    way = path.angle if between(path.angle.exact, axis.exact) < 90.0 else Geometry.turned(path.angle, 180.0)
    path = Term(path.name, None, way, path.way)
    book.say("projections.theorem", False, **facts)
    segment = Segment(pole, point)
    first, second = named_shares(book, known, axis, segment), named(book, _share(path, axis), segment)
    line = Sentence("projections.same_sign", {"start": Point(start), "end": Point(end)})
    book.items.append(Projection((line,), first, (second,)))
    speed, beside = ordered_sum(signed(first)), second.factor
    size = book.derive(path.name, "velocity", speed if beside is None else speed / beside)
    book.velocity[point] = (Term(path.name, size, path.angle, path.way),)


def _compare_across(book: Book, body: str, pole: str, point: str) -> None:
    """``omega = (v_B across - v_A across) / AB``, to the left of AB positive."""
    axis = Geometry.turned(book.geometry.direction(pole, point), 90.0)
    at_pole = [(-sign, part) for sign, part in signed(named_shares(book, book.velocity[pole], axis))]
    own = signed(named_shares(book, book.velocity[point], axis))
    if book.velocity[point] and not own:
        lying: dict[str, Fact] = {"vector": VectorOf(Name("v", point)), "segment": Segment(pole, point)}
        book.say("projections.along", point=Point(point), **lying)
    parts = [*own, *at_pole]
    turning = sum(sign * part.number(True) for sign, part in parts)
    sense = 0 if abs(turning) <= _NOTHING * book.scale else 1 if turning > 0 else -1
    if sense:
        book.say("projections.across", segment=Segment(pole, point), omega=Name("omega", body))
    size = ordered_sum([(sign * sense, part) for sign, part in parts]) if sense else None
    enter_rate(book, body, size, sense, book.geometry.length(pole, point))


def _share(term: Term, axis: Value) -> Share:
    """The positive projection of a vector that is not across the axis."""
    share = share_of(term, axis)
    if share is None:  # so near to a right angle that the projection of a vector equation leaves it out
        return Share(1, term, difference(None, term.angle, axis))
    assert share.sign > 0
    return share
