"""Given motion of a point along an arc of a moving body: arrows along the tangent."""

from __future__ import annotations

import math

from variantgen.figure.arrows import directed, draw_arrows
from variantgen.figure.board import Board
from variantgen.mechanism.drivers.circling import Circling

_SLOT, _RIM = 2.4, 0.9  # half the width of what an arrow leaves: a slot with its edges, a rim, u


def draw(board: Board, driver: Circling) -> None:
    """Add the arrows of relative velocity and, where accelerations are asked, tangential relative acceleration."""
    ray = board.sketch.at[driver.point] - board.sketch.at[driver.centre]
    way = float(board.frame.sense) * 1j * ray / abs(ray)
    # A tangent leaves its own circle, and the edges of a slot along it, only after a while.
    half = _SLOT if driver.point in board.clear else _RIM
    root = math.sqrt(2 * half * abs(ray) + half**2)
    v, a = float(driver.v), float(driver.a) if board.accelerations else 0.0
    symbols = (board.rate(driver, "v") if v else None, board.rate(driver, "a") if a else None)
    draw_arrows(board, driver.point, (directed(v, way), directed(a, way)), symbols, root=root)
