"""Closed forms beside decimals: where they say something, and how they are written."""

from __future__ import annotations

from math import pi, sqrt

import pytest

from variantgen.families.parameters.units import unit
from variantgen.wording.formula import Equation, Measured, Surd, Symbol, to_plain
from variantgen.wording.language import load_language
from variantgen.wording.surds import surd, with_surd


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (40 / sqrt(3), Surd(40, 3, 3)),
        (-sqrt(2), Surd(-1, 1, 2)),
        (sqrt(5) / 2, Surd(1, 2, 5)),
        (4 / 3, Surd(4, 3, 1)),
        (-4 / 3, Surd(-4, 3, 1)),
        (3 * sqrt(7) / 4, Surd(3, 4, 7)),
    ],
)
def test_roots_and_fractions(value: float, expected: Surd) -> None:
    assert surd(value) == expected


@pytest.mark.parametrize(
    "value",
    [
        17 / 16,
        78 / 23,
        1001 / 8,
        400 / 3,
        0.35 * sqrt(3),
        2 * sqrt(22),
        5 * sqrt(194) / 26,
        5 * sqrt(3) / 12,
        0.0,
        0.25,
        -0.25,
        120.0,
        1234.0,
        0.0625,
        12.25,
        23.09,
        pi,
        float("inf"),
    ],
)
def test_none_where_the_decimal_says_it_all_or_there_is_no_root(value: float) -> None:
    assert surd(value) is None


@pytest.mark.parametrize(
    ("language", "text"), [("en", "v_B = 40√3/3 ≈ 23.09 cm/s"), ("ru", "v_B = 40√3/3 ≈ 23,09 см/с")]
)
def test_written_before_the_decimal(language: str, text: str) -> None:
    spoken, value = load_language(language), 40 / sqrt(3)
    equation = Equation(spoken.symbol("v_B", {}), Measured(spoken.rounded(value), spoken.unit(unit("cm/s"))))
    assert to_plain(with_surd(equation, surd(value))).replace("\N{NO-BREAK SPACE}", " ") == text
    assert with_surd(equation, None) is equation
    assert isinstance(equation.left, Symbol)
