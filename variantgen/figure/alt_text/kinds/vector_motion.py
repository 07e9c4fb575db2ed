"""Given velocity and acceleration vectors of a point: their arrows."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText, RateArrow
from variantgen.figure.arrows import directed
from variantgen.mechanism.drivers.vector_motion import VectorMotion


def tell(alt_text: AltText, items: Sequence[VectorMotion]) -> list[str]:
    """Nothing: no part of the mechanism belongs to it."""
    return []


def arrows(alt_text: AltText, driver: VectorMotion) -> list[RateArrow]:
    """Velocity and, where accelerations are asked, acceleration, each in its direction."""
    board = alt_text.board
    rates = [("v", float(driver.v), driver.angle)]
    if board.accelerations:
        rates.append(("a", float(driver.a), driver.a_angle))
    found: list[RateArrow] = []
    for kind, rate, angle in rates:
        if rate:
            ahead = directed(rate, alt_text.heading(angle))
            found += alt_text.straight_arrow(
                "vector_motion", driver.point, ahead, board.rate(driver, kind), way=alt_text.way(ahead)
            )
    return found
