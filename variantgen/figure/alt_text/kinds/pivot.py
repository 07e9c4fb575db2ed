"""Fixed hinges, all in one clause."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.alt_text.alt_text import AltText
from variantgen.mechanism.joints.pivot import Pivot


def tell(alt_text: AltText, items: Sequence[Pivot]) -> list[str]:
    """``O and C are fixed hinges``."""
    names = [alt_text.name(joint.point) for joint in items if alt_text.is_shown(joint.point)]
    if not names:
        return []
    return [alt_text.say("pivot" if len(names) == 1 else "pivot_many", points=alt_text.listed(names))]
