"""Given motion of a point along a line of a body: arrows along the line."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.arrows import directed
from variantgen.figure.telling.teller import Arrow, Teller
from variantgen.mechanism.drivers.relative_travel import RelativeTravel


def tell(teller: Teller, items: Sequence[RelativeTravel]) -> list[str]:
    """Nothing: the slot is told as a joint."""
    return []


def arrows(teller: Teller, driver: RelativeTravel) -> list[Arrow]:
    """Relative velocity and, where accelerations are asked, relative acceleration."""
    board = teller.board
    step = teller.at(driver.along[1]) - teller.at(driver.along[0])
    found: list[Arrow] = []
    for kind, rate in (("v", float(driver.v)), ("a", float(driver.a) if board.accelerations else 0.0)):
        if rate:
            ahead, symbol = directed(rate, step), board.rate(driver, kind)
            target = driver.along[1 if rate > 0 else 0]
            towards = teller.at(target) - teller.at(driver.point)
            if teller.is_shown(target) and (towards * ahead.conjugate()).real > 0:
                words = {"target": teller.name(target)}
                found += teller.straight_arrow("relative_travel", driver.point, ahead, symbol, **words)
            else:
                found += teller.straight_arrow("travel", driver.point, ahead, symbol, way=teller.way(ahead))
    return found
