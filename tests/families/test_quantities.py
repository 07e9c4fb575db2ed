"""Asked quantities: magnitude, component, direction, sense, distances from the centres."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.joint_scenes import plate
from variantgen.errors import InputError
from variantgen.exam.sections.tolerance import Tolerance
from variantgen.exam.sheets import answer_variants
from variantgen.families.asking import read_ask
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.mechanism.solving.solve import solve
from variantgen.outputs.documents.key_content import equation
from variantgen.outputs.single.explanation import explain
from variantgen.single import one_variant
from variantgen.testing.linkages import four_bar, slider_crank
from variantgen.variants.draw import draw
from variantgen.wording.answer_notes import answer_notes
from variantgen.wording.formula import to_plain, to_typst
from variantgen.wording.language import load_language
from variantgen.wording.plain import plain_problem

V, A = 3.0 - 4.0j, 2.0 + 1.0j
SCENE = plate(-2.0, 3.0, V, A)
MOTION = solve(SCENE)


@pytest.mark.parametrize(
    ("name", "value", "unit"),
    [
        ("v_A", 5.0, "cm/s"),
        ("v_A.x", 3.0, "cm/s"),
        ("v_A.y", -4.0, "cm/s"),
        ("v_A.angle", math.atan2(-4, 3), "deg"),
        ("a_A.angle", math.atan2(1, 2), "deg"),
        ("omega_ABD", -2.0, "rad/s"),
        ("omega_ABD.abs", 2.0, "rad/s"),
        ("omega_ABD.sense", -1.0, "1"),
        ("epsilon_ABD.sense", 1.0, "1"),
        # P: v = 0 there, at the distance v / |omega|; Q: a = 0 there, at a / sqrt(epsilon^2 + omega^4).
        ("P_ABD.A", 5.0 / 2.0, "cm"),
        ("Q_ABD.A", abs(A) / 5.0, "cm"),
        ("mu_ABD", math.atan2(3.0, 4.0), "deg"),
    ],
)
def test_value_and_unit(name: str, value: float, unit: str) -> None:
    quantity = parse_quantity(name, SCENE)
    assert quantity.name == name
    assert quantity.value(MOTION)[0] == pytest.approx(value, rel=1e-12)
    assert quantity.unit("cm").name == unit


def test_centre_at_infinity_is_infinite_and_null_in_the_document() -> None:
    # Crank across the line of a central slider: the rod is in instantaneous translation.
    motion = solve(slider_crank(0.2, 0.6, 0.0, math.pi / 2, 2.0))
    assert np.isinf(parse_quantity("P_AB.A", motion.scene).value(motion)[0])


def test_distance_from_the_velocity_centre_of_a_four_bar() -> None:
    # P of the coupler is where the lines of crank and rocker cross.
    motion = solve(four_bar(0.2, 0.6, 0.5, 0.7, 1.0, 2.0))
    z = {name: complex(motion.z[name][0]) for name in "OABC"}
    # O + s (A - O) = C + t (B - C), by Cramer.
    u, w, d = z["A"] - z["O"], z["B"] - z["C"], z["C"] - z["O"]
    crossing = z["O"] + (d.conjugate() * w).imag / (u.conjugate() * w).imag * u
    assert parse_quantity("P_AB.B", motion.scene).value(motion)[0] == pytest.approx(abs(crossing - z["B"]))


def test_how_they_are_written() -> None:
    language = load_language("ru")
    names = ["v_B.angle", "omega_AB.abs", "omega_AB.sense", "P_AB.A", "v_B.x"]
    variant = one_variant("four_bar", {"OA": 30}, "1", "crank", names)
    asked = read_ask(variant.form, names)
    symbols = [language.quantity(q, variant.form.symbols) for q in asked]
    assert [to_plain(symbol) for symbol in symbols] == ["∠(v_B, x)", "|ω_AB|", "sgn ω_AB", "AP_AB", "v_B x"]
    assert [to_typst(symbol) for symbol in symbols][1] == "abs(omega_(A B))"
    notes = " ".join(answer_notes(asked, language))
    assert all(word in notes for word in ("∠(v, x)", "sgn", "мгновенный центр скоростей", "Ось x"))
    (answers,) = answer_variants([variant], [tuple(names)], [Tolerance(0.05, 0.1)])
    # Of an angle the like part of a radian may be missing, of a sense nothing.
    assert answers[0].tolerance == pytest.approx(math.degrees(0.05), rel=5e-3)
    assert answers[2].tolerance == 0.0
    assert answers[2].value in {1.0, -1.0}


@pytest.mark.parametrize("name", ["omega_OA", "omega_OA.abs", "omega_OA.sense"])
def test_what_is_given_cannot_be_asked(name: str) -> None:
    with pytest.raises(InputError, match="is given"):
        read_ask(load_family("four_bar").forms["crank"], [name])


def test_what_the_data_do_not_determine_cannot_be_asked() -> None:
    form = load_family("plate_acceleration_centre").forms["square"]
    with pytest.raises(InputError, match="the data of this problem do not determine it"):
        read_ask(form, ["v_B"])


@pytest.mark.parametrize(
    ("name", "said", "instead"),
    [
        ("distance_O.C", "is given, so it cannot be asked", "their distance is a length of the data"),
        ("distance_B.C", "this position is not asked of the family", "may be asked: v_A, v_C, v_B, a_A,"),
        ("v_D", "the data of this problem do not determine it", "may be asked: v_A, v_C, v_B$"),
        ("rho_D", "the data of this problem do not determine it", "distances from centres such as P_OA.O$"),
    ],
)
def test_what_may_be_asked_instead_is_said(name: str, said: str, instead: str) -> None:
    with pytest.raises(InputError, match=rf"(?s){said}.*{instead}"):
        read_ask(load_family("sleeve_on_crank").forms[""], [name])


def test_a_direction_along_an_axis_has_no_noise() -> None:
    """B is guided along an axis of the paper: its acceleration has a whole number of right angles."""
    family = load_family("slider_crank")
    variants = draw(restrict(family, forms=("central",)), ["a_B.angle"], [("noise", str(n)) for n in range(24)])
    found = [answers[0].value for answers in answer_variants(variants, [("a_B.angle",)] * 24, [Tolerance()] * 24)]
    assert set(map(str, found)) <= {"0.0", "90.0", "-90.0", "180.0", "-180.0"}
    assert found.count(0.0) > 1
    explained = str(explain(variants[found.index(0.0)], "en", ask=["a_B.angle"]))
    assert "∠(a_B, x) = 0°." in explained


@pytest.mark.parametrize("language", ["en", "ru"])
def test_a_sense_is_a_whole_number(language: str) -> None:
    for seed in range(4):
        variant = one_variant("four_bar", seed=str(seed), ask=["omega_AB.sense"])
        (answer,) = answer_variants([variant], [("omega_AB.sense",)], [Tolerance()])[0]
        output = f"sgn ω_AB = {'1' if answer.value > 0 else '−1'}"
        words = load_language(language)
        said = plain_problem(variant, [answer.quantity], [(answer.value, answer.unit, answer.surd)], words)
        assert f"{output}." in said
        assert to_plain(equation(answer, words, variant.form.symbols)).strip() == output
        assert f"{output}." in str(explain(variant, language, ask=["omega_AB.sense"]))
