"""Given velocity and acceleration vectors of a point: their arrows."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.arrows import directed
from variantgen.figure.telling.teller import Arrow, Teller
from variantgen.mechanism.drivers.vector_motion import VectorMotion


def tell(teller: Teller, items: Sequence[VectorMotion]) -> list[str]:
    """Nothing: no part of the mechanism belongs to it."""
    return []


def arrows(teller: Teller, driver: VectorMotion) -> list[Arrow]:
    """Velocity and, where accelerations are asked, acceleration, each in its direction."""
    board = teller.board
    rates = [("v", float(driver.v), driver.angle)]
    if board.accelerations:
        rates.append(("a", float(driver.a), driver.a_angle))
    found: list[Arrow] = []
    for kind, rate, angle in rates:
        if rate:
            ahead = directed(rate, teller.heading(angle))
            found += teller.straight_arrow(
                "vector_motion", driver.point, ahead, board.rate(driver, kind), way=teller.way(ahead)
            )
    return found
