"""Formulas as HTML: sound markup, whatever the names are."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.wording.formula import (
    Equation,
    FormulaList,
    Index,
    Measured,
    Number,
    Symbol,
    SymbolProperty,
    UnitText,
    to_plain,
)
from variantgen.wording.html import to_html
from variantgen.wording.language import load_language

FASTER = UnitText((("см", 1), ("<с>", -2)))


@pytest.mark.parametrize(
    ("formula", "markup"),
    [
        (Symbol("omega", (Index("OA"),)), "<i>ω</i><sub><i>O</i><i>A</i></sub>"),
        (Symbol("O1"), "<i>O</i><sub>1</sub>"),
        (Symbol("v", (Index("отн", True), Index("M"))), "<i>v</i><sub>отн\u2009<i>M</i></sub>"),
        (Symbol("a", (Index("B"),), (Index("tau"),)), "<i>a</i><sup><i>τ</i></sup><sub><i>B</i></sub>"),
        (FASTER, "см &lt;с&gt;<sup>−2</sup>"),
        (Measured(Number("45"), UnitText((("°", 1),), tight=True)), "45°"),
        (Equation(Symbol("h"), Measured(Number("0,5"), UnitText((("м", 1),)))), "<i>h</i>\xa0=\xa00,5\xa0м"),
        (SymbolProperty("modulus", Symbol("omega")), "|<i>ω</i>|"),
        (SymbolProperty("angle", Symbol("v")), "∠(<i>v</i>, <i>x</i>)"),
        (FormulaList((Symbol("a"), Symbol("b"))), "<i>a</i>, <i>b</i>"),
        (SymbolProperty("sense", Symbol("omega")), "sgn\xa0<i>ω</i>"),
    ],
)
def test_markup(formula: object, markup: str) -> None:
    assert to_html(formula) == markup


@pytest.mark.parametrize("name", family_names())
def test_every_quantity_is_sound_and_reads_like_plain_text(name: str) -> None:
    language = load_language("ru")
    for form in load_family(name).forms.values():
        for asked in form.askable:
            formula = language.quantity(parse_quantity(asked, form.sample), form.symbols)
            text = "".join(ET.fromstring(f"<p>{to_html(formula)}</p>").itertext())
            bare = str.maketrans("", "", "_^ \xa0\u2009")
            assert sorted(text.translate(bare)) == sorted(to_plain(formula).translate(bare))
