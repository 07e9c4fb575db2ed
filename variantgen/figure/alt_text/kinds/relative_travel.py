"""Given motion of a point along a line of a body: arrows along the line."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText, RateArrow
from variantgen.figure.arrows import directed
from variantgen.mechanism.drivers.relative_travel import RelativeTravel


def tell(alt_text: AltText, items: Sequence[RelativeTravel]) -> list[str]:
    """Nothing: the slot is described as a joint."""
    return []


def arrows(alt_text: AltText, driver: RelativeTravel) -> list[RateArrow]:
    """Relative velocity and, where accelerations are asked, relative acceleration."""
    board = alt_text.board
    step = alt_text.at(driver.along[1]) - alt_text.at(driver.along[0])
    found: list[RateArrow] = []
    for kind, rate in (("v", float(driver.v)), ("a", float(driver.a) if board.accelerations else 0.0)):
        if rate:
            ahead, symbol = directed(rate, step), board.rate(driver, kind)
            target = driver.along[1 if rate > 0 else 0]
            towards = alt_text.at(target) - alt_text.at(driver.point)
            if alt_text.is_shown(target) and (towards * ahead.conjugate()).real > 0:
                words = {"target": alt_text.name(target)}
                found += alt_text.straight_arrow("relative_travel", driver.point, ahead, symbol, **words)
            else:
                found += alt_text.straight_arrow("travel", driver.point, ahead, symbol, way=alt_text.way(ahead))
    return found
