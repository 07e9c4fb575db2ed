"""Verdicts and causes of single answers, the second way of follow-through: numbers worked out here."""

from __future__ import annotations

from math import pi

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from msgspec.structs import replace

from variantgen.exam.sections.marking_policy import CAUSES
from variantgen.exam.sheets import Answer
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import split_name
from variantgen.families.reading.load import load_family
from variantgen.marking.diagnosis.causes import Cause, Comparisons, cause_of
from variantgen.marking.diagnosis.consequences import confirms
from variantgen.marking.key import is_right
from variantgen.marking.marks import Verdict, verdict_of
from variantgen.variants.draw import draw
from variantgen.variants.variant import solve_variants


def answer(name: str, value: float, tolerance: float, measured: str) -> Answer:
    return Answer(split_name(name), unit(measured), value, tolerance)


SPEED = answer("v_B", 47.487, 0.475, "cm/s")
RATE = answer("omega_AB", 0.5422, 0.0054, "rad/s")
DIRECTION = answer("v_B.angle", -30.0, 0.5, "deg")


@pytest.mark.parametrize("value", [-30.0, 330.0, 690.0, -390.0, 330.5, -30.5])
def test_whole_turns_do_not_change_a_direction(value: float) -> None:
    assert is_right(DIRECTION, value)
    assert not is_right(DIRECTION, value + 1.1)


@given(
    st.one_of(
        st.floats().map(repr),
        st.integers().map(str),
        st.from_regex(r"-?[0-9]{1,3}([., ][0-9]{3}){0,2}(e-?[0-9]{1,3})? ?(m/s|deg|km|1/s)?", fullmatch=True),
    ),
    st.sampled_from([SPEED, RATE, DIRECTION, answer("omega_AB.sense", 1.0, 0.0, "1")]),
)
@example("5e-324", SPEED)
@example("1e40", DIRECTION)
@example("9" * 32, DIRECTION)
@example("1e100 km", DIRECTION)
def test_whatever_is_typed_has_a_verdict(text: str, asked: Answer) -> None:
    _, value, verdict, cause = verdict_of(asked, text)
    assert (verdict is Verdict.WRONG) == (cause is not None)
    if value is not None and not is_right(asked, value):
        assert cause_of(value, asked, Comparisons()).name in CAUSES


@pytest.mark.parametrize(
    ("asked", "value", "cause"),
    [
        (SPEED, -47.49, Cause("sign")),
        (SPEED, 474.9, Cause("power_of_ten")),
        (SPEED, 0.4749, Cause("unit")),
        (SPEED, 4749.0, Cause("unit")),
        (SPEED, 170.95, Cause("unit")),  # km/h: 3.6 times
        (SPEED, 48.5, Cause("rounding")),
        (SPEED, 60.0, Cause("other")),
        (SPEED, 47.487 * 12, Cause("other")),
        (RATE, 0.5422 * 30 / pi, Cause("unit")),
        (RATE, 0.5422 * 180 / pi, Cause("unit")),
        (RATE, 0.5422 * 3.6, Cause("other")),
        (DIRECTION, 30.0, Cause("sign")),
        (DIRECTION, 150.0, Cause("sign")),
        (DIRECTION, 120.0, Cause("component")),
        (DIRECTION, -30.0 * pi / 180, Cause("unit")),
    ],
)
def test_causes(asked: Answer, value: float, cause: Cause) -> None:
    assert cause_of(value, asked, Comparisons()) == cause


def test_other_numbers_of_the_sheet() -> None:
    around = Comparisons({"2.v_A": answer("v_A", 0.8, 0.008, "m/s"), "2.a_A": answer("a_A", 77.0, 0.8, "cm/s^2")})
    assert cause_of(80.0, SPEED, around) == Cause("other_answer", "2.v_A")
    assert cause_of(77.0, SPEED, around) == Cause("other")
    parts = Comparisons(parts={"v_B.x": 33.0}, mistakes={"AB in degrees for radians": 33.3})
    assert cause_of(33.01, SPEED, parts) == Cause("component", "v_B.x")
    assert cause_of(33.3, SPEED, parts) == Cause("mistake", "AB in degrees for radians")


def test_what_follows_is_confirmed_by_theorems() -> None:
    """A four-bar: v_B = omega_BC BC, and the accelerations of B with a wrong rate of AB; other numbers are refused."""
    (variant,) = draw(load_family("four_bar"), None, [("consequences", 1)])
    crank = replace(variant, form=variant.form)
    motion = solve_variants([crank], 2)
    z, v = motion.z, motion.v
    wrong = 1.3 * float(motion.omega["BC"][0])
    follows = abs(wrong) * float(abs(z["B"][0] - z["C"][0]))
    asked, given = split_name("v_B"), split_name("omega_BC")
    assert confirms(crank, motion, {given: wrong}, asked, follows)
    assert not confirms(crank, motion, {given: wrong}, asked, 1.07 * follows)
    assert follows == pytest.approx(1.3 * float(abs(v["B"][0])))
    # a_B by the base point C at rest: tangential part as it is, normal part by the wrong rate.
    arm = z["B"][0] - z["C"][0]
    of_b = abs((1j * float(motion.epsilon["BC"][0]) - wrong**2) * arm)
    assert confirms(crank, motion, {given: wrong}, split_name("a_B"), of_b)
    assert not confirms(crank, motion, {given: wrong}, split_name("a_B"), 1.07 * of_b)
