"""Fixed hinges, all in one clause."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.figure.telling.teller import Teller
from variantgen.mechanism.joints.pivot import Pivot


def tell(teller: Teller, items: Sequence[Pivot]) -> list[str]:
    """``O and C are fixed hinges``."""
    names = [teller.name(joint.point) for joint in items if teller.is_shown(joint.point)]
    if not names:
        return []
    return [teller.say("pivot" if len(names) == 1 else "pivot_many", points=teller.listed(names))]
