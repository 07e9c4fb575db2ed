"""Hydraulic cylinder between two points, with the given rate of its length."""

from __future__ import annotations

import math

from variantgen.figure.arrows import acceleration_arrow, velocity_arrow
from variantgen.figure.board import Board
from variantgen.figure.drawing import BOLD, Layer
from variantgen.figure.sketch import HINGE
from variantgen.mechanism.drivers.extension import Extension

_HALF_WIDTH = 1.7


def draw_parts(board: Board, driver: Extension) -> None:
    """Add barrel and piston rod."""
    sketch = board.sketch
    start, end = sketch.at[driver.start], sketch.at[driver.end]
    way, length = (end - start) / abs(end - start), abs(end - start)
    side = _HALF_WIDTH * 1j * way
    near, far = start + 0.14 * length * way, start + 0.62 * length * way
    sketch.path((start, near), Layer.LINK)
    sketch.path((near - side, far - side, far + side, near + side), Layer.SLIDER, 0.8 * BOLD, closed=True, fill="paper")
    piston = start + 0.48 * length * way
    sketch.path((piston - side, piston + side), Layer.SLIDER)
    sketch.path((piston, end), Layer.SLIDER)
    for point, taken in ((driver.start, way), (driver.end, -way)):
        sketch.circle(sketch.at[point], HINGE, Layer.HINGE, fill="paper")
        sketch.occupy(point, taken)
        board.sized(point, HINGE)


def draw(board: Board, driver: Extension) -> None:
    """Add the arrows of the moving end relative to the other, beside the rod."""
    start, end = board.sketch.at[driver.start], board.sketch.at[driver.end]
    way = (end - start) / abs(end - start)
    if v := float(driver.v):
        velocity_arrow(board, driver.end, math.copysign(1.0, v) * way, board.rate(driver, "v"), beside=True)
    if board.accelerations and (a := float(driver.a)):
        acceleration_arrow(board, driver.end, math.copysign(1.0, a) * way, board.rate(driver, "a"))
