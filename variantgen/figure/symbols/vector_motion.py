"""Given velocity and acceleration vectors of a point."""

from __future__ import annotations

import cmath
import math

from variantgen.figure.arrows import acceleration_arrow, velocity_arrow
from variantgen.figure.board import Board
from variantgen.mechanism.drivers.vector_motion import VectorMotion

_APART = math.radians(20)


def draw(board: Board, driver: VectorMotion) -> None:
    """Add the arrows, each in its direction; an acceleration near the line of the velocity is drawn beside it."""
    v, a = float(driver.v), float(driver.a) if board.accelerations else 0.0
    ways = [complex(board.frame.direction(angle)) for angle in (driver.angle, driver.a_angle)]
    if v:
        velocity_arrow(board, driver.point, math.copysign(1.0, v) * ways[0], board.rate(driver, "v"))
    if a:
        ahead = math.copysign(1.0, a) * ways[1]
        near = v != 0 and abs(cmath.phase(ahead / ways[0] / math.copysign(1.0, v))) < _APART
        acceleration_arrow(board, driver.point, ahead, board.rate(driver, "a"), near)
