"""Which contact or thread comes next: one side is known, the other gives a rate or the motion of a centre."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from variantgen.methods.groups.contact import NoSlipContact, Side
from variantgen.methods.groups.group import Joined, PointPath
from variantgen.methods.groups.reached import Reached

_PARALLEL = 1e-9


def joined(so_far: Reached) -> Iterator[Joined]:
    """Groups that the contacts and threads of the scene allow now."""
    every = so_far.touches
    for number, touch in every.items():
        for known, sought in touch.ways:
            if not sought.is_rest and _is_known(so_far, known):
                group = _group(so_far, number, sought, every)
                if group is not None:
                    yield group


def _is_known(so_far: Reached, side: Side) -> bool:
    """Whether the velocity of a side can be worked out."""
    if side.is_rest:
        return True
    return so_far.is_known(side.centre) and _is_rate_known(so_far, side)


def _is_rate_known(so_far: Reached, side: Side) -> bool:
    return not side.lever or side.body in so_far.book.omega or side.body in so_far.translating


def _group(so_far: Reached, number: int, side: Side, every: Mapping[int, NoSlipContact]) -> Joined | None:
    """What the known velocity of a side tells of its body or centre."""
    centre, rate = so_far.is_known(side.centre), _is_rate_known(so_far, side)
    if centre and rate:
        return None
    if centre:
        return Joined(number, side.body) if side.body in so_far.open_bodies else None
    track = every[number].track if side is every[number].first else None
    track = track or so_far.track(side.centre, side.body)
    if rate:
        is_needed = side.centre in so_far.task.needed.points
        return Joined(number, point=side.centre, track=track) if track and is_needed else None
    second = _second(so_far, number, side, every)
    if second is None:
        return None
    return Joined(number, side.body, side.centre, second, track or every[second].track or _line(so_far, side))


def _second(so_far: Reached, number: int, side: Side, every: Mapping[int, NoSlipContact]) -> int | None:
    """Another contact of the same body about the same centre, with a known other side and a parallel tangent."""
    for other, touch in every.items():
        for known, own in touch.ways:
            same = other != number and (own.body, own.centre) == (side.body, side.centre)
            if same and own.lever and _is_known(so_far, known) and is_parallel(own.line, side.line):
                return other
    return None


def _line(so_far: Reached, side: Side) -> PointPath | None:
    """The straight path along the tangent, if the centre moves on it."""
    now = so_far.task.now
    vectors = [now.v[side.centre], *([now.a[side.centre]] if now.accelerated else [])]
    along = all(is_parallel(vector, side.line) for vector in vectors)
    return PointPath(side.centre, line=side.line) if along else None


def is_parallel(first: complex, second: complex) -> bool:
    """Whether two vectors are parallel."""
    return abs((first.conjugate() * second).imag) <= _PARALLEL * abs(first) * abs(second)
