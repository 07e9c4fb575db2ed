"""Letters of figures stand as the typesetting engine sets them: widths, ink, places."""

from __future__ import annotations

import json
import re
import timeit

import pytest
from msgspec.structs import replace

from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.figure.build import statement_figure
from variantgen.figure.letters import glyphs
from variantgen.figure.letters.glyphs import KERNING, TABLE
from variantgen.figure.letters.lettering import typeset
from variantgen.figure.placement.label_requests import label_size
from variantgen.outputs.typst.glyph_table import table
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.resources import languages
from variantgen.variants.draw import FamilySampler as Draws
from variantgen.variants.variant import solve_variants
from variantgen.wording.formula import (
    Equation,
    Formula,
    FormulaList,
    Index,
    Measured,
    Number,
    Symbol,
    SymbolProperty,
    UnitText,
    to_plain,
    to_typst,
)
from variantgen.wording.language import load_language

# What the figures of plans need besides the letters of the catalogue, and what is set by rules of its own.
FURTHER = [
    Symbol("a", (Index("BA"),), (Index("вр", True),)),  # a power with a descender is raised by itself
    Symbol("V", (Index("rel", True),), (Index("y"),)),
    Symbol("a", (Index("кор", True), Index("M"))),  # kerned
    Symbol("T", (Index("P"),)),
    Symbol("v", (Index("B/A"),)),
    Symbol("v", (Index("C′"),)),
    Symbol("a", (Index("C′/B"),), (), (Index("t"),)),
    Symbol("a", (Index("O1"),), (), (Index("n"),)),
    Symbol("alpha", (Index("OA"),)),
    Measured(Number("7,5"), UnitText((("об/мин", 1),))),
    Measured(Number("117.4"), UnitText((("s", -1),))),
    SymbolProperty("modulus", Symbol("omega", (Index("OA"),))),
    SymbolProperty("angle", Symbol("v", (Index("B"),))),
    SymbolProperty("sense", Symbol("f")),
    Symbol("a", (Index("BA"),), (Index("n"),)),
    Symbol("a", (Index("B"),), (Index("tau"),)),
    Symbol("v", (Index("O1A"),)),
    Symbol("f", (), (Index("n"),)),
    Symbol("pi"),
    Symbol("a", (), (Index("prime"),)),
    Symbol("d", (Index("пер", True),), (Index("prime"),)),
    FormulaList((Symbol("a"), Symbol("b"), Symbol("m", (Index("tr", True),)))),
    FormulaList((Symbol("a", (), (Index("prime"),)), Symbol("b", (), (Index("prime"),)))),
    Symbol("a", (Index("rel", True), Index("A")), (Index("tau"),)),
    Equation(Symbol("v", (Index("B"),)), Symbol("v", (Index("пер", True), Index("A")))),
    Measured(Number("2"), UnitText((("м/с", 1),))),
    Measured(Number("0,5"), UnitText((("cm/s", 2),))),
    Measured(Number("\N{MINUS SIGN}30"), UnitText((("°", 1),), tight=True)),
    Equation(Symbol("omega", (Index("AB"),)), Measured(Number("1.25"), UnitText((("rad/s", 1),)))),
]
HEAD = """#import "common.typ": document-style
#show: document-style.with("ru")
#show math.equation: set text(top-edge: "bounds", bottom-edge: "bounds")
#set text(size: 100pt)
"""


@pytest.fixture(scope="module")
def formulas() -> list[Formula]:
    """Every label of the catalogue's figures."""
    found: set[Formula] = set(FURTHER)
    for name in family_names():
        family = load_family(name)
        for form in family.forms.values():
            variants = Draws(replace(family, forms={form.name: form}), None).after([("letters", 0)], [0])
            asked = [parse_quantity(text, form.sample) for text in form.ask]
            motion = solve_variants(variants, 0)
            for language in languages():
                figure = statement_figure(variants[0], motion, 0, asked, load_language(language))
                found |= {label.formula for label in figure.labels}
    return sorted(found, key=to_plain)


def test_sizes_are_those_of_the_engine(formulas: list[Formula]) -> None:
    import typst

    sizes = ",\n".join(f"(measure(${f}$).width / 1pt, measure(${f}$).height / 1pt)" for f in map(to_typst, formulas))
    with typesetter() as engine:
        source = engine.root / "measure.typ"
        source.write_text(f"{HEAD}#context [#metadata(({sizes},)) <sizes>]\n", "utf-8")
        answer = typst.query(str(source), "<sizes>", field="value", root=str(engine.root), ignore_system_fonts=True)
    (measured,) = json.loads(answer) if isinstance(answer, str) else answer
    assert len(measured) == len(formulas) > 60
    for formula, (width, height) in zip(formulas, measured, strict=True):
        set_here = typeset(formula)
        assert set_here.width == pytest.approx(width / 100, abs=0.01), to_plain(formula)
        assert set_here.top - set_here.bottom == pytest.approx(height / 100, abs=0.01), to_plain(formula)


def test_glyphs_stand_where_the_engine_puts_them(formulas: list[Formula]) -> None:
    body = "#pagebreak(weak: true)\n".join(f"#place(top + left, dx: 9pt, dy: 9pt, ${to_typst(f)}$)\n" for f in formulas)
    with typesetter() as engine:
        (engine.root / "places.typ").write_text(f"{HEAD}#set page(width: 900pt, height: 300pt, margin: 0pt)\n{body}")
        pages = [page.decode() for page in engine.compile("places.typ", {}, "svg")]
    for formula, page in zip(formulas, pages, strict=True):
        found = []
        for x, y, group in re.findall(
            r'<g transform="matrix\(1 0 0 -1 (-?[\d.]+) (-?[\d.]+)\)">(.*?)</g>', page.split("<defs>")[0]
        ):
            found += [
                complex(float(x) + float(dx) - 9, -float(y)) / 100
                for dx in re.findall(r'<use [^>]*? x="([^"]*)"', group)
            ]
        here = [placed.at for placed in typeset(formula).glyphs]
        assert len(found) == len(here), to_plain(formula)
        # The engine's order of scripts is another one, and its baseline lies elsewhere.
        base = min(found, key=lambda z: z.real)
        places = sorted((z - base for z in found), key=lambda z: (round(z.real, 2), z.imag))
        for one, other in zip(places, sorted(here, key=lambda z: (round(z.real, 2), z.imag)), strict=True):
            assert abs(one - other) < 0.015, to_plain(formula)


def extent(path: str) -> list[float]:
    """Left, right, bottom and top of the points of an outline, in thousandths."""
    places = [1000 * point for _, points in glyphs.outline(path) for point in points]
    x, y = [z.real for z in places], [z.imag for z in places]
    return [min(x), max(x), min(y), max(y)]


def test_the_table_is_that_of_the_engine() -> None:
    committed, now = json.loads(TABLE.read_text("utf-8")), table()
    assert committed.keys() == now.keys()
    assert committed[KERNING] == now[KERNING]
    for name in committed.keys() - {KERNING}:
        *numbers, path = committed[name]
        *others, drawn = now[name]
        # Another version of the engine may begin an outline elsewhere; it is the same letter at the same size.
        assert numbers == pytest.approx(others, abs=2), name
        assert extent(path) == pytest.approx(extent(drawn), abs=25), name


def test_a_letter_that_is_not_in_the_table_takes_room() -> None:
    assert typeset(Number("\N{CJK UNIFIED IDEOGRAPH-4E2D}")).width > 0.2


def test_the_table_is_small_and_quickly_read() -> None:
    assert TABLE.stat().st_size < 150_000
    shortest = min(timeit.repeat(glyphs._rows.__wrapped__, number=1, repeat=5))
    assert shortest < 0.02  # half a millisecond, with room for a busy machine


def test_labels_count_with_ink() -> None:
    low, high = label_size(Symbol("v")), label_size(Symbol("B"))
    assert low[1] < 0.75 * high[1]
