"""Fixed hinge: circle, two legs, hatched base turned to the free side."""

from __future__ import annotations

import cmath
import math

from variantgen.figure.board import Board
from variantgen.figure.drawing import BOLD, Layer
from variantgen.figure.sketch import HINGE
from variantgen.mechanism.joints.pivot import Pivot

_HEIGHT, _HALF_LEGS, _HALF_BASE = 4.0, 2.4, 3.7
# Down first: that is where a base is expected.
_SIDES = (-math.pi / 2, math.pi / 2, math.pi, 0.0)


def draw(board: Board, joint: Pivot) -> None:
    """Add the symbol."""
    sketch = board.sketch
    centre = sketch.at[joint.point]
    angle = sketch.freest(joint.point, _SIDES, math.radians(58))
    down = cmath.rect(1.0, angle)
    left, foot = -1j * down, centre + _HEIGHT * down
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
