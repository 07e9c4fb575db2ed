"""Ropes, station by station from one end to the other."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from variantgen.figure.alt_text.alt_text import AltText
from variantgen.mechanism.constructions.tangent import thread_direction
from variantgen.mechanism.joints.rope import Bend, Rope

Path = tuple[Bend, ...]


def tell(alt_text: AltText, items: Sequence[Rope]) -> list[str]:
    """A clause for each rope or belt; ropes that meet on one rim are one."""
    closed = {id(joint.path[-1]) for joint in items if joint.closing}
    paths = _joined([joint.path for joint in items])
    return [_belt(alt_text, path[:-1]) if id(path[-1]) in closed else _clause(alt_text, path) for path in paths]


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


def _clause(alt_text: AltText, path: Path) -> str:
    ways = [_straight(alt_text, first, second) for first, second in pairwise(path)]
    names = []
    for i in range(len(path)):
        arriving = ways[i - 1] if i > 0 else None
        leaving = ways[i] if i < len(ways) else None
        if arriving is not None and leaving is not None:
            names.append(_bend(alt_text, path, i, arriving - leaving))
        else:
            names.append(_end(alt_text, path, i, leaving if leaving is not None else arriving or 0j))
    return alt_text.say("rope", stations=alt_text.say("rope_then").join(names))


def _belt(alt_text: AltText, path: Path) -> str:
    """A closed belt from its first pulley to its last, from which it comes back to the first."""
    ways = [_straight(alt_text, first, second) for first, second in pairwise((*path, path[0]))]
    names = [_bend(alt_text, path, i, ways[i - 1] - ways[i]) for i in range(len(path))]
    is_crossed = len(path) == 2 and path[0].side != path[1].side
    return alt_text.say("belt_crossed" if is_crossed else "belt", stations=alt_text.say("rope_then").join(names))


def _straight(alt_text: AltText, first: Bend, second: Bend) -> complex:
    """The direction of a straight piece on paper."""
    circles = [
        (
            alt_text.at(bend.point),
            float(bend.radius) * alt_text.board.sketch.scale,
            float(alt_text.board.frame.sense * bend.side),
        )
        for bend in (first, second)
    ]
    return complex(thread_direction(*circles[0], *circles[1])[0])


def _bend(alt_text: AltText, path: Path, i: int, outwards: complex) -> str:
    """A pulley in between: ``outwards`` points from its centre to the middle of the wrap, or is near zero."""
    bend = path[i]
    touch = alt_text.say("rope_round", side=alt_text.side(outwards)) if abs(outwards) > 1e-3 else ""
    if bend.body is not None:
        return _rim(alt_text, bend, bend.body, touch)
    return alt_text.say("rope_pulley" if bend.fixed else "rope_block", place=_place(alt_text, path, i), touch=touch)


def _end(alt_text: AltText, path: Path, i: int, way: complex) -> str:
    """An end: a drum, an anchor, a load, or a point of a body; ``way`` is that of the rope at this end."""
    bend = path[i]
    if bend.body is not None:
        touch = alt_text.say(
            "rope_leaves", side=alt_text.side(1j * float(alt_text.board.frame.sense * bend.side) * way)
        )
        return _rim(alt_text, bend, bend.body, touch)
    if bend.fixed:
        return alt_text.say("rope_anchor", place=_place(alt_text, path, i))
    is_load = bend.point in alt_text.board.loads
    if not is_load and (alt_text.owners(bend.point) or alt_text.is_shown(bend.point)):
        return alt_text.say("rope_point", point=alt_text.name(bend.point))
    if alt_text.is_shown(bend.point):
        return alt_text.say("rope_load", point=alt_text.name(bend.point))
    return alt_text.say("rope_nameless_load", place=_place(alt_text, path, i))


def _rim(alt_text: AltText, bend: Bend, body: str, touch: str) -> str:
    """A drum, of a stepped one the rim that the rope is on."""
    larger = alt_text.is_larger(body, float(bend.radius) * alt_text.board.sketch.scale)
    key = "rope_disc" if larger is None else "rope_larger_rim" if larger else "rope_smaller_rim"
    return alt_text.say(key, disc=alt_text.disc(bend.point, body), touch=touch)


def _place(alt_text: AltText, path: Path, i: int) -> str:
    """Where a station without a name lies: seen from the nearest station on the rope that has a name."""
    if alt_text.is_shown(path[i].point):
        return alt_text.name(path[i].point)
    others = sorted(range(len(path)), key=lambda k: abs(k - i))
    origin = next((path[k].point for k in others if alt_text.is_shown(path[k].point)), "")
    return alt_text.place(alt_text.at(path[i].point) - alt_text.at(origin), alt_text.name(origin)) if origin else ""
