"""Angles, dimensions and radii in words: where the figure marks them."""

from __future__ import annotations

from itertools import pairwise

from variantgen.families.figure_hints import AngleMark, DiscMark, LengthMark, RightAngle
from variantgen.families.hints import DIRECTIONS
from variantgen.figure.alt_text.alt_text import AltText
from variantgen.figure.alt_text.directions import is_parallel
from variantgen.wording.formula import to_plain

_AXES = {1: "ray_right", 1j: "ray_up", -1: "ray_left", -1j: "ray_down"}
_LEVEL = 0.05  # u: how far a point may be from the line to which a dimension is carried over
_ON_LINE = 1e-6


def marks(alt_text: AltText) -> list[str]:
    """A phrase for each given angle, right angle, given dimension and radius."""
    figure = alt_text.board.form.figure
    seen = {*alt_text.board.shown, *DIRECTIONS, *figure.hidden}
    found = [_angle(alt_text, mark) for mark in figure.angles if mark.name in alt_text.board.given]
    found += [_right_angle(alt_text, mark) for mark in figure.right_angles if {mark.at, mark.start, mark.end} <= seen]
    found += [_length(alt_text, mark) for mark in figure.lengths if mark.name in alt_text.board.given]
    return found + [_radius(alt_text, mark) for mark in figure.discs if mark.name in alt_text.board.given]


def _symbol(alt_text: AltText, name: str) -> str:
    return to_plain(alt_text.board.symbol(name))


def _angle(alt_text: AltText, mark: AngleMark) -> str:
    rays = [_ray(alt_text, mark.at, end) for end in (mark.start, mark.end)]
    return alt_text.say(
        "angle", symbol=_symbol(alt_text, mark.name), corner=_at(alt_text, mark.at), first=rays[0], second=rays[1]
    )


def _right_angle(alt_text: AltText, mark: RightAngle) -> str:
    rays = [_ray(alt_text, mark.at, end) for end in (mark.start, mark.end)]
    return alt_text.say("right_angle", corner=_at(alt_text, mark.at), first=rays[0], second=rays[1])


def _at(alt_text: AltText, corner: str) -> str:
    return alt_text.say("at_corner", corner=alt_text.name(corner)) if alt_text.is_shown(corner) else ""


def _ray(alt_text: AltText, corner: str, end: str) -> str:
    """A ray from a corner: two letters, or what the figure shows there, or its direction."""
    if alt_text.is_shown(end) and alt_text.is_shown(corner):
        return alt_text.name(corner) + alt_text.name(end)
    board = alt_text.board
    ray = complex(board.frame.place(DIRECTIONS[end])) if end in DIRECTIONS else alt_text.at(end) - alt_text.at(corner)
    ray /= abs(ray)
    axis = _AXES.get(complex(round(ray.real), round(ray.imag)))
    if axis and abs(abs(ray.real) + abs(ray.imag) - 1) < _ON_LINE:
        return alt_text.say(axis)
    for arrow in alt_text.arrows:
        if arrow.point == corner and abs(arrow.way - ray) < _ON_LINE:
            return alt_text.say("ray_of_vector", symbol=arrow.symbol)
    key = _carrier(alt_text, corner, ray)
    return alt_text.say(key, way=alt_text.way(ray))


def _carrier(alt_text: AltText, corner: str, ray: complex) -> str:
    """The key of what lies along a ray: a slot, a wall, the guide of the corner, or nothing but a direction."""
    board, place = alt_text.board, alt_text.at(corner)
    figure = board.form.figure
    for key, paths in (("ray_of_slot", figure.grooves), ("ray_of_wall", figure.walls)):
        for names in paths:
            for first, second in pairwise(names):
                start, step = alt_text.at(first), alt_text.at(second) - alt_text.at(first)
                if is_parallel(step, ray) and abs(((place - start) * step.conjugate()).imag) < _LEVEL * abs(step):
                    return key
    guide = alt_text.guided.get(corner)
    return "ray_of_guide" if guide is not None and is_parallel(guide, ray) else "ray_of_direction"


def _length(alt_text: AltText, mark: LengthMark) -> str:
    way = alt_text.at(mark.end) - alt_text.at(mark.start)
    ends = [_bearer(alt_text, point, way) for point in (mark.start, mark.end)]
    return alt_text.say(
        "length", symbol=_symbol(alt_text, mark.name), first=ends[0], second=ends[1], line=alt_text.line(way)
    )


def _bearer(alt_text: AltText, point: str, way: complex) -> str:
    """The named point to which one end of a dimension is carried over: itself, or the nearest across ``way``."""
    if alt_text.is_shown(point):
        return alt_text.name(point)
    unit, place = way / abs(way), alt_text.at(point)
    level = [
        other for other in alt_text.board.shown if abs(((alt_text.at(other) - place) * unit.conjugate()).real) < _LEVEL
    ]
    return alt_text.name(min(level, key=lambda other: abs(alt_text.at(other) - place), default=""))


def _radius(alt_text: AltText, mark: DiscMark) -> str:
    """A radius, with the size of its circle where several are about one centre."""
    concentric = sorted(circle.radius for circle in alt_text.circles if circle.mark.centre == mark.centre)
    own = next((circle.radius for circle in alt_text.circles if circle.mark is mark), 0.0)
    key = "radius"
    if len(concentric) > 1:
        sizes = {concentric[0]: "radius_of_smaller", concentric[-1]: "radius_of_larger"}
        key = sizes.get(own, "radius_of_middle")
    centre = alt_text.say("with_centre", centre=alt_text.name(mark.centre)) if alt_text.is_shown(mark.centre) else ""
    return alt_text.say(key, symbol=_symbol(alt_text, mark.name), centre=centre)
