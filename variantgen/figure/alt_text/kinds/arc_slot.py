"""Blocks in slots and guides that are arcs, points on rims, discs that touch."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText
from variantgen.mechanism.joints.arc_slot import ArcSlot


def tell(alt_text: AltText, items: Sequence[ArcSlot]) -> list[str]:
    """A clause for each arc."""
    return [_clause(alt_text, joint) for joint in items]


def _clause(alt_text: AltText, joint: ArcSlot) -> str:
    board = alt_text.board
    name, centre = alt_text.name(joint.point), alt_text.name(joint.centre)
    if joint.point in board.form.figure.bare and joint.body is not None:
        disc = alt_text.disc(joint.centre, joint.body)
        if board.is_disc(joint.point):
            first = alt_text.disc(joint.point, alt_text.owners(joint.point)[0])
            return alt_text.say("arc_slot_discs", first=first, second=disc)
        return alt_text.say("arc_slot_rim", point=name, disc=disc)
    hinged = alt_text.hinge(joint.point)
    if joint.body is None:
        return alt_text.say("arc_slot_fixed", point=name, hinged=hinged, centre=centre)
    return alt_text.say("arc_slot", point=name, hinged=hinged, centre=centre, body=alt_text.part(joint.body))
