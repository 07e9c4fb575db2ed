"""The whole mechanism scaled by 1e-9 to 1e9."""

from __future__ import annotations

from msgspec.structs import replace
from numpy.random import Generator

from variantgen.accuracy.cases._shapes import four_bars, grouped, slider_cranks
from variantgen.accuracy.computed import CaseGroup

TITLE = "whole mechanism scaled"
ABOUT = "Ordinary proportions, all lengths times 1e-9 to 1e9."
PLACE = 6


def groups(count: int, rng: Generator) -> list[CaseGroup]:
    """A group per factor and mechanism."""
    powers = (-9, -6, -3, 3, 6, 9)
    each = max(1, count // len(powers))
    found = []
    for power in powers:
        factor = 10.0**power
        bar = four_bars(rng, each)
        bar = replace(bar, **{name: factor * getattr(bar, name) for name in ("a", "b", "c", "d")})
        found.append(grouped(f"four-bar, 1e{power}", bar, each, factor=factor))
        crank = slider_cranks(rng, each)
        crank = replace(crank, **{name: factor * getattr(crank, name) for name in ("a", "b", "height")})
        found.append(grouped(f"slider-crank, 1e{power}", crank, each, factor=factor))
    return found
