"""Pieces of rows, with fractions, roots and tall parentheses: glyphs and bars stand where the engine puts them."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET

import pytest

from tests.outputs.test_set_formulas import NUMBER, SVG, Glyph, glyphs
from variantgen.outputs.typst.markup import Piece, piece
from variantgen.outputs.typst.set_formulas import SetFormula, set_formulas, set_piece, set_whole_piece
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.wording.formula import (
    Absolute,
    Dotted,
    Formula,
    Fraction,
    Function,
    Index,
    Measured,
    Number,
    Parenthesised,
    Power,
    Product,
    Root,
    Sum,
    Surd,
    Symbol,
    UnitText,
    Vector,
)
from variantgen.wording.formula.tree import ANGLE

A, B = Symbol("a", (Index("A"),), (Index("n"),)), Symbol("AB")
HALF = Fraction(Number("1"), Number("2"))
SPEED = Symbol("v", (Index("B"),))
SQUARES = Sum(((1, Power(Number("61,87"), 2)), (1, Power(Number("8,452"), 2))))
DEGREES = Measured(Number("43,88"), UnitText((("°", 1),), tight=True))
COSINES = Fraction(Sum(((1, Power(B, 2)), (1, Power(Symbol("OC"), 2)))), Product((Number("2"), B)))
PIECES: list[Formula] = [
    HALF,
    Fraction(SPEED, B),
    Fraction(Product((SPEED, Symbol("AP"))), Product((Symbol("BP"), Number("3")))),
    Fraction(Power(A, 2), Power(B, 2)),
    Fraction(Product((B, Function("sin", Symbol(ANGLE + "ABP")))), Function("sin", DEGREES)),
    Root(Number("2")),
    Root(SQUARES),
    Root(Sum(((1, Power(A, 2)), (-1, Product((Number("4"), Power(SPEED, 2))))))),
    Root(Fraction(SPEED, B)),
    Product((Number("2"), Root(Number("3")))),
    Fraction(Root(SQUARES), Number("7")),
    Function("arccos", COSINES),
    Function("arcsin", Fraction(Product((Number("62"), Function("sin", DEGREES))), Number("90"))),
    Function("cos", Sum(((1, Symbol("phi")), (1, Symbol("psi"))))),
    Power(Function("sin", Symbol("phi")), 2),
    Power(Parenthesised(Sum(((1, SPEED), (1, Number("3"))))), 2),
    Power(Parenthesised(Fraction(SPEED, B)), 2),
    Power(Vector(SPEED), 2),
    Absolute(Sum(((1, SPEED), (-1, Number("3"))))),
    Absolute(Fraction(SPEED, B)),
    Parenthesised(Fraction(SPEED, B)),
    Product((Parenthesised(HALF), SPEED)),
    Surd(40, 3, 3),
    Surd(-1, 1, 2),
    Surd(5, 2, 1),
    Sum(((-1, Fraction(SPEED, B)), (1, Number("2")))),
]
PAGES = """#import "common.typ": document-style, equation, inputs, math-style, set-lines
#show: document-style.with("ru")
#set page(width: 300pt, height: 90pt, margin: 30pt)
#set text(size: 10.5pt)
#let (markup, lines) = json(inputs.data)
#for m in markup { page({ equation(m); [.] }) }
#for line in set-lines(lines) { page({ { set text(..math-style); line }; [.] }) }
"""


def bars(node: ET.Element, shift: complex = 0j) -> list[complex]:
    """Where the bars of fractions and roots begin on a page of the engine."""
    numbers = [float(number) for number in re.findall(NUMBER, node.attrib.get("transform", ""))]
    if numbers:
        right, down, *_ = [*numbers[4 * (len(numbers) == 6) :], 0.0]
        shift += complex(right, down)
    here = [shift] if node.tag == f"{SVG}path" and node.get("stroke", "none") != "none" else []
    return [*here, *(bar for child in node for bar in bars(child, shift))]


def fragments(made: Piece) -> SetFormula:
    found = set_whole_piece(made)
    assert found, "it is set here"
    return found


@pytest.fixture(scope="module")
def pages() -> list[ET.Element]:
    import typst

    made = [piece(formula) for formula in PIECES]
    lines = [(*found.fragments, found.rest) for found in map(fragments, made)]
    files = {
        "data": {"markup": [str(found) for found in made], "lines": lines},
        "inputs": {"form": "svg", "data": "data.json"},
    }
    with typesetter() as engine:
        for name, found in files.items():
            (engine.root / f"{name}.json").write_text(json.dumps(found), "utf-8")
        source = engine.root / "pages.typ"
        source.write_text(PAGES, "utf-8")
        told = {"inputs": "inputs.json"}
        svg = typst.compile(source, root=engine.root, format="svg", ignore_system_fonts=True, sys_inputs=told)
    assert isinstance(svg, list)
    return [ET.fromstring(page) for page in svg]


def letters(page: ET.Element) -> list[Glyph]:
    """The outlines of letters with their places, but for signs that grow, which are drawn as curves in one way."""
    outlines = {f"#{symbol.attrib['id']}": symbol[0].attrib["d"] for symbol in page.iter(f"{SVG}symbol")}
    return [(outlines[name], at) for name, at in glyphs(page) if outlines.get(name)]


@pytest.mark.parametrize("number", range(len(PIECES)), ids=lambda i: piece(PIECES[i]).plain)
def test_letters_and_bars_stand_where_the_engine_puts_them(pages: list[ET.Element], number: int) -> None:
    made = fragments(piece(PIECES[number])).fragments
    signs = sum(isinstance(part, tuple) and len(part) == 2 and isinstance(part[1], str) for part in made)
    by_engine, by_table = pages[number], pages[number + len(PIECES)]
    ours, theirs = letters(by_table), letters(by_engine)
    assert len(theirs) - len(ours) == signs
    # The line may lie elsewhere on the page, as the engine takes the height of another.
    shift = next(at for outline, at in theirs if outline == ours[0][0]) - ours[0][1]
    assert abs(shift.real) < 0.1
    for outline, at in ours:
        same = [glyph for glyph in theirs if glyph[0] == outline and abs(glyph[1] - at - shift) < 0.12]
        assert same, (outline[:40], at)
        theirs.remove(same[0])
    assert len(bars(by_table)) == len(bars(by_engine))
    for one, other in zip(sorted(bars(by_table), key=abs), sorted(bars(by_engine), key=abs), strict=True):
        assert abs(one + shift - other) < 0.12, "a bar"


def test_what_has_no_letters_is_left_to_the_engine() -> None:
    tall = Fraction(Root(Fraction(SPEED, B)), Root(Fraction(SPEED, B)))
    for formula in (
        Dotted(Symbol("x"), 1),
        Fraction(HALF, B),  # smaller fractions
        Parenthesised(Fraction(Root(tall), tall)),  # higher than the largest parenthesis
    ):
        assert set_piece(piece(formula)) is None


def test_text_has_no_fractions_of_full_size() -> None:
    assert set_formulas([piece(HALF)]) == {}
    assert str(piece(SPEED)) == "v_(B)"
    assert str(piece(HALF)) == 'display(frac("1", "2"))'
