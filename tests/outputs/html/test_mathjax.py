"""Formulas for MathJax: LaTeX inside HTML, without escapes inside text."""

from __future__ import annotations

import html
import re

import pytest

from variantgen.outputs.html.mathjax import to_mathjax
from variantgen.wording.formula import Index, Measured, Number, Symbol, UnitText


def test_a_formula_stands_between_delimiters() -> None:
    assert to_mathjax(Symbol("v", (Index("B"),))) == r"\(v_{B}\)"
    assert to_mathjax(Symbol("v"), display=True) == r"\(\displaystyle v\)"


def test_a_decimal_comma_has_no_room_after_it() -> None:
    speed = Measured(Number("12,5"), UnitText((("см/с", 2),)))
    assert to_mathjax(speed) == r"\(12{,}5\,\text{см/с}^{2}\)"


@pytest.mark.parametrize(
    ("unit", "expected"),
    [
        ("a%b", r"\({\text{a}\%\text{b}}\)"),
        ("{1}", r"\({\{\text{1}\}}\)"),
        ("a\\)", r"\({\text{a}\backslash \text{)}}\)"),
        ("a_b#c&d$e", r"\({\text{a}\_\text{b}\#\text{c}\&\text{d}\$\text{e}}\)"),
        ("~^", r"\({\sim \wedge }\)"),
        ("a<b>", r"\(\text{a<b>}\)"),
    ],
)
def test_text_has_no_escapes_inside(unit: str, expected: str) -> None:
    made = to_mathjax(UnitText(((unit, 1),)))
    assert "<" not in made
    assert html.unescape(made) == expected
    assert not any("\\" in inside for inside in re.findall(r"\\text\{(.*?)\}", expected))
