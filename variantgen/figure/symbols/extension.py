"""Hydraulic cylinder between two points, with the given rate of its length."""

from __future__ import annotations

from variantgen.figure.arrows import directed, draw_arrows
from variantgen.figure.board import Board
from variantgen.figure.drawing import BOLD, Layer
from variantgen.figure.sketch import HINGE
from variantgen.mechanism.drivers.extension import Extension

_HALF_WIDTH = 1.7
_FREE_ROD = 0.74  # where the arrows start, part of the length


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
    v, a = float(driver.v), float(driver.a) if board.accelerations else 0.0
    symbols = (board.rate(driver, "v") if v else None, board.rate(driver, "a") if a else None)
    place = start + _FREE_ROD * (end - start)
    draw_arrows(board, driver.end, (directed(v, way), directed(a, way)), symbols, place)
