"""Ground line under a rolling wheel, tangent to it."""

from __future__ import annotations

from variantgen.figure.board import Board
from variantgen.figure.drawing import Layer
from variantgen.mechanism.joints.rolling import Rolling


def draw(board: Board, joint: Rolling) -> None:
    """Add the line through the contact, hatched on the far side, a little longer than the wheel."""
    sketch = board.sketch
    contact, centre = sketch.at[joint.contact], sketch.at[joint.centre]
    down = (contact - centre) / abs(contact - centre)
    half = 1.25 * abs(contact - centre)
    start, end = contact - half * 1j * down, contact + half * 1j * down
    sketch.path((start, end), Layer.GROUND)
    sketch.hatch(start, end, down)
    sketch.occupy(joint.centre, down)
    for taken in (down, 1j * down, -1j * down):
        sketch.occupy(joint.contact, taken)
