"""The calculator of the tests itself, by hand."""

from __future__ import annotations

import math

import pytest

from tests.calculator import UnreadableError, evaluate, last_unit


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("3 · 40", 120.0),
        ("−950 · cos 60° / 2", -237.5),
        ("(1 + 2) / (4 − 1)", 1.0),
        ("√(4^2 + 3^2)", 5.0),
        ("2 · 3 · (−4)", -24.0),
        ("arctan(1 / 1) + 180°", 225.0),
        ("cos(−60°)", 0.5),
        ("|−3 + 1|", 2.0),
        ("−2^2 + 5", 1.0),
        ("1 − 2 − 3", -4.0),
        ("12 / 3 / 2", 2.0),
    ],
)
def test_arithmetic(text: str, value: float) -> None:
    assert evaluate(text) == pytest.approx(value, abs=1e-12)


def test_symbols_and_products_without_a_dot() -> None:
    known = {"ω_BD": 2.0, "v_отн C": 3.0, "v": 100.0, "v_A": 4.0}
    assert evaluate("2\u2009ω_BD · v_отн C", known) == 12.0
    assert evaluate("v_A\u2009cos 60°", known) == pytest.approx(2.0)
    assert evaluate("1,5 · 2", mark=",") == 3.0


def test_what_is_no_arithmetic_is_refused() -> None:
    for text in ("v_B", "3 +", "(1", "3 · 4 см"):
        with pytest.raises((UnreadableError, IndexError)):
            evaluate(text)


def test_unit_of_the_last_digit() -> None:
    assert last_unit("182.99") == pytest.approx(0.01)
    assert last_unit("−0.47108") == pytest.approx(0.00001)
    assert last_unit("120") == pytest.approx(0.01)
    assert last_unit("0,5", ",") == pytest.approx(1e-5)
    assert math.isclose(last_unit("2135.12345"), 1e-5)
