"""Gears in mesh, outside or inside, with a moving or a fixed gear."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText
from variantgen.mechanism.joints.gears import Gears


def tell(alt_text: AltText, items: Sequence[Gears]) -> list[str]:
    """A clause for each mesh."""
    found = []
    for joint in items:
        key = "gears" + ("_fixed" if joint.other is None else "") + ("_inside" if joint.inside else "")
        radius = float(joint.radius) * alt_text.board.sketch.scale
        gap = abs(alt_text.at(joint.centre) - alt_text.at(joint.other_centre))
        first = alt_text.called(joint.centre, joint.body) + alt_text.rim(joint.body, radius)
        second = alt_text.called(joint.other_centre, joint.other or "")
        if joint.other is not None:
            second += alt_text.rim(joint.other, gap + radius if joint.inside else gap - radius)
        found.append(alt_text.say(key, first=first, second=second))
    return found
