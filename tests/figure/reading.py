"""Reading finished figures back: arrows, dots, scale bars, as a reader with a ruler would."""

from __future__ import annotations

from itertools import pairwise
from types import ModuleType

import pytest
from msgspec.structs import replace

from variantgen.errors import InputError
from variantgen.families.family import Form
from variantgen.families.quantities import Quantity, parse_quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.figure.drawing import Arc, Drawing, Layer, Path
from variantgen.figure.sketch import DOT
from variantgen.mechanism.motion import Motion
from variantgen.variants.draw import FamilySampler as Draws
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import load_language

FORMS = [(name, form) for name in family_names() for form in load_family(name).forms]


def variants_of(name: str, form_name: str, count: int) -> tuple[list[Variant], Motion, list[Quantity]]:
    """Drawn variants of one form, solved with accelerations, and what the form asks."""
    family = load_family(name)
    form: Form = family.forms[form_name]
    variants = Draws(replace(family, forms={form_name: form}), None).after(
        [("motion", i) for i in range(count)], [0] * count
    )
    return variants, solve_variants(variants, 2), [parse_quantity(text, form.sample) for text in form.ask]


def view_drawings(
    name: str, form: str, order: int, views: tuple[ModuleType, ModuleType], count: int
) -> list[tuple[Variant, Motion, int, Drawing]]:
    """Figures of the view for velocities or accelerations; none where the form asks for no accelerations."""
    variants, motion, asked = variants_of(name, form, count)
    language = load_language("en")
    if order > max(q.order for q in asked):
        with pytest.raises(InputError, match="none are asked"):
            views[1].draw(variants[0], motion, 0, asked, language)
        return []
    return [(v, motion, i, views[order - 1].draw(v, motion, i, asked, language)) for i, v in enumerate(variants)]


def arrows(drawing: Drawing, layer: Layer) -> list[tuple[complex, complex]]:
    """Start and tip of the straight arrows of a layer: a stroke followed by a filled triangle at its end."""
    paths = [line for line in drawing.lines if isinstance(line, Path) and line.layer == layer]
    found = []
    for shaft, head in pairwise(paths):
        if len(shaft.points) == 2 and len(head.points) == 3 and head.closed and head.fill == "ink":
            found.append((shaft.points[0], head.points[0]))
    return found


def dots(drawing: Drawing) -> list[complex]:
    """Centres of filled dots."""
    return [
        line.centre
        for line in drawing.lines
        if isinstance(line, Arc) and line.full and line.fill == "ink" and abs(line.radius - DOT) < 1e-9
    ]


def has_arrow(found: list[tuple[complex, complex]], start: complex, end: complex, within: float = 1e-6) -> bool:
    """Whether one of the arrows leads from start to end."""
    return any(abs(a - start) < within and abs(b - end) < within for a, b in found)
