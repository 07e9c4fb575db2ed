"""Angles, dimensions and radii in words: where the figure marks them."""

from __future__ import annotations

from itertools import pairwise

from variantgen.families.figure_hints import AngleMark, DiscMark, LengthMark, RightAngle
from variantgen.families.hints import DIRECTIONS
from variantgen.figure.telling.directions import is_parallel
from variantgen.figure.telling.teller import Teller
from variantgen.wording.formula import to_plain

_AXES = {1: "ray_right", 1j: "ray_up", -1: "ray_left", -1j: "ray_down"}
_LEVEL = 0.05  # u: how far a point may be from the line to which a dimension is carried over
_ON_LINE = 1e-6


def marks(teller: Teller) -> list[str]:
    """A phrase for each given angle, right angle, given dimension and radius."""
    figure = teller.board.form.figure
    seen = {*teller.board.shown, *DIRECTIONS, *figure.hidden}
    found = [_angle(teller, mark) for mark in figure.angles if mark.name in teller.board.given]
    found += [_right_angle(teller, mark) for mark in figure.right_angles if {mark.at, mark.start, mark.end} <= seen]
    found += [_length(teller, mark) for mark in figure.lengths if mark.name in teller.board.given]
    return found + [_radius(teller, mark) for mark in figure.discs if mark.name in teller.board.given]


def _symbol(teller: Teller, name: str) -> str:
    return to_plain(teller.board.symbol(name))


def _angle(teller: Teller, mark: AngleMark) -> str:
    rays = [_ray(teller, mark.at, end) for end in (mark.start, mark.end)]
    return teller.say(
        "angle", symbol=_symbol(teller, mark.name), corner=_at(teller, mark.at), first=rays[0], second=rays[1]
    )


def _right_angle(teller: Teller, mark: RightAngle) -> str:
    rays = [_ray(teller, mark.at, end) for end in (mark.start, mark.end)]
    return teller.say("right_angle", corner=_at(teller, mark.at), first=rays[0], second=rays[1])


def _at(teller: Teller, corner: str) -> str:
    return teller.say("at_corner", corner=teller.name(corner)) if teller.is_shown(corner) else ""


def _ray(teller: Teller, corner: str, end: str) -> str:
    """A ray from a corner: two letters, or what the figure shows there, or its direction."""
    if teller.is_shown(end) and teller.is_shown(corner):
        return teller.name(corner) + teller.name(end)
    board = teller.board
    ray = complex(board.frame.place(DIRECTIONS[end])) if end in DIRECTIONS else teller.at(end) - teller.at(corner)
    ray /= abs(ray)
    axis = _AXES.get(complex(round(ray.real), round(ray.imag)))
    if axis and abs(abs(ray.real) + abs(ray.imag) - 1) < _ON_LINE:
        return teller.say(axis)
    for arrow in teller.arrows:
        if arrow.point == corner and abs(arrow.way - ray) < _ON_LINE:
            return teller.say("ray_of_vector", symbol=arrow.symbol)
    key = _carrier(teller, corner, ray)
    return teller.say(key, way=teller.way(ray))


def _carrier(teller: Teller, corner: str, ray: complex) -> str:
    """The key of what lies along a ray: a slot, a wall, the guide of the corner, or nothing but a direction."""
    board, place = teller.board, teller.at(corner)
    figure = board.form.figure
    for key, paths in (("ray_of_slot", figure.grooves), ("ray_of_wall", figure.walls)):
        for names in paths:
            for first, second in pairwise(names):
                start, step = teller.at(first), teller.at(second) - teller.at(first)
                if is_parallel(step, ray) and abs(((place - start) * step.conjugate()).imag) < _LEVEL * abs(step):
                    return key
    guide = teller.guided.get(corner)
    return "ray_of_guide" if guide is not None and is_parallel(guide, ray) else "ray_of_direction"


def _length(teller: Teller, mark: LengthMark) -> str:
    way = teller.at(mark.end) - teller.at(mark.start)
    ends = [_bearer(teller, point, way) for point in (mark.start, mark.end)]
    return teller.say("length", symbol=_symbol(teller, mark.name), first=ends[0], second=ends[1], line=teller.line(way))


def _bearer(teller: Teller, point: str, way: complex) -> str:
    """The named point to which one end of a dimension is carried over: itself, or the nearest across ``way``."""
    if teller.is_shown(point):
        return teller.name(point)
    unit, place = way / abs(way), teller.at(point)
    level = [
        other for other in teller.board.shown if abs(((teller.at(other) - place) * unit.conjugate()).real) < _LEVEL
    ]
    return teller.name(min(level, key=lambda other: abs(teller.at(other) - place), default=""))


def _radius(teller: Teller, mark: DiscMark) -> str:
    """A radius, with the size of its circle where several are about one centre."""
    concentric = sorted(circle.radius for circle in teller.circles if circle.mark.centre == mark.centre)
    own = next((circle.radius for circle in teller.circles if circle.mark is mark), 0.0)
    key = "radius"
    if len(concentric) > 1:
        sizes = {concentric[0]: "radius_of_smaller", concentric[-1]: "radius_of_larger"}
        key = sizes.get(own, "radius_of_middle")
    centre = teller.say("with_centre", centre=teller.name(mark.centre)) if teller.is_shown(mark.centre) else ""
    return teller.say(key, symbol=_symbol(teller, mark.name), centre=centre)
