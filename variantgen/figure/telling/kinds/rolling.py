"""Wheels on lines: what they roll on, on which side it lies, how it runs."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.telling.teller import Teller
from variantgen.mechanism.joints.rolling import Rolling


def tell(teller: Teller, items: Sequence[Rolling]) -> list[str]:
    """A clause for each line."""
    return [_clause(teller, joint) for joint in items]


def _clause(teller: Teller, joint: Rolling) -> str:
    down = teller.at(joint.contact) - teller.at(joint.centre)
    contact = teller.say("contact", point=teller.name(joint.contact)) if teller.is_shown(joint.contact) else ""
    disc = teller.disc(joint.centre, joint.body) + teller.rim(joint.body, abs(down))
    words = {"disc": disc, "side": teller.side(down), "contact": contact}
    line = teller.inclined(1j * down)
    if joint.on is None:
        return teller.say("rolling", line=line, **words)
    return teller.say("rolling_rack", line=line, rack=teller.body(joint.on), **words)
