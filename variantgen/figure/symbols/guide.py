"""Slider in a fixed guide: a block on a hatched line; under a load on a rope only where it does not hang."""

from __future__ import annotations

import math
from itertools import pairwise

from variantgen.figure.board import Board
from variantgen.figure.drawing import Layer
from variantgen.figure.sketch import HINGE
from variantgen.figure.symbols._hoist import HALF_LOAD
from variantgen.mechanism.joints.guide import Guide

_HALF_LENGTH, _HALF_HEIGHT, _OVERHANG = 2.9, 1.7, 5.5
_HALF_BEARING = 1.1
_BESIDE = 6.4  # from the middle of a bearing to a point with a name, u
_ON_ROD = 0.1  # distance from the line of a rod, u
_UPRIGHT = 1e-6  # cosine of the angle of a vertical line


def draw(board: Board, joint: Guide) -> None:
    """Add the symbol; a load on a rope has a symbol of its own, the end of a ladder needs no block."""
    way = complex(board.frame.direction(joint.angle))
    if joint.point in board.loads and abs(way.real) > _UPRIGHT:
        _draw_ground(board, joint.point, way, -1j * way * math.copysign(1.0, way.real), HALF_LOAD)
    if joint.point in board.loads or joint.point in board.form.figure.bare:
        return
    sketch = board.sketch
    centre = sketch.at[joint.point]
    if joint.point in board.form.figure.stems:
        _draw_bearing(board, joint.point, way)
        return
    side = _free_side(board, joint.point, way)
    corners = [
        centre + x * _HALF_LENGTH * way + y * _HALF_HEIGHT * side for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    _draw_ground(board, joint.point, way, side, _HALF_HEIGHT)
    if board.is_translated(joint.point):
        # Fixed to its rod: the rod is seen to run through the block, and nothing can turn.
        sketch.path(corners, Layer.DISC, closed=True, fill="paper")
    else:
        sketch.path(corners, Layer.SLIDER, closed=True, fill="paper")
        sketch.circle(centre, HINGE, Layer.HINGE, fill="paper")
    for taken in (way, -way, side):
        sketch.occupy(joint.point, taken)
    board.sized(joint.point, _HALF_LENGTH, box=corners)


def _draw_ground(board: Board, point: str, way: complex, side: complex, off: float) -> None:
    """The hatched line on which a block slides, on a side of the point."""
    line = board.sketch.at[point] + off * side
    start, end = line - (_HALF_LENGTH + _OVERHANG) * way, line + (_HALF_LENGTH + _OVERHANG) * way
    board.sketch.path((start, end), Layer.GROUND)
    board.sketch.hatch(start, end, side)
    board.grounds[point] = (start, end)


def _draw_bearing(board: Board, point: str, way: complex) -> None:
    """Two hatched cheeks on both sides of a rod that slides along itself; a point with a name stands beside them."""
    sketch = board.sketch
    named = point in board.shown
    centre = sketch.at[point] + (_BESIDE * _roomier_side(board, point, way) if named else 0)
    for side in (1j * way, -1j * way):
        start, end = (centre + sign * (_HALF_LENGTH + 1.0) * way + _HALF_BEARING * side for sign in (-1, 1))
        sketch.path((start, end), Layer.GROUND)
        sketch.hatch(start, end, side, bearing=True)
    for taken in (way, -way):
        sketch.occupy(point, taken)


def _roomier_side(board: Board, point: str, way: complex) -> complex:
    """The direction along a rod in which it reaches farther from one of its points, or the one with room."""
    place, form = board.sketch.at[point], board.form
    strokes = [(start, end) for _, start, end in form.bars] + [
        p for names in form.figure.lines for p in pairwise(names)
    ]
    steps = [board.sketch.at[end] - board.sketch.at[start] for start, end in strokes]
    farthest = 0.0
    for (start, end), step in zip(strokes, steps, strict=True):
        ends = [(board.sketch.at[name] - place) * way.conjugate() for name in (start, end)]
        if abs(step) > 1e-6 and max(abs(far.imag) for far in ends) < _ON_ROD:
            farthest = max((farthest, *(far.real for far in ends)), key=abs)
    side = way if farthest >= 0 else -way
    # Unless another point with a name is there.
    gaps = [abs(board.sketch.at[name] - place - _BESIDE * side) for name in board.shown if name != point]
    return -side if min(gaps, default=math.inf) < _HALF_LENGTH + 2.5 else side


def _free_side(board: Board, point: str, way: complex) -> complex:
    """The side of the line of motion with fewer links; below or to the right where that does not decide."""
    left = 1j * way
    load = sum((left * link.conjugate()).real for link in board.links_at(point))
    if abs(load) > 0.05:
        return left if load < 0 else -left
    return left if left.imag < -1e-9 or (abs(left.imag) <= 1e-9 and left.real > 0) else -left
