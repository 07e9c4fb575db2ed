"""Given motion of a point: arrows for velocity and, where accelerations are asked, acceleration."""

from __future__ import annotations

from variantgen.figure.arrows import directed, draw_arrows
from variantgen.figure.board import Board
from variantgen.mechanism.drivers.travel import Travel


def draw(board: Board, driver: Travel) -> None:
    """Add the arrows."""
    way = complex(board.frame.direction(driver.angle))
    v, a = float(driver.v), float(driver.a) if board.accelerations else 0.0
    symbols = (board.rate(driver, "v") if v else None, board.rate(driver, "a") if a else None)
    draw_arrows(board, driver.point, (directed(v, way), directed(a, way)), symbols)
