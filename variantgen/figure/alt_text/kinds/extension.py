"""Hydraulic cylinders: what they join, and the arrows beside them."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText, RateArrow
from variantgen.figure.arrows import directed
from variantgen.mechanism.drivers.extension import Extension


def tell(alt_text: AltText, items: Sequence[Extension]) -> list[str]:
    """A clause for each cylinder."""
    return [
        alt_text.say("extension", start=alt_text.name(driver.start), end=alt_text.name(driver.end)) for driver in items
    ]


def arrows(alt_text: AltText, driver: Extension) -> list[RateArrow]:
    """The rate of the length and, where accelerations are asked, its own rate: arrows along the cylinder."""
    board = alt_text.board
    step = alt_text.at(driver.end) - alt_text.at(driver.start)
    found: list[RateArrow] = []
    for kind, rate in (("v", float(driver.v)), ("a", float(driver.a) if board.accelerations else 0.0)):
        if rate:
            target = driver.end if rate > 0 else driver.start
            words = {"target": alt_text.name(target)}
            ahead, symbol = directed(rate, step), board.rate(driver, kind)
            found += alt_text.straight_arrow("extension_arrow", driver.end, ahead, symbol, **words)
    return found
