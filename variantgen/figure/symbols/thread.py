"""Thread off a drum, over a fixed pulley, to a load."""

from __future__ import annotations

import math

from variantgen.figure.board import Board
from variantgen.figure.drawing import BOLD, MEDIUM, Layer
from variantgen.figure.sketch import HINGE
from variantgen.mechanism.constructions.tangent import thread_direction
from variantgen.mechanism.joints.thread import Thread

_HALF_LOAD = 3.0
_BRACKET = 4.5


def draw(board: Board, joint: Thread) -> None:
    """Add thread, pulley with its bracket, and load."""
    sketch = board.sketch
    sense = float(board.frame.sense)
    centre, pulley = sketch.at[joint.centre], sketch.at[joint.pulley]
    radius, pulley_radius = float(joint.radius) * sketch.scale, float(joint.pulley_radius) * sketch.scale
    side, pulley_side = sense * float(joint.side), sense * float(joint.pulley_side)
    way = complex(thread_direction(centre, radius, side, pulley, pulley_radius, pulley_side)[0])
    sketch.path(
        (centre + 1j * side * radius * way, pulley + 1j * pulley_side * pulley_radius * way), Layer.THREAD, MEDIUM
    )
    if joint.load is None:
        return
    down = complex(board.frame.direction(joint.load_angle))
    load = sketch.at[joint.load]
    off = pulley + 1j * pulley_side * pulley_radius * down
    sketch.path((off, load - _HALF_LOAD * down), Layer.THREAD, MEDIUM)
    corners = [load + _HALF_LOAD * complex(x, y) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    sketch.path(corners, Layer.SLIDER, closed=True, fill="paper")
    board.sized(joint.load, _HALF_LOAD, box=corners)
    for taken in (down, -down):
        sketch.occupy(joint.load, taken)
    # The bracket holds the pulley from the quarter that neither the thread nor the load needs.
    away = (-way - 1j * pulley_side * way) / math.sqrt(2)
    foot = pulley + (pulley_radius + _BRACKET) * away
    sketch.path((pulley + HINGE * away, foot), Layer.LINK, 0.8 * BOLD)
    sketch.path((foot - 3.0j * away, foot + 3.0j * away), Layer.LINK)
    sketch.hatch(foot - 3.0j * away, foot + 3.0j * away, away)
    sketch.circle(pulley, HINGE, Layer.HINGE, fill="paper")
