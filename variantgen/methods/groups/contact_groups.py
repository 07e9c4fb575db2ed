"""Which contact or thread comes next: one side is known, the other gives a rate or the motion of a centre."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from variantgen.methods.groups.contact import ContactSide, NoSlipContact
from variantgen.methods.groups.group import ContactGroup, PointPath
from variantgen.methods.groups.reached import KnownMotion

_PARALLEL = 1e-9


def contact_groups(so_far: KnownMotion) -> Iterator[ContactGroup]:
    """Groups that the contacts and threads of the scene allow now."""
    every = so_far.contacts
    for number, contact in every.items():
        for known, sought in contact.ways:
            if not sought.is_rest and _is_known(so_far, known):
                group = _group(so_far, number, sought, every)
                if group is not None:
                    yield group


def _is_known(so_far: KnownMotion, side: ContactSide) -> bool:
    """Whether the velocity of a side can be worked out."""
    if side.is_rest:
        return True
    return so_far.is_known(side.centre) and _is_rate_known(so_far, side)


def _is_rate_known(so_far: KnownMotion, side: ContactSide) -> bool:
    return not side.lever or side.body in so_far.book.omega or side.body in so_far.translating


def _group(
    so_far: KnownMotion, number: int, side: ContactSide, every: Mapping[int, NoSlipContact]
) -> ContactGroup | None:
    """What the known velocity of a side tells of its body or centre."""
    centre, rate = so_far.is_known(side.centre), _is_rate_known(so_far, side)
    if centre and rate:
        return None
    if centre:
        return ContactGroup(number, side.body) if side.body in so_far.open_bodies else None
    point_path = every[number].point_path if side is every[number].first else None
    point_path = point_path or so_far.point_path(side.centre, side.body)
    if rate:
        is_needed = side.centre in so_far.task.needed.points
        return ContactGroup(number, point=side.centre, point_path=point_path) if point_path and is_needed else None
    second = _second(so_far, number, side, every)
    if second is None:
        return None
    return ContactGroup(
        number, side.body, side.centre, second, point_path or every[second].point_path or _line(so_far, side)
    )


def _second(so_far: KnownMotion, number: int, side: ContactSide, every: Mapping[int, NoSlipContact]) -> int | None:
    """Another contact of the same body about the same centre, with a known other side and a parallel tangent."""
    for other, contact in every.items():
        for known, own in contact.ways:
            same = other != number and (own.body, own.centre) == (side.body, side.centre)
            if same and own.lever and _is_known(so_far, known) and is_parallel(own.line, side.line):
                return other
    return None


def _line(so_far: KnownMotion, side: ContactSide) -> PointPath | None:
    """The straight path along the tangent, if the centre moves on it."""
    now = so_far.task.now
    vectors = [now.v[side.centre], *([now.a[side.centre]] if now.accelerated else [])]
    along = all(is_parallel(vector, side.line) for vector in vectors)
    return PointPath(side.centre, line=side.line) if along else None


def is_parallel(first: complex, second: complex) -> bool:
    """Whether two vectors are parallel."""
    return abs((first.conjugate() * second).imag) <= _PARALLEL * abs(first) * abs(second)
