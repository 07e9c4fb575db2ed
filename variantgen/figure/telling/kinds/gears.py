"""Gears in mesh, outside or inside, with a moving or a fixed gear."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.telling.teller import Teller
from variantgen.mechanism.joints.gears import Gears


def tell(teller: Teller, items: Sequence[Gears]) -> list[str]:
    """A clause for each mesh."""
    found = []
    for joint in items:
        key = "gears" + ("_fixed" if joint.other is None else "") + ("_inside" if joint.inside else "")
        radius = float(joint.radius) * teller.board.sketch.scale
        gap = abs(teller.at(joint.centre) - teller.at(joint.other_centre))
        first = teller.called(joint.centre, joint.body) + teller.rim(joint.body, radius)
        second = teller.called(joint.other_centre, joint.other or "")
        if joint.other is not None:
            second += teller.rim(joint.other, gap + radius if joint.inside else gap - radius)
        found.append(teller.say(key, first=first, second=second))
    return found
