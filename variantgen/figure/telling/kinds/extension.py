"""Hydraulic cylinders: what they join, and the arrows beside them."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.arrows import directed
from variantgen.figure.telling.teller import Arrow, Teller
from variantgen.mechanism.drivers.extension import Extension


def tell(teller: Teller, items: Sequence[Extension]) -> list[str]:
    """A clause for each cylinder."""
    return [teller.say("extension", start=teller.name(driver.start), end=teller.name(driver.end)) for driver in items]


def arrows(teller: Teller, driver: Extension) -> list[Arrow]:
    """The rate of the length and, where accelerations are asked, its own rate: arrows along the cylinder."""
    board = teller.board
    step = teller.at(driver.end) - teller.at(driver.start)
    found: list[Arrow] = []
    for kind, rate in (("v", float(driver.v)), ("a", float(driver.a) if board.accelerations else 0.0)):
        if rate:
            target = driver.end if rate > 0 else driver.start
            words = {"target": teller.name(target)}
            ahead, symbol = directed(rate, step), board.rate(driver, kind)
            found += teller.straight_arrow("extension_arrow", driver.end, ahead, symbol, **words)
    return found
