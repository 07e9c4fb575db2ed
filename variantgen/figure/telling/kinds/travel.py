"""Given motion of a point along a line: its arrows."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.arrows import directed
from variantgen.figure.telling.teller import Arrow, Teller
from variantgen.mechanism.drivers.travel import Travel


def tell(teller: Teller, items: Sequence[Travel]) -> list[str]:
    """Nothing: no part of the mechanism belongs to it."""
    return []


def arrows(teller: Teller, driver: Travel) -> list[Arrow]:
    """Velocity and, where accelerations are asked, acceleration."""
    board = teller.board
    way = teller.heading(driver.angle)
    found: list[Arrow] = []
    for kind, rate in (("v", float(driver.v)), ("a", float(driver.a) if board.accelerations else 0.0)):
        if rate:
            ahead = directed(rate, way)
            found += teller.straight_arrow(
                "travel", driver.point, ahead, board.rate(driver, kind), way=teller.way(ahead)
            )
    return found
