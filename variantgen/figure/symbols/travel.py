"""Given motion of a point: arrows for velocity and, where accelerations are asked, acceleration."""

from __future__ import annotations

import math

from variantgen.figure.arrows import acceleration_arrow, velocity_arrow
from variantgen.figure.board import Board
from variantgen.mechanism.drivers.travel import Travel


def draw(board: Board, driver: Travel) -> None:
    """Add the arrows; the acceleration is drawn beside the velocity, so that neither hides the other."""
    way = complex(board.frame.direction(driver.angle))
    if v := float(driver.v):
        velocity_arrow(board, driver.point, math.copysign(1.0, v) * way, board.rate(driver, "v"))
    if board.accelerations and (a := float(driver.a)):
        acceleration_arrow(board, driver.point, math.copysign(1.0, a) * way, board.rate(driver, "a"))
