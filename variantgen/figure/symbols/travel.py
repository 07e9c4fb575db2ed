"""Given motion of a point: arrows for velocity and, where accelerations are asked, acceleration."""

from __future__ import annotations

import math

from variantgen.figure.arrows import acceleration_arrow, arrows_off_wall, directed, velocity_arrow
from variantgen.figure.board import Board
from variantgen.mechanism.drivers.travel import Travel


def draw(board: Board, driver: Travel) -> None:
    """Add the arrows; the acceleration is drawn beside the velocity, so that neither hides the other."""
    way = complex(board.frame.direction(driver.angle))
    if driver.point in board.form.figure.bare:
        _off_wall(board, driver, way)
        return
    if v := float(driver.v):
        velocity_arrow(board, driver.point, math.copysign(1.0, v) * way, board.rate(driver, "v"))
    if board.accelerations and (a := float(driver.a)):
        acceleration_arrow(board, driver.point, math.copysign(1.0, a) * way, board.rate(driver, "a"))


def _off_wall(board: Board, driver: Travel, way: complex) -> None:
    v, a = float(driver.v), float(driver.a) if board.accelerations else 0.0
    symbols = (board.rate(driver, "v") if v else None, board.rate(driver, "a") if a else None)
    arrows_off_wall(board, driver.point, (directed(v, way), directed(a, way)), symbols)
