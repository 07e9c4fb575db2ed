"""Fixed hinge: circle, two legs, hatched base turned to the free side."""

from __future__ import annotations

import cmath
import math

import numpy as np

from variantgen.figure.board import Board
from variantgen.figure.drawing import BOLD, Layer
from variantgen.figure.sketch import HINGE
from variantgen.mechanism.joints.pivot import Pivot

SEEKS_ROOM = True
_HEIGHT, _HALF_LEGS, _HALF_BASE = 4.0, 2.4, 3.7
# Down first: that is where a base is expected.
_SIDES = np.array([-math.pi / 2, math.pi / 2, math.pi, 0.0])
_DOWN = np.exp(1j * _SIDES)
_HATCH, _HALF = 1.7, _HALF_BASE + 1.0  # below the base; half the width of the symbol
_BEYOND = 1.2  # from a rim to the base outside it, u
_UPRIGHT = (np.abs(_DOWN.imag) > 0.5)[:, None]


def draw(board: Board, joint: Pivot) -> None:
    """Add the symbol."""
    sketch = board.sketch
    centre = sketch.at[joint.point]
    if joint.point not in board.poses:
        board.poses[joint.point] = _roomiest_side(board, joint.point)
    angle, height = board.poses[joint.point], _height(board, joint.point)
    down = cmath.rect(1.0, angle)
    left, foot = -1j * down, centre + height * down
    for side in (1, -1):
        leg = foot + side * _HALF_LEGS * left
        way = (leg - centre) / abs(leg - centre)
        sketch.path((centre + HINGE * way, leg), Layer.SLIDER, 0.8 * BOLD)
        sketch.occupy(joint.point, way)
    sketch.occupy(joint.point, down)
    start, end = foot - _HALF_BASE * left, foot + _HALF_BASE * left
    sketch.path((start, end), Layer.SLIDER)
    sketch.hatch(start, end, down)
    sketch.circle(centre, HINGE, Layer.HINGE, fill="paper")
    board.sized(joint.point, HINGE)


def _height(board: Board, point: str) -> float:
    """How far below the hinge the base is: where it stands on no rim of the discs that turn about the hinge."""
    rims = sorted(board.rims(point))
    heights = [_HEIGHT, *(rim + _BEYOND for rim in rims if rim + _BEYOND > _HEIGHT)]
    free = [h for h in heights if not any(h - _BEYOND < rim < math.hypot(h + _HATCH, _HALF) for rim in rims)]
    return next(iter(free), _HEIGHT)


def _roomiest_side(board: Board, point: str) -> float:
    """The side on which the base covers least of what is drawn already and is far from the links at the hinge."""
    sketch = board.sketch
    half_depth = 0.5 * (_height(board, point) + _HATCH)
    boxes = (np.where(_UPRIGHT, _HALF, half_depth), np.where(_UPRIGHT, half_depth, _HALF))
    covered = sketch.crossings(sketch.at[point] + (HINGE + half_depth) * _DOWN, boxes)
    close = np.maximum(0.0, math.radians(58) - sketch.freedom(point, _SIDES))
    return float(_SIDES[(2.0 * covered + 6.0 * close).argmin()])
