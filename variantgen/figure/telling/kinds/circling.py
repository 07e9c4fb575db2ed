"""Given motion of a point along an arc of a body: arrows along the tangent."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.telling.teller import Arrow, Teller
from variantgen.mechanism.drivers.circling import Circling


def tell(teller: Teller, items: Sequence[Circling]) -> list[str]:
    """Nothing: the arc is told as a joint."""
    return []


def arrows(teller: Teller, driver: Circling) -> list[Arrow]:
    """Relative velocity and, where accelerations are asked, tangential relative acceleration."""
    board = teller.board
    sense = float(board.frame.sense)
    tangent = 1j * sense * (teller.at(driver.point) - teller.at(driver.centre))
    found: list[Arrow] = []
    for kind, rate in (("v", float(driver.v)), ("a", float(driver.a) if board.accelerations else 0.0)):
        if rate:
            words = {"centre": teller.name(driver.centre), "sense": teller.sense(sense * rate)}
            symbol = board.rate(driver, kind)
            found += teller.straight_arrow("circling", driver.point, rate * tangent, symbol, **words)
    return found
