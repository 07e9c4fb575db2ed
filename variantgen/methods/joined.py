"""Which contact or thread comes next: one side is known, the other gives a rate or the motion of a centre."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from variantgen.methods.contact import Side, Touch
from variantgen.methods.group import Joined, Track

if TYPE_CHECKING:
    from variantgen.methods.route import Route

_PARALLEL = 1e-9


def joined(route: Route) -> Iterator[Joined]:
    """Groups that the contacts and threads of the scene allow now."""
    every = route.touches
    for number, touch in every.items():
        for known, sought in touch.ways:
            if not sought.is_rest and _is_known(route, known):
                group = _group(route, number, sought, every)
                if group is not None:
                    yield group


def _is_known(route: Route, side: Side) -> bool:
    """Whether the velocity of a side can be worked out."""
    if side.is_rest:
        return True
    return route.is_known(side.centre) and _is_rate_known(route, side)


def _is_rate_known(route: Route, side: Side) -> bool:
    return not side.lever or side.body in route.book.omega or side.body in route.translating


def _group(route: Route, number: int, side: Side, every: Mapping[int, Touch]) -> Joined | None:
    """What the known velocity of a side tells of its body or centre."""
    centre, rate = route.is_known(side.centre), _is_rate_known(route, side)
    if centre and rate:
        return None
    if centre:
        return Joined(number, side.body) if side.body in route.open_bodies else None
    track = every[number].track if side is every[number].first else None
    track = track or route.track(side.centre, side.body)
    if rate:
        is_needed = side.centre in route.task.needed.points
        return Joined(number, point=side.centre, track=track) if track and is_needed else None
    second = _second(route, number, side, every)
    if second is None:
        return None
    return Joined(number, side.body, side.centre, second, track or every[second].track or _line(route, side))


def _second(route: Route, number: int, side: Side, every: Mapping[int, Touch]) -> int | None:
    """Another contact of the same body about the same centre, with a known other side and a parallel tangent."""
    for other, touch in every.items():
        for known, own in touch.ways:
            same = other != number and (own.body, own.centre) == (side.body, side.centre)
            if same and own.lever and _is_known(route, known) and is_parallel(own.line, side.line):
                return other
    return None


def _line(route: Route, side: Side) -> Track | None:
    """The straight path along the tangent, if the centre moves on it."""
    now = route.task.now
    vectors = [now.v[side.centre], *([now.a[side.centre]] if now.accelerated else [])]
    along = all(is_parallel(vector, side.line) for vector in vectors)
    return Track(side.centre, line=side.line) if along else None


def is_parallel(first: complex, second: complex) -> bool:
    """Whether two vectors are parallel."""
    return abs((first.conjugate() * second).imag) <= _PARALLEL * abs(first) * abs(second)
