"""Given velocity and acceleration vectors of a point."""

from __future__ import annotations

from variantgen.figure.arrows import directed, draw_arrows
from variantgen.figure.board import Board
from variantgen.mechanism.drivers.vector_motion import VectorMotion


def draw(board: Board, driver: VectorMotion) -> None:
    """Add the arrows, each in its direction."""
    v, a = float(driver.v), float(driver.a) if board.accelerations else 0.0
    ways = [complex(board.frame.direction(angle)) for angle in (driver.angle, driver.a_angle)]
    symbols = (board.rate(driver, "v") if v else None, board.rate(driver, "a") if a else None)
    draw_arrows(board, driver.point, (directed(v, ways[0]), directed(a, ways[1])), symbols)
