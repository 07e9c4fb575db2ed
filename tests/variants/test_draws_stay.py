"""Variants of released exams: the same key gives the same variant, also after new ways of drawing were added."""

from __future__ import annotations

import pytest

from variantgen.families.reading.load import load_family
from variantgen.variants.draw import draw

# Drawn before hand-friendly variants existed, by the keys ("before", i, 1): form, sense, turns, attempt, values.
DRAWN: list[tuple[str, int, str, int, int, int, dict[str, str]]] = [
    (
        "four_bar",
        0,
        "rocker",
        -1,
        0,
        3,
        {"OA": "28", "AB": "90", "BC": "46", "OC": "75", "phi": "80", "omega_BC": "3.25"},
    ),
    (
        "four_bar",
        1,
        "rocker",
        -1,
        1,
        12,
        {"OA": "50", "AB": "40", "BC": "26", "OC": "70", "phi": "50", "epsilon_BC": "8"},
    ),
    (
        "slider_crank",
        0,
        "driven_by_slider",
        -1,
        0,
        1,
        {"OA": "22", "AB": "64", "phi": "55", "v_B": "45", "a_B": "-120"},
    ),
    ("slider_crank", 1, "central", -1, 2, 1, {"OA": "32", "AB": "62", "phi": "115", "sense": "1", "omega_OA": "4.0"}),
    # The second and the first attempt were too fast for a ladder (v_A = 5.2, v_B = 6 m/s), before there were limits.
    ("ladder", 0, "driven_at_floor", 1, 0, 4, {"AB": "4.2", "phi": "70", "way": "-1", "v_B": "2.5", "a_B": "-1"}),
    ("ladder", 1, "driven_at_floor", -1, 0, 3, {"AB": "5.4", "phi": "60", "way": "-1", "v_B": "2.5", "a_B": "-3"}),
    ("falling_rod", 0, "", -1, 0, 5, {"AB": "4.7", "omega": "1.75", "t": "0.65", "g": "9.8", "sense": "1"}),
    ("wheel_with_rod", 0, "driven_by_slider", 1, 0, 11, {"R": "42", "AB": "112", "alpha": "50", "v_B": "120"}),
    ("wheel_with_rod", 1, "central", -1, 0, 2, {"R": "36", "AB": "116", "alpha": "75", "v_O": "40", "a_O": "60"}),
]


@pytest.mark.parametrize(("family", "number", "form", "sense", "turns", "attempt", "values"), DRAWN)
def test_the_same_variant_as_ever(
    family: str, number: int, form: str, sense: int, turns: int, attempt: int, values: dict[str, str]
) -> None:
    variant = draw(load_family(family), None, [("before", number, 1)])[0]
    assert (variant.form.name, variant.sense, variant.turns, variant.attempt) == (form, sense, turns, attempt)
    assert {name: str(variant.printed[name]) for name in values} == values
