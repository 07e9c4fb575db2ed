"""Given motion of a point along an arc of a body: arrows along the tangent."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText, RateArrow
from variantgen.mechanism.drivers.circling import Circling


def tell(alt_text: AltText, items: Sequence[Circling]) -> list[str]:
    """Nothing: the arc is described as a joint."""
    return []


def arrows(alt_text: AltText, driver: Circling) -> list[RateArrow]:
    """Relative velocity and, where accelerations are asked, tangential relative acceleration."""
    board = alt_text.board
    sense = float(board.frame.sense)
    tangent = 1j * sense * (alt_text.at(driver.point) - alt_text.at(driver.centre))
    found: list[RateArrow] = []
    for kind, rate in (("v", float(driver.v)), ("a", float(driver.a) if board.accelerations else 0.0)):
        if rate:
            words = {"centre": alt_text.name(driver.centre), "sense": alt_text.sense(sense * rate)}
            symbol = board.rate(driver, kind)
            found += alt_text.straight_arrow("circling", driver.point, rate * tangent, symbol, **words)
    return found
