"""Wheels on lines: what they roll on, on which side it lies, how it runs."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText
from variantgen.mechanism.joints.rolling import Rolling


def tell(alt_text: AltText, items: Sequence[Rolling]) -> list[str]:
    """A clause for each line."""
    return [_clause(alt_text, joint) for joint in items]


def _clause(alt_text: AltText, joint: Rolling) -> str:
    down = alt_text.at(joint.contact) - alt_text.at(joint.centre)
    contact = alt_text.say("contact", point=alt_text.name(joint.contact)) if alt_text.is_shown(joint.contact) else ""
    disc = f"{alt_text.disc(joint.centre, joint.body)}{alt_text.rim(joint.body, abs(down))}"
    words = {"disc": disc, "side": alt_text.side(down), "contact": contact}
    line = alt_text.inclined(1j * down)
    if joint.on is None:
        return alt_text.say("rolling", line=line, **words)
    if alt_text.board.is_rack(joint.on):
        return alt_text.say("rolling_toothed", line=line, **words)
    number = alt_text.body(joint.on)  # empty where the text has one rack alone
    return alt_text.say("rolling_rack", line=line, rack=number and f" {number}", **words)
