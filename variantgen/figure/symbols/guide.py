"""Slider in a fixed guide: a block on a hatched line; under a load on a rope only where it does not hang."""

from __future__ import annotations

import math
from itertools import pairwise

from variantgen.figure.board import Board
from variantgen.figure.drawing import Layer
from variantgen.figure.sketch import HINGE
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.rolling import Rolling
from variantgen.mechanism.joints.rope import Rope
from variantgen.mechanism.rows import Placement

HALF_LOAD = 3.0  # half the side of a load on a rope, u
_HALF_LENGTH, _HALF_HEIGHT, _OVERHANG = 2.9, 1.7, 5.5
_HALF_BEARING = 1.1
_BESIDE = 6.4  # from the middle of a bearing to a point with a name, u
UPRIGHT = 1e-3  # horizontal part of a direction: less is none
_ON_ROD = 0.1  # distance from the line of a rod, u


def draw(board: Board, joint: Guide) -> None:
    """Add the symbol; what hangs on ropes has a symbol of its own, the end of a ladder needs no block."""
    way = complex(board.frame.direction(joint.angle))
    if joint.point in board.form.figure.bare or _hangs(board, joint.point, way):
        return
    sketch = board.sketch
    centre = sketch.at[joint.point]
    if joint.point in board.form.figure.stems:
        _draw_bearing(board, joint.point, way)
        return
    is_load = joint.point in board.loads
    side = -1j * way * math.copysign(1.0, way.real) if is_load else ground_side(board, joint)
    long, high = (HALF_LOAD, HALF_LOAD) if is_load else (_HALF_LENGTH, _HALF_HEIGHT)
    corners = [centre + x * long * way + y * high * side for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    _draw_ground(board, joint.point, way, side, high)
    if board.is_translated(joint.point) or not board.is_linked(joint.point):
        # Fixed to its rod, which is seen to run through the block, or without one: there is no pin.
        sketch.path(corners, Layer.DISC, closed=True, fill="paper")
    else:
        sketch.path(corners, Layer.SLIDER, closed=True, fill="paper")
        sketch.circle(centre, HINGE, Layer.HINGE, fill="paper")
    for taken in (way, -way, side):
        sketch.occupy(joint.point, taken)
    board.sized(joint.point, long, box=corners)


def _hangs(board: Board, point: str, way: complex) -> bool:
    """Whether a point that moves upright is held by ropes alone: a load, or a pulley between upright strands."""
    if abs(way.real) > UPRIGHT or (board.is_linked(point) and not board.is_disc(point)):
        return False
    at = Placement({name: place / board.sketch.scale for name, place in board.sketch.at.items()}, board.frame)
    rays = [
        complex(ray)
        for rope in board.scene.joints
        if isinstance(rope, Rope)
        for pair, (ray, _) in zip(pairwise(rope.path), rope.pieces(at), strict=True)
        if point in (pair[0].point, pair[1].point)
    ]
    return point in board.loads or (bool(rays) and all(abs(ray.real) < UPRIGHT for ray in rays))


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


def ground_side(board: Board, joint: Guide) -> complex:
    """The side of the line of motion where the ground is: with fewer links, else below or to the right.

    The slider of a rack has it on the side of the gear, as the rack is on the other.
    """
    way = complex(board.frame.direction(joint.angle))
    left = 1j * way
    for rack in board.scene.joints:
        if isinstance(rack, Rolling) and board.is_rack(rack.on) and rack.on in board.owners(joint.point):
            gear = board.sketch.at[rack.centre] - board.sketch.at[rack.contact]
            return left if (left * gear.conjugate()).real > 0 else -left
    load = sum((left * link.conjugate()).real for link in board.links_at(joint.point))
    if abs(load) > 0.05:
        return left if load < 0 else -left
    return left if left.imag < -1e-9 or (abs(left.imag) <= 1e-9 and left.real > 0) else -left
