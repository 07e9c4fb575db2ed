"""Hand-friendly variants of every family: there are enough, and they are what they are called."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest
from msgspec.structs import replace

from variantgen.families.asking import read_ask
from variantgen.families.family import Family
from variantgen.families.nice import hand_friendly
from variantgen.families.quantities import Quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.figure.build import statement_figure
from variantgen.figure.inspection.faults import figure_faults
from variantgen.mechanism.motion import Motion
from variantgen.resources import languages
from variantgen.variants.attempts import FormSampler
from variantgen.variants.batch import RejectionCounts
from variantgen.variants.draw import FamilySampler, draw
from variantgen.variants.seeding import Stream
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import load_language
from variantgen.wording.statement import statement

FORMS = [(name, form) for name in family_names() for form in load_family(name).forms]
NONE = {("guided_plate", ""), ("three_rod_plate", ""), ("wheel_with_rod", "driven_by_slider")}
# Only the data of these forms are nice. The answers of the first hold pi; in the others every product of data and the
# sides of their triangles has a factor 11, 13, ... in its denominator, so answers are decimals.
DECIMALS = {
    ("falling_rod", ""), ("slider_crank", "driven_by_slider"), ("quick_return_shaper", ""),
    ("wheel_with_rod", "central"), ("limit_positions", "slider"), ("limit_positions", "rocker"),
    ("slider_crank_with_graph", "read"), ("slider_crank_with_graph", "sketch"),
}  # fmt: skip
SOURCES = {
    "rolling_wheel", "ladder", "four_bar", "slider_crank", "slider_crank_with_second_rod", "planetary_pair", "spool",
    "movable_pulley", "triangle_plate", "plate_acceleration_centre", "two_loop_mechanism", "sleeve_on_crank",
    "falling_rod",
}  # fmt: skip


def single(name: str, form: str) -> Family:
    return restrict(load_family(name), forms=[form], nice=True)


def drawn(name: str, form: str, count: int) -> list[Variant]:
    return draw(single(name, form), None, [("nice", i) for i in range(count)])


def is_short(value: float) -> bool:
    """A decimal of at most three digits."""
    rounded = float(f"{value:.2e}")
    return abs(value - rounded) <= 1e-11 * abs(rounded)


def is_simple(value: float) -> bool:
    """A short decimal, a third of a small whole number, or p/q times a root of 2, 3, 5, 6 or 7, tried one by one.

    q is up to 4; p is below 100, or such a number with zeros at its end.
    """
    small = [p * 10**zeros for p in range(1, 100) for zeros in range(4)]

    def fits(form: float) -> bool:
        return abs(abs(value) - form) <= 1e-11 * form

    return (
        is_short(value)
        or any(fits(p / 3) for p in range(1, 100))
        or any(fits(p / q * sqrt(n)) for n in (2, 3, 5, 6, 7) for q in (1, 2, 3, 4) for p in small)
    )


def test_families_of_the_sources_have_them() -> None:
    assert all(load_family(name).nice_forms == list(load_family(name).forms) for name in SOURCES)
    assert {(n, f) for n, f in FORMS if not load_family(n).forms[f].nice.possible} == NONE


@pytest.mark.parametrize(("name", "form"), [item for item in FORMS if item not in NONE])
def test_enough_distinct_ones_soon(name: str, form: str) -> None:
    variants = drawn(name, form, 120)
    assert len({variant.identity for variant in variants}) >= 80
    assert sum(variant.attempt for variant in variants) / len(variants) < 1000


@pytest.mark.parametrize(("name", "form"), [item for item in FORMS if item not in NONE])
def test_angles_and_answers(name: str, form: str) -> None:
    variants = drawn(name, form, 30)
    for variant in variants:
        for key, parameter in variant.form.parameters.items():
            usual = parameter.unit is None or parameter.unit.name != "deg" or parameter.silent
            assert usual or variant.printed[key] % 30 == 0 or variant.printed[key] % 45 == 0, key
    if (name, form) in DECIMALS:
        if name == "falling_rod":
            turned = [float(v.printed["omega"]) * 6 * float(v.printed["t"]) for v in variants]
            assert all(angle % 30 == 0 or angle % 45 == 0 for angle in turned)
        return
    asked = read_ask(variants[0].form)
    motion = solve_variants(variants, 2)
    simple = np.array([[is_simple(value) for value in printed(q, variants[0].family, motion)] for q in asked])
    for quantity, row in zip(asked, simple, strict=True):
        assert row.all() or quantity.order == 2 or quantity.is_angle, quantity.name
    assert (2 * simple.sum(axis=0) >= len(asked)).all()


def printed(quantity: Quantity, family: Family, motion: Motion) -> list[float]:
    unit = quantity.unit(family.length_unit)
    return [unit.from_si(float(value)) for value in quantity.value(motion)]


@pytest.mark.parametrize(("name", "form"), [item for item in FORMS if item not in NONE])
def test_every_row_is_of_use(name: str, form: str) -> None:
    family = single(name, form)
    ties = family.forms[form].ties
    for row in ties.rows if ties else ():
        fixed = dict(zip(ties.names, row, strict=True))
        assert draw(restrict(family, fixed), None, [("row", 1)])[0].printed.items() >= fixed.items()


@pytest.mark.parametrize(("name", "form"), [item for item in FORMS if item not in NONE])
def test_statements_and_figures(name: str, form: str) -> None:
    variants = drawn(name, form, 12)
    asked = read_ask(variants[0].form)
    motion = solve_variants(variants, 0)
    for place, variant in enumerate(variants):
        for language in languages():
            assert statement(variant, asked, load_language(language)).given
        figure = statement_figure(variant, motion, place, asked, load_language("en"))
        assert figure_faults(figure) == [], (variant.printed, figure_faults(figure))


@pytest.mark.parametrize(("name", "form"), sorted(NONE))
def test_forms_that_have_none_have_none(name: str, form: str) -> None:
    family = load_family(name)
    nice = hand_friendly(replace(family.forms[form], nice=replace(family.forms[form].nice, possible=True)))
    drawing = FormSampler(family, nice, read_ask(nice), RejectionCounts(), name)
    size, width = 20_000, len(drawing.names) + 1
    words = Stream("none", name).words(size * width).reshape(-1, width)
    attempts = drawing.attempts(words, np.arange(size), np.arange(size))
    assert drawing.valid(attempts).owner.size == 0
    assert drawing.tally.rejected["hand-friendly answers"] > 500, "hundreds came as far as their answers"


@pytest.mark.parametrize("name", ["four_bar", "two_loop_mechanism", "slider_crank", "spool"])
def test_a_variant_depends_on_its_key_alone(name: str) -> None:
    family = restrict(load_family(name), nice=True)
    keys = [("s", f"student {i}", 1) for i in range(25)]
    together = draw(family, None, keys)
    assert [draw(family, None, [key])[0].printed for key in keys[::6]] == [v.printed for v in together[::6]]
    assert draw(family, None, keys[::-1])[::-1] == together
    # The second choice of a student follows the first in the same stream.
    second = FamilySampler(family, None).after(keys, [variant.attempt for variant in together])
    assert all(later.attempt > first.attempt for later, first in zip(second, together, strict=True))


@pytest.mark.parametrize(
    ("value", "simple"),
    [(40 / sqrt(3), True), (1.9296, False), (1.25, True), (pi, False), (sqrt(11), False), (5 / sqrt(7), False)],
)
def test_what_is_called_simple(value: float, simple: bool) -> None:
    assert is_simple(value) == simple
