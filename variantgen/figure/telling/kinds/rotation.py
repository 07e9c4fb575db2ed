"""Given rotation: the senses of the curved arrows and what they go about."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.telling.teller import Arrow, Teller
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.wording.formula import to_plain


def tell(teller: Teller, items: Sequence[Rotation]) -> list[str]:
    """Nothing: no part of the mechanism belongs to it."""
    return []


def arrows(teller: Teller, driver: Rotation) -> list[Arrow]:
    """The angular velocity and, where accelerations are asked, the angular acceleration."""
    board = teller.board
    rates = [("omega", float(driver.omega))]
    if board.accelerations:
        rates.append(("epsilon", float(driver.epsilon)))
    found = []
    where = _centre(teller, driver.body)
    for kind, rate in rates:
        symbol = board.rate(driver, kind) if rate else None
        if symbol is not None:
            name, sense = to_plain(symbol), teller.sense(float(board.frame.sense) * rate)
            found.append(Arrow(teller.say("rotation", symbol=name, sense=sense, where=where), name))
    return found


def _centre(teller: Teller, body: str) -> str:
    """``about O``; the arcs of a plate without a fixed point are in its middle."""
    board = teller.board
    pivot = board.pivot_of(body)
    free = body in board.form.figure.plates and not teller.fixed & set(board.form.bodies[body])
    if free or not teller.is_shown(pivot):
        return teller.say("on_body", body=teller.body(body))
    return teller.say("about", point=teller.name(pivot))
