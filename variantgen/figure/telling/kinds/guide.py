"""Sliders in fixed guides, bearings of rods, ends on walls; a guide that is not drawn is not told."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from variantgen.figure.telling.directions import is_parallel, side
from variantgen.figure.telling.teller import Teller
from variantgen.mechanism.joints.guide import Guide

_ON_WALL = 1e-3  # u
_SIDES = {"e": "right_of_it", "w": "left_of_it", "n": "above_it", "s": "below_it"}


def tell(teller: Teller, items: Sequence[Guide]) -> list[str]:
    """A clause for each guide; a load on a rope is told with its rope."""
    loads = teller.board.loads
    return [text for joint in items if joint.point not in loads and (text := _clause(teller, joint))]


def _clause(teller: Teller, joint: Guide) -> str:
    board, point = teller.board, joint.point
    way = teller.heading(joint.angle)
    name, line = teller.name(point), teller.inclined(way)
    if point in board.form.figure.bare:
        where = _side_of_wall(teller, point, way)
        return teller.say("guide_wall", point=name, line=line, side=where) if where else ""
    teller.guided[point] = way
    if point in board.form.figure.stems:
        body = teller.body(teller.owners(point)[0])
        where = teller.say("guide_at", point=name) if name else ""
        return teller.say("guide_bearing", body=body, where=where, line=line)
    if board.is_translated(point):
        teller.hinged.add(point)
        bodies = teller.listed([teller.part(body, "_with") for body in teller.owners(point)])
        return teller.say("guide_rigid", point=name, bodies=bodies, line=line)
    return teller.say("guide", point=name, hinged=teller.hinge(point), line=line)


def _side_of_wall(teller: Teller, point: str, way: complex) -> str:
    """On which side of a wall through the point the mechanism lies; nothing if there is no such wall."""
    place = teller.at(point)
    seen = [teller.at(name) for name in teller.board.shown]
    middle = sum(seen) / len(seen)
    for names in teller.board.form.figure.walls:
        for first, second in pairwise(names):
            start, step = teller.at(first), teller.at(second) - teller.at(first)
            normal = 1j * step / abs(step)
            if is_parallel(step, way) and abs(((place - start) * normal.conjugate()).real) < _ON_WALL:
                inner = normal if ((middle - start) * normal.conjugate()).real > 0 else -normal
                return teller.say(_SIDES[side(inner)[0]])
    return ""
