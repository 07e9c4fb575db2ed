"""Sliders in fixed guides, bearings of rods, ends on walls; a guide that is not drawn is not described."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from variantgen.figure.alt_text.alt_text import AltText
from variantgen.figure.alt_text.directions import is_parallel, side
from variantgen.mechanism.joints.guide import Guide

_ON_WALL = 1e-3  # u
_SIDES = {"e": "right_of_it", "w": "left_of_it", "n": "above_it", "s": "below_it"}


def tell(alt_text: AltText, items: Sequence[Guide]) -> list[str]:
    """A clause for each guide; a load on a rope is described with its rope."""
    loads = alt_text.board.loads
    return [text for joint in items if joint.point not in loads and (text := _clause(alt_text, joint))]


def _clause(alt_text: AltText, joint: Guide) -> str:
    board, point = alt_text.board, joint.point
    way = alt_text.heading(joint.angle)
    name, line = alt_text.name(point), alt_text.inclined(way)
    if point in board.form.figure.bare:
        where = _side_of_wall(alt_text, point, way)
        return alt_text.say("guide_wall", point=name, line=line, side=where) if where else ""
    alt_text.guided[point] = way
    if point in board.form.figure.stems:
        body = alt_text.body(alt_text.owners(point)[0])
        where = alt_text.say("guide_at", point=name) if name else ""
        return alt_text.say("guide_bearing", body=body, where=where, line=line)
    alone = all(len(board.form.bodies[body]) == 1 for body in alt_text.owners(point))  # it is the block itself
    if board.is_translated(point) and not alone:
        alt_text.hinged.add(point)
        bodies = alt_text.parts(alt_text.owners(point))
        return alt_text.say("guide_rigid", point=name, bodies=bodies, line=line)
    return alt_text.say("guide", point=name, hinged=alt_text.hinge(point), line=line)


def _side_of_wall(alt_text: AltText, point: str, way: complex) -> str:
    """On which side of a wall through the point the mechanism lies; nothing if there is no such wall."""
    place = alt_text.at(point)
    seen = [alt_text.at(name) for name in alt_text.board.shown]
    middle = sum(seen) / len(seen)
    for names in alt_text.board.form.figure.walls:
        for first, second in pairwise(names):
            start, step = alt_text.at(first), alt_text.at(second) - alt_text.at(first)
            normal = 1j * step / abs(step)
            if is_parallel(step, way) and abs(((place - start) * normal.conjugate()).real) < _ON_WALL:
                inner = normal if ((middle - start) * normal.conjugate()).real > 0 else -normal
                return alt_text.say(_SIDES[side(inner)[0]])
    return ""
