"""Given velocity and acceleration vectors of a point."""

from __future__ import annotations

import math

from variantgen.figure.arrows import directed, draw_arrows
from variantgen.figure.board import Board
from variantgen.mechanism.drivers.vector_motion import VectorMotion


def directions(board: Board, driver: VectorMotion) -> list[tuple[str, complex]]:
    """The point and the directions of its arrows, which need no line of reference beside them."""
    v, a = float(driver.v), float(driver.a) if board.accelerations else 0.0
    ways = [directed(rate, complex(board.frame.direction(at))) for rate, at in ((v, driver.angle), (a, driver.a_angle))]
    return [(driver.point, way) for way in ways if way]


def draw(board: Board, driver: VectorMotion) -> None:
    """Add the arrows, each in its direction."""
    v, a = float(driver.v), float(driver.a) if board.accelerations else 0.0
    ways = [complex(board.frame.direction(angle)) for angle in (driver.angle, driver.a_angle)]
    # The angle that gives the direction of an arrow is drawn at the point: so is the arrow, whatever it crosses.
    symbols = (board.rate(driver, "v") if v else None, board.rate(driver, "a") if a else None)
    draw_arrows(board, driver.point, (directed(v, ways[0]), directed(a, ways[1])), symbols, root=math.inf)
