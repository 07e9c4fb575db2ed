"""Numbers as students write them."""

from __future__ import annotations

from math import pi, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from variantgen.families.parameters.units import unit
from variantgen.marking.typed_number import LONGEST, read_number


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("2,95", (2.95,)),
        ("5*10**-2", (0.05,)),
        ("-0.8", (-0.8,)),
        ("−0,8", (-0.8,)),
        (" +3 ", (3.0,)),
        ("1 234.5", (1234.5,)),
        ("1\N{NO-BREAK SPACE}234,5", (1234.5,)),
        ("1'234,5", (1234.5,)),
        ("1.234,5", (1234.5,)),
        ("1,234.5", (1234.5,)),
        ("1,234,567", (1234567.0,)),
        ("1,234", (1.234, 1234.0)),
        ("0,234", (0.234,)),
        ("5·10^-2", (0.05,)),
        ("5×10⁻²", (0.05,)),
        ("5*10^(-2)", (0.05,)),
        ("3e-2", (0.03,)),
        ("7/2", (3.5,)),
        ("40√3/3", (40 * sqrt(3) / 3,)),
        ("√(3)/2", (sqrt(3) / 2,)),
        ("-sqrt2", (-sqrt(2),)),
        ("2π/3", (2 * pi / 3,)),
    ],
)
def test_what_is_a_number(text: str, values: tuple[float, ...]) -> None:
    found = read_number(text)
    assert found is not None
    assert found.values == pytest.approx(values)
    assert found.unit is None


@pytest.mark.parametrize(
    "text",
    [
        "",
        "abc",
        "--2",
        "5 3",
        "34.1 341",
        "3.5 100",
        "3,5 100",
        "7 100/3",
        "7/2 100",
        "0 341",
        "1234 567",
        "5e-324",
        "3 1/2",
        "2.5.3",
        "1/0",
        "√-1",
        "1e999",
        "10^99",
        "(2",
        "2)",
        "2 apples",
        "=1+1",
        "2+3",
        "2095-02-01 00:00:00",
        "9" * (LONGEST + 1),
    ],
)
def test_what_is_none(text: str) -> None:
    assert read_number(text) is None


@pytest.mark.parametrize(
    ("text", "own", "value"),
    [
        ("1.2 m/s", "cm/s", 120.0),
        ("120 см/с", "m/s", 1.2),
        ("1,2 м / с", "cm/s", 120.0),
        ("1.2 m s^-1", "cm/s", 120.0),
        ("2,95 м·с⁻²", "cm/s^2", 295.0),
        ("2.95 м/с²", "cm/s^2", 295.0),
        ("2.95 m/s2", "m/s^2", 2.95),
        ("0.5 1/s", "rad/s", 0.5),
        ("0,5 с^-1", "rad/s", 0.5),
        ("60 rpm", "rad/s", 2 * pi),
        ("π/6 rad", "deg", 30.0),
        ("30°", "deg", 30.0),
        ("12", "cm", 12.0),
    ],
)
def test_units_as_typed(text: str, own: str, value: float) -> None:
    found = read_number(text)
    assert found is not None
    assert found.in_unit(unit(own)) == pytest.approx((value,))


def test_a_product_has_no_digits_of_its_own() -> None:
    """In binary numbers 275.08802 / 100 is 2.7508801999999997, which is below the end of a tolerance at 2.7508802."""
    found = read_number("275.08802*10^-2")
    assert found is not None
    assert found.values == (2.7508802,)


def test_a_unit_of_something_else_gives_no_value() -> None:
    found = read_number("3 m")
    assert found is not None
    assert found.in_unit(unit("m/s")) is None


@given(st.text(max_size=LONGEST))
def test_any_text_is_a_number_or_none(text: str) -> None:
    found = read_number(text)
    assert found is None or found.values


@given(st.floats(-1e6, 1e6, allow_subnormal=False), st.sampled_from([".", ","]))
def test_decimals_with_either_mark(value: float, mark: str) -> None:
    text = f"{value:.5f}".replace(".", mark)
    found = read_number(text)
    assert found is not None
    assert found.values[0] == pytest.approx(value, abs=1e-5)
