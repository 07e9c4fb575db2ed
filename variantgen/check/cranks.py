"""Whether what the text calls a crank can go full circle, and what it calls a rocker cannot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from variantgen.check.printed import Fault
from variantgen.check.statement_reading import StatementReading
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.scene import fixed_points
from variantgen.mechanism.turn.revolution import can_revolve

_GOES_ROUND = {"crank": True, "rocker": False}
_REMEDY = "require lengths in [screens] by which it {can}, or call it a link"


def wrong_cranks(sheets: Sequence[StatementReading], motion: Motion, place: int) -> Iterator[tuple[str, Fault]]:
    """Links that the statements of a variant call cranks though they cannot revolve, or rockers though they can.

    The language comes first. Only links with a fixed point are looked at: others revolve about nothing.
    """
    fixed = fixed_points(motion.scene)
    called = {
        (sheet.language, mention.noun, mention.name)
        for sheet in sheets
        for mention in sheet.mentions
        if mention.noun in _GOES_ROUND and set(motion.scene.bodies.get(mention.name, ())) & set(fixed)
    }
    if not called:
        return
    one = motion.take(np.array([place]))
    revolves = {name: can_revolve(one, name) for name in sorted({name for _, _, name in called})}
    for language, noun, name in sorted(called):
        if revolves[name] is not _GOES_ROUND[noun]:
            can = "can" if revolves[name] else "cannot"
            remedy = _REMEDY.format(can="cannot" if revolves[name] else "can")
            kind = f"the text calls {name} a {noun}, but it {can} go full circle"
            yield language, (kind, f"{kind}; {remedy}")
