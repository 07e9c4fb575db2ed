"""Formulas that are set by the glyph table: the same glyphs at the same places as the engine sets them."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET

import pytest

from variantgen.outputs.typst.markup import TypstMarkup, heading, markup
from variantgen.outputs.typst.set_formulas import set_formulas, set_longer
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.wording.formula import (
    Equation,
    Formula,
    Function,
    Index,
    Measured,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    SymbolProperty,
    UnitText,
    Vector,
)
from variantgen.wording.formula.tree import ANGLE

SPEED, ANGULAR = UnitText((("m/s", 1),)), UnitText((("рад/с", 2),))
FORMULAS: list[Formula] = [
    Symbol("OABC"),
    Symbol("h"),
    Symbol("phi"),
    Symbol("O1A"),
    Symbol("omega", (Index("O1A"),)),
    Symbol("v", (Index("отн", upright=True), Index("C"))),
    Symbol("a", (Index("A"),), (Index("n"),)),
    Symbol("a", (Index("BA"),), (Index("tau"),)),
    SPEED,
    ANGULAR,
    SymbolProperty("modulus", Symbol("v", (Index("B"),))),
    SymbolProperty("angle", Symbol("v", (Index("B"),))),
    SymbolProperty("sense", Symbol("omega")),
]
ACCELERATION = Symbol("a", (Index("A"),), part=(Index("n"),))
# Solutions break no formula: there products and sums are set too.
LONGER: list[Formula] = [
    Vector(Symbol("v")),
    Vector(Symbol("a")),
    Vector(Symbol("v", (Index("B"),))),
    Vector(ACCELERATION),
    Symbol(ANGLE + "BOA"),
    Power(Symbol("omega", (Index("OA"),)), 2),
    Power(ACCELERATION, 2),
    Power(Number("48"), 2),
    Number("28.28"),
    Measured(Number("28.28"), SPEED),
    Measured(Number("45"), UnitText((("°", 1),), tight=True)),
    Product((Number("2"), Symbol("omega"))),
    Product((Symbol("BC"), Function("sin", Symbol("phi")))),
    Product((Number("40"), Function("sin", Measured(Number("45"), UnitText((("°", 1),), tight=True))))),
    Product((Power(Symbol("omega", (Index("BC"),)), 2), Symbol("BC"))),
    Product((Symbol("OA"), Function("tg", Symbol(ANGLE + "BOA")))),
    Sum(((-1, Symbol("OC")), (1, Product((Number("3"), Number("−2")))))),
    Product((Number("2"), Sum(((1, Symbol("OC")), (-1, Number("85")))))),
    Sum(((1, Vector(ACCELERATION)), (1, Vector(Symbol("a", (Index("A/B"),), part=(Index("t"),)))))),
    Product((Number("2.5"), Measured(Number("45"), UnitText((("°", 1),), tight=True)))),
]
MARKUP = [
    *map(markup, FORMULAS),
    *map(markup, LONGER),
    heading(Symbol("v", (Index("B"),)), SPEED),
    heading(Symbol("epsilon"), ANGULAR),
]
PAGES = """#import "common.typ": *
#show: document-style.with("ru")
#set page(width: 200pt, height: 60pt, margin: 9pt)
#for made in (equation, formula) {
  for markup in json(inputs.data) { page(align(center, box(made(markup)) + [.])) }
}
"""
NUMBER = r"-?[\d.]+(?:e-?\d+)?"
SVG, LINK = "{http://www.w3.org/2000/svg}", "{http://www.w3.org/1999/xlink}href"
Glyph = tuple[str, complex]


def glyphs(node: ET.Element, shift: complex = 0j) -> list[Glyph]:
    """Names and places of the glyphs of a page of the engine; outlines have the size of their letters."""
    numbers = [float(number) for number in re.findall(NUMBER, node.attrib.get("transform", ""))]
    if numbers:
        right, down, *_ = [*numbers[4 * (len(numbers) == 6) :], 0.0]
        shift += complex(right, down)
    here = [(node.attrib[LINK], shift + float(node.attrib.get("x", 0)))] if node.tag == f"{SVG}use" else []
    return [*here, *(glyph for child in node for glyph in glyphs(child, shift))]


@pytest.fixture(scope="module")
def pages() -> list[list[Glyph]]:
    import typst

    known = {"data": MARKUP, "set-formulas": {str(found): set_longer(found) for found in MARKUP}}
    names = {name: f"{name}.json" for name in known}
    files = {**known, "inputs": {"form": "svg", **names}}
    with typesetter() as engine:
        for name, found in files.items():
            (engine.root / f"{name}.json").write_text(json.dumps(found), "utf-8")
        source = engine.root / "pages.typ"
        source.write_text(PAGES, "utf-8")
        made = typst.compile(
            source, root=engine.root, format="svg", ignore_system_fonts=True, sys_inputs={"inputs": "inputs.json"}
        )
    assert isinstance(made, list)
    found = []
    for page in made:
        root = ET.fromstring(page)
        outlines = {f"#{symbol.attrib['id']}": symbol[0].attrib["d"] for symbol in root.iter(f"{SVG}symbol")}
        found.append([(outlines[name], at) for name, at in glyphs(root) if outlines.get(name)])  # no spaces
    return found


@pytest.mark.parametrize("number", range(len(MARKUP)), ids=lambda i: MARKUP[i].plain)
def test_the_same_glyphs_stand_at_the_same_places(pages: list[list[Glyph]], number: int) -> None:
    by_engine, by_table = pages[number], pages[number + len(MARKUP)]
    assert len(by_engine) == len(by_table) > 1
    left = list(by_table)
    for outline, at in by_engine:
        same = [glyph for glyph in left if glyph[0] == outline and abs(glyph[1] - at) < 0.1]
        assert same, (number, outline[:40], at)
        left.remove(same[0])


@pytest.mark.parametrize(
    "formula",
    [
        Equation(Symbol("phi"), Measured(Number("30"), UnitText((("°", 1),), tight=True))),  # may be broken
        Symbol(f"{ANGLE}ABC"),  # the sign of the angle is not in the table
        UnitText((("µΩ", 1),)),  # nor are these letters
    ],
)
def test_others_are_left_to_the_engine(formula: Formula) -> None:
    assert set_formulas([markup(formula)]) == {}


def test_markup_is_found_everywhere() -> None:
    data = {"a": [markup(Symbol("A")), ("b", {"c": markup(Symbol("B"))})], "d": "C"}
    assert set(set_formulas(data)) == {"A", "B"}
    assert all(isinstance(found, TypstMarkup) for found in MARKUP)
