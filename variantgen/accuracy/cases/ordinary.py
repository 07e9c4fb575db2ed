"""Ordinary variants: every family and form of the catalogue, as a class of students gets them."""

from __future__ import annotations

from msgspec.structs import replace
from numpy.random import Generator

from variantgen.accuracy.cases._shapes import four_bars, grouped, slider_cranks
from variantgen.accuracy.computed import CaseGroup
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.variants.draw import draw
from variantgen.variants.variant import solve_variants

TITLE = "ordinary variants"
ABOUT = "Every family and form of the catalogue, and four-bars and slider-cranks of ordinary proportions."
PLACE = 0


def groups(count: int, rng: Generator) -> list[CaseGroup]:
    """At least one variant of every form."""
    found = []
    for name in family_names():
        family = load_family(name)
        for label, form in family.forms.items():
            single = replace(family, forms={label: form})
            number = max(1, count // 48)
            keys = [(str(seed), "accuracy") for seed in rng.integers(10**6, size=number)]
            motion = solve_variants(draw(single, None, keys), 0)
            found.append(CaseGroup(f"{name}/{label}" if label else name, motion.scene, number))
    found.append(grouped("four-bar", four_bars(rng, count), count))
    found.append(grouped("slider-crank", slider_cranks(rng, count), count))
    return found
