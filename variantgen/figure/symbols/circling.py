"""Given motion of a point along an arc of a moving body: arrows along the tangent."""

from __future__ import annotations

import math

from variantgen.figure.arrows import acceleration_arrow, velocity_arrow
from variantgen.figure.board import Board
from variantgen.mechanism.drivers.circling import Circling


def draw(board: Board, driver: Circling) -> None:
    """Add the arrows of relative velocity and, where accelerations are asked, tangential relative acceleration."""
    ray = board.sketch.at[driver.point] - board.sketch.at[driver.centre]
    way = float(board.frame.sense) * 1j * ray / abs(ray)
    if v := float(driver.v):
        velocity_arrow(board, driver.point, math.copysign(1.0, v) * way, board.rate(driver, "v"))
    if board.accelerations and (a := float(driver.a)):
        acceleration_arrow(board, driver.point, math.copysign(1.0, a) * way, board.rate(driver, "a"))
