"""Given motion of a point along a line of a moving body: arrows along the line."""

from __future__ import annotations

import math

from variantgen.figure.arrows import acceleration_arrow, velocity_arrow
from variantgen.figure.board import Board
from variantgen.mechanism.drivers.relative_travel import RelativeTravel


def draw(board: Board, driver: RelativeTravel) -> None:
    """Add the arrows of relative velocity and, where accelerations are asked, relative acceleration."""
    first, second = (board.sketch.at[name] for name in driver.along)
    way = (second - first) / abs(second - first)
    if v := float(driver.v):
        velocity_arrow(board, driver.point, math.copysign(1.0, v) * way, board.rate(driver, "v"), beside=True)
    if board.accelerations and (a := float(driver.a)):
        acceleration_arrow(board, driver.point, math.copysign(1.0, a) * way, board.rate(driver, "a"))
