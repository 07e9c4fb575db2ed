"""Given motion of a point along a line of a moving body: arrows along the line."""

from __future__ import annotations

from variantgen.figure.arrows import directed, draw_arrows
from variantgen.figure.board import Board
from variantgen.mechanism.drivers.relative_travel import RelativeTravel


def draw(board: Board, driver: RelativeTravel) -> None:
    """Add the arrows of relative velocity and, where accelerations are asked, relative acceleration."""
    first, second = (board.sketch.at[name] for name in driver.along)
    way = (second - first) / abs(second - first)
    v, a = float(driver.v), float(driver.a) if board.accelerations else 0.0
    symbols = (board.rate(driver, "v") if v else None, board.rate(driver, "a") if a else None)
    draw_arrows(board, driver.point, (directed(v, way), directed(a, way)), symbols)
