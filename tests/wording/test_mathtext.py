"""Formulas in the markup of matplotlib: right, and harmless whatever a word holds."""

from __future__ import annotations

import pytest
from matplotlib import rc_context
from matplotlib.mathtext import MathTextParser

from variantgen.families.parameters.units import UNITS
from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.outputs.single.motion_plot import STYLE
from variantgen.resources import languages
from variantgen.wording.formula import Equation, Formula, Index, Measured, Number, Symbol, SymbolProperty, UnitText
from variantgen.wording.language import load_language
from variantgen.wording.mathtext import to_mathtext

EXAMPLES: list[tuple[Formula, str]] = [
    (Symbol("v", (Index("B"), Index("x"))), r"$v_{B\,x}$"),
    (Symbol("omega", (Index("O1A"),)), r"$\omega_{O_{1}A}$"),
    (Symbol("phi"), r"$\varphi$"),
    (Symbol("a", (Index("B"),), (Index("n"),)), r"$a_{B}^{n}$"),
    (Symbol("v", (Index("отн", True), Index("C"))), r"$v_{\mathrm{отн}\,C}$"),
    (Number("−0,25"), "${−}0{,}25$"),
    (UnitText((("см/с", 2),)), r"$\mathrm{см/с}^{2}$"),
    (Measured(Number("30"), UnitText((("°", 1),), True)), r"$30\mathrm{°}$"),
    (Equation(Symbol("r"), Measured(Number("5"), UnitText((("cm", 1),)))), r"$r=5\,\mathrm{cm}$"),
    (SymbolProperty("modulus", Symbol("omega")), r"$|\omega|$"),
]


def drawn(markup: str) -> float:
    """Width of a formula as matplotlib sets it; an error if it cannot."""
    with rc_context(STYLE):
        return float(MathTextParser("path").parse(markup).width)


@pytest.mark.parametrize(("formula", "markup"), EXAMPLES)
def test_markup(formula: Formula, markup: str) -> None:
    assert to_mathtext(formula) == markup
    assert drawn(markup) > 0


@pytest.mark.parametrize("language", languages())
def test_every_quantity_and_unit_can_be_set(language: str) -> None:
    words = load_language(language)
    formulas: set[Formula] = {words.unit(unit) for unit in UNITS.values() if unit.name != "1"}
    for name in family_names():
        for form in load_family(name).forms.values():
            formulas |= {words.quantity(parse_quantity(text, form.sample), form.symbols) for text in form.askable}
    for markup in {to_mathtext(formula) for formula in formulas}:
        assert " " not in markup
        assert drawn(markup) > 0


@pytest.mark.parametrize("letter", list("\\{}$%_#&^~'`\" \N{NO-BREAK SPACE}<>@;:()[]|/*+=-"))
def test_letters_with_a_meaning_are_harmless(letter: str) -> None:
    for formula in (UnitText(((f"a{letter}b", 1),)), Number(f"1{letter}2")):
        markup = to_mathtext(formula)
        assert " " not in markup
        assert drawn(markup) > drawn("$1$")
