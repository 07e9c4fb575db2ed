"""Ropes, station by station from one end to the other."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from variantgen.figure.telling.teller import Teller
from variantgen.mechanism.constructions.tangent import thread_direction
from variantgen.mechanism.joints.rope import Bend, Rope

Path = tuple[Bend, ...]


def tell(teller: Teller, items: Sequence[Rope]) -> list[str]:
    """A clause for each rope; two that meet on one rim are one."""
    return [_clause(teller, path) for path in _joined([joint.path for joint in items])]


def _joined(paths: Sequence[Path]) -> list[Path]:
    """Ropes that end on the rim on which the next one starts are a single rope for the eye."""
    found: list[Path] = []
    for path in paths:
        last = found[-1][-1] if found else None
        first = path[0]
        if last is not None and last.body is not None and _same_rim(last, first):
            found[-1] = (*found[-1], *path[1:])
        else:
            found.append(path)
    return found


def _same_rim(first: Bend, second: Bend) -> bool:
    same = (first.point, first.body) == (second.point, second.body)
    return same and math.isclose(float(first.radius), float(second.radius), rel_tol=1e-9)


def _clause(teller: Teller, path: Path) -> str:
    ways = [_straight(teller, first, second) for first, second in pairwise(path)]
    names = []
    for i in range(len(path)):
        arriving = ways[i - 1] if i > 0 else None
        leaving = ways[i] if i < len(ways) else None
        if arriving is not None and leaving is not None:
            names.append(_bend(teller, path, i, arriving - leaving))
        else:
            names.append(_end(teller, path, i, leaving if leaving is not None else arriving or 0j))
    return teller.say("rope", stations=teller.say("rope_then").join(names))


def _straight(teller: Teller, first: Bend, second: Bend) -> complex:
    """The direction of a straight piece on paper."""
    circles = [
        (
            teller.at(bend.point),
            float(bend.radius) * teller.board.sketch.scale,
            float(teller.board.frame.sense * bend.side),
        )
        for bend in (first, second)
    ]
    return complex(thread_direction(*circles[0], *circles[1])[0])


def _bend(teller: Teller, path: Path, i: int, outwards: complex) -> str:
    """A pulley in between: ``outwards`` points from its centre to the middle of the wrap, or is near zero."""
    bend = path[i]
    touch = teller.say("rope_round", side=teller.side(outwards)) if abs(outwards) > 1e-3 else ""
    if bend.body is not None:
        return teller.say("rope_disc", disc=teller.disc(bend.point, bend.body), touch=touch)
    return teller.say("rope_pulley", place=_place(teller, path, i), touch=touch)


def _end(teller: Teller, path: Path, i: int, way: complex) -> str:
    """An end: a drum, an anchor, a load, or a point of a body; ``way`` is that of the rope at this end."""
    bend = path[i]
    if bend.body is not None:
        touch = teller.say("rope_leaves", side=teller.side(1j * float(teller.board.frame.sense * bend.side) * way))
        larger = teller.is_larger(bend.body, float(bend.radius) * teller.board.sketch.scale)
        if larger is None:
            return teller.say("rope_disc", disc=teller.disc(bend.point, bend.body), touch=touch)
        key = "rope_larger_rim" if larger else "rope_smaller_rim"
        return teller.say(key, disc=teller.disc(bend.point, bend.body, "_of"), touch=touch)
    if bend.fixed:
        return teller.say("rope_anchor", place=_place(teller, path, i))
    if teller.owners(bend.point):
        return teller.say("rope_point", point=teller.name(bend.point))
    if teller.is_shown(bend.point):
        return teller.say("rope_load", point=teller.name(bend.point))
    return teller.say("rope_nameless_load", place=_place(teller, path, i))


def _place(teller: Teller, path: Path, i: int) -> str:
    """Where a station without a name lies: seen from the nearest station on the rope that has a name."""
    if teller.is_shown(path[i].point):
        return teller.name(path[i].point)
    others = sorted(range(len(path)), key=lambda k: abs(k - i))
    origin = next((path[k].point for k in others if teller.is_shown(path[k].point)), "")
    return teller.place(teller.at(path[i].point) - teller.at(origin), teller.name(origin)) if origin else ""
