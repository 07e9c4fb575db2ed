"""Given motion of a point along a line: its arrows."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText, RateArrow
from variantgen.figure.arrows import directed
from variantgen.mechanism.drivers.travel import Travel


def tell(alt_text: AltText, items: Sequence[Travel]) -> list[str]:
    """Nothing: no part of the mechanism belongs to it."""
    return []


def arrows(alt_text: AltText, driver: Travel) -> list[RateArrow]:
    """Velocity and, where accelerations are asked, acceleration."""
    board = alt_text.board
    way = alt_text.heading(driver.angle)
    found: list[RateArrow] = []
    for kind, rate in (("v", float(driver.v)), ("a", float(driver.a) if board.accelerations else 0.0)):
        if rate:
            ahead = directed(rate, way)
            found += alt_text.straight_arrow(
                "travel", driver.point, ahead, board.rate(driver, kind), way=alt_text.way(ahead)
            )
    return found
