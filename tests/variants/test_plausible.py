"""Size classes of machines: no variant that a reader would smile at."""

from __future__ import annotations

from math import cos, radians, sin

import numpy as np
import pytest
from msgspec.structs import replace

from variantgen.errors import InputError
from variantgen.families.machine import SIZES
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family, parse_family
from variantgen.families.restrict import restrict
from variantgen.mechanism.solving.solve import solve
from variantgen.resources import catalog_dir
from variantgen.tables import read_toml
from variantgen.variants.draw import draw
from variantgen.variants.screening import plausibility_screens
from variantgen.variants.variant import solve_variants

G = 9.81
FORMS = [(name, form) for name in family_names() for form in load_family(name).forms]


def test_every_form_of_the_catalogue_says_what_kind_of_machine_it_is() -> None:
    assert [item for item in FORMS if load_family(item[0]).forms[item[1]].machine is None] == []


def test_what_a_hand_or_a_bench_moves_stays_below_three_g_and_hoists_far_below() -> None:
    assert max(SIZES[size].acceleration for size in ("hand", "bench")) <= 3 * G
    assert SIZES["hoist"].acceleration < G


@pytest.mark.parametrize(
    ("name", "form"),
    [
        ("movable_pulley", "load_and_axle"),
        ("ladder", "driven_at_wall"),
        ("ladder", "oblique"),
        ("hydraulic_hoist", "with_rod"),
        ("four_bar", "directions"),
    ],
)
def test_nothing_drawn_is_faster_than_its_machine(name: str, form: str) -> None:
    family = restrict(load_family(name), forms=[form])
    machine = family.forms[form].machine
    assert machine is not None
    variants = draw(family, None, [("plausible", i) for i in range(100)])
    motion = solve_variants(variants, 2)
    shown = [point for point in motion.a if point not in family.forms[form].figure.hidden]
    limit = 1 + 1e-6
    assert max(np.abs(motion.a[point]).max() for point in shown) <= machine.acceleration * limit
    assert max(np.abs(motion.v[point]).max() for point in shown) <= machine.speed * limit
    assert max(np.abs(rate).max() for rate in motion.omega.values()) <= machine.omega * limit
    assert max(np.abs(rate).max() for rate in motion.epsilon.values()) <= machine.epsilon * limit
    # There is something to keep out: without the limits some of them are beyond.
    free = replace(family, forms={form: replace(family.forms[form], machine=None)})
    wild = solve_variants(draw(free, None, [("plausible", i) for i in range(100)]), 2)
    assert max(np.abs(wild.a[point]).max() for point in shown) > machine.acceleration


def test_the_limits_are_met_exactly_or_not() -> None:
    # A ladder of 2 m, its end B on the floor at 45 degrees; v_A = 3 m/s: v_B = v_A tan 45, omega = v_A / (2 cos 45),
    # a_B = -omega^2 AB / cos 45 for a_A = 0 (x_B = 2 cos phi, y_A = 2 sin phi, differentiated by hand).
    family = load_family("ladder")
    form = family.forms["driven_at_wall"]
    assert form.machine is not None
    phi, length, v = radians(45), 2.0, 3.0
    omega = v / (length * cos(phi))
    a_b = omega**2 * length * (cos(phi) + sin(phi) ** 2 / cos(phi))
    assert a_b == pytest.approx(12.73, abs=0.01)
    values = form.values({"AB": length, "phi": phi, "way": -1.0, "v_A": v, "a_A": 0.0})
    values = {name: np.atleast_1d(value) for name, value in values.items()}
    motion = solve(form.scene(values), 2, form.plan)
    for limit, passed in ((12.7, False), (12.8, True)):
        narrow = replace(form, machine=replace(form.machine, acceleration=limit))
        found = plausibility_screens(narrow, motion)[f"acceleration up to {limit} m/s^2 (hand)"]
        assert found.tolist() == [passed]


@pytest.mark.parametrize(
    ("machine", "said"),
    [
        ({"size": "rocket"}, ["machine.size", '"hand", "bench"', "rocket"]),
        ({}, []),
        ({"speed": "3 m/s"}, ["machine.size", "missing", "hand"]),
        ({"size": "hand", "speed": "3 m"}, ["machine.speed", "measures length"]),
        ({"size": "hand", "speed": "3"}, ["machine.speed", "with its unit", "12 m/s"]),
        ({"size": "hand", "speed": "-3 m/s"}, ["machine.speed", "above 0"]),
        ({"size": "hand", "speed": 3}, ["machine.speed", "in quotes"]),
        ({"size": "hand", "spead": "3 m/s"}, ["machine.spead", "speed"]),
    ],
)
def test_what_is_wrong_in_the_table_is_told(machine: dict[str, object], said: list[str]) -> None:
    path = catalog_dir() / "ladder" / "family.toml"
    content = {**read_toml(path), "machine": machine}
    if not said:
        assert all(form.machine is None for form in parse_family(content, path).forms.values())
        return
    with pytest.raises(InputError) as caught:
        parse_family(content, path)
    for word in said:
        assert word in str(caught.value)


def test_a_form_has_limits_of_its_own() -> None:
    path = catalog_dir() / "ladder" / "family.toml"
    content = read_toml(path)
    content["forms"]["oblique"]["machine"] = {"speed": "150 cm/s"}
    forms = parse_family(content, path).forms
    speeds = {name: form.machine.speed for name, form in forms.items() if form.machine}
    assert speeds == {"driven_at_wall": 5.0, "driven_at_floor": 5.0, "oblique": 1.5}
