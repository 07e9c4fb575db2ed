"""Given rotation: the senses of the curved arrows and what they go about."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText, RateArrow
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.wording.formula import to_plain


def tell(alt_text: AltText, items: Sequence[Rotation]) -> list[str]:
    """Nothing: no part of the mechanism belongs to it."""
    return []


def arrows(alt_text: AltText, driver: Rotation) -> list[RateArrow]:
    """The angular velocity and, where accelerations are asked, the angular acceleration."""
    board = alt_text.board
    rates = [("omega", float(driver.omega))]
    if board.accelerations:
        rates.append(("epsilon", float(driver.epsilon)))
    found = []
    where = _centre(alt_text, driver.body)
    for kind, rate in rates:
        symbol = board.rate(driver, kind) if rate else None
        if symbol is not None:
            name, sense = to_plain(symbol), alt_text.sense(float(board.frame.sense) * rate)
            found.append(RateArrow(alt_text.say("rotation", symbol=name, sense=sense, where=where), name))
    return found


def _centre(alt_text: AltText, body: str) -> str:
    """``about O``; the arcs of a plate without a fixed point are in its middle."""
    board = alt_text.board
    pivot = board.pivot_of(body)
    free = body in board.form.figure.plates and not alt_text.fixed & set(board.form.bodies[body])
    if free or not alt_text.is_shown(pivot):
        return alt_text.say("on_body", body=alt_text.body(body))
    return alt_text.say("about", point=alt_text.name(pivot))
