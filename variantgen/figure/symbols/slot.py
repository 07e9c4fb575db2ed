"""Sleeve on a rod: a block on the rod, with a hinge in its centre if it swivels."""

from __future__ import annotations

from variantgen.figure.board import Board
from variantgen.figure.drawing import Layer
from variantgen.figure.sketch import DOT, HINGE
from variantgen.mechanism.joints.slot import Slot

_HALF_LENGTH, _HALF_HEIGHT = 2.7, 1.5


def draw(board: Board, joint: Slot) -> None:
    """Add the symbol."""
    if joint.point in board.form.figure.bare:
        return
    sketch = board.sketch
    centre = sketch.at[joint.point]
    start, end = (sketch.at[p] for p in joint.along)
    way = (end - start) / abs(end - start)
    corners = [
        centre + x * _HALF_LENGTH * way + y * _HALF_HEIGHT * 1j * way for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    sketch.path(corners, Layer.SLIDER, closed=True, fill="paper")
    if not board.owners(joint.point):
        sketch.circle(centre, DOT, Layer.HINGE, fill="ink")
    elif joint.sleeve is None or set(board.owners(joint.point)) != {joint.sleeve}:  # something is pinned to the sleeve
        sketch.circle(centre, HINGE, Layer.HINGE, fill="paper")
    for taken in (way, -way):
        sketch.occupy(joint.point, taken)
    board.sized(joint.point, _HALF_LENGTH, box=corners)
