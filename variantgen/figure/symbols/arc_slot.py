"""Block in a slot curved as a circular arc; hatched where the slot is fixed."""

from __future__ import annotations

import cmath
import math

from variantgen.figure.board import Board
from variantgen.figure.drawing import MEDIUM, Arc, Layer
from variantgen.figure.sketch import HINGE
from variantgen.mechanism.joints.arc_slot import ArcSlot

_HALF_WIDTH, _HALF_BLOCK = 1.5, 2.4
_HALF_SWEEP = math.radians(48)


def draw(board: Board, joint: ArcSlot) -> None:
    """Add the two edges of the slot about the point, and the block."""
    if joint.point in board.form.figure.bare:
        return
    sketch = board.sketch
    place, centre = sketch.at[joint.point], sketch.at[joint.centre]
    radius, middle = abs(place - centre), cmath.phase(place - centre)
    inner, outer = radius - _HALF_WIDTH, radius + _HALF_WIDTH
    start, sweep = middle - _HALF_SWEEP, 2 * _HALF_SWEEP
    for edge in (inner, outer):
        sketch.arc(Arc(centre, edge, Layer.GROUND, MEDIUM, start, sweep))
    for angle in (start, start + sweep):
        sketch.path((centre + cmath.rect(inner, angle), centre + cmath.rect(outer, angle)), Layer.GROUND, MEDIUM)
    if joint.body is None:
        sketch.hatch_arc(centre, outer, start, sweep, outside=True)
    ray = cmath.rect(1.0, middle)
    corners = [
        place + x * _HALF_BLOCK * 1j * ray + y * 0.8 * _HALF_WIDTH * ray
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    sketch.path(corners, Layer.SLIDER, closed=True, fill="paper")
    sketch.circle(place, HINGE, Layer.HINGE, fill="paper")
    for taken in (1j * ray, -1j * ray):
        sketch.occupy(joint.point, taken)
    board.sized(joint.point, _HALF_BLOCK, box=corners)
