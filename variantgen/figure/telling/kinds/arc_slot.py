"""Blocks in slots and guides that are arcs, points on rims, discs that touch."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.telling.teller import Teller
from variantgen.mechanism.joints.arc_slot import ArcSlot


def tell(teller: Teller, items: Sequence[ArcSlot]) -> list[str]:
    """A clause for each arc."""
    return [_clause(teller, joint) for joint in items]


def _clause(teller: Teller, joint: ArcSlot) -> str:
    board = teller.board
    name, centre = teller.name(joint.point), teller.name(joint.centre)
    if joint.point in board.form.figure.bare and joint.body is not None:
        disc = teller.disc(joint.centre, joint.body, "_of")
        if board.is_disc(joint.point):
            first = teller.disc(joint.point, teller.owners(joint.point)[0])
            return teller.say("arc_slot_discs", first=first, second=disc)
        return teller.say("arc_slot_rim", point=name, disc=disc)
    hinged = teller.hinge(joint.point)
    if joint.body is None:
        return teller.say("arc_slot_fixed", point=name, hinged=hinged, centre=centre)
    return teller.say("arc_slot", point=name, hinged=hinged, centre=centre, body=teller.part(joint.body, "_of"))
