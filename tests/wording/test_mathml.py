"""Formulas as MathML: sound, of MathML Core, and saying what plain text says."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from variantgen.families.quantities import parse_quantity
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.wording.formula import (
    Absolute,
    Cross,
    Dotted,
    Equation,
    Fraction,
    Function,
    Graph,
    Index,
    Measured,
    Number,
    Parenthesised,
    PointCoordinates,
    Power,
    Product,
    Root,
    Sum,
    Surd,
    Symbol,
    UnitText,
    Vector,
    to_plain,
)  # fmt: skip
from variantgen.wording.language import load_language
from variantgen.wording.mathml import NAMESPACE, to_mathml

V, A = Symbol("v", (Index("B"),)), Symbol("a", (Index("B"),), (Index("n"),))
# https://www.w3.org/TR/mathml-core/
CORE = {
    "math", "mi", "mn", "mo", "mtext", "mspace", "mrow", "mfrac", "msqrt", "msub", "msup", "msubsup", "mover",
    "munderover", "mpadded",
}  # fmt: skip
CHILDREN = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "mover": 2, "munderover": 3}
FORMULAS = [
    (V, "<msub><mi>v</mi><mi>B</mi></msub>"),
    (Symbol("O1"), "<mrow><msub><mi>O</mi><mn>1</mn></msub></mrow>"),
    (Power(V, 2), "<msubsup><mi>v</mi><mi>B</mi><mn>2</mn></msubsup>"),
    (A, "<msubsup><mi>a</mi><mi>B</mi><mi>n</mi></msubsup>"),
    (
        Vector(V),
        '<msub><mover accent="true"><mi>v</mi><mo stretchy="false" mathsize="65%">→</mo></mover><mi>B</mi></msub>',
    ),
    (
        Vector(A),
        '<msubsup><mpadded height="0.5em"><mover accent="true"><mi>a</mi><mo stretchy="false" mathsize="65%">→</mo>'
        "</mover></mpadded><mi>B</mi><mi>n</mi></msubsup>",
    ),
    (Symbol("a", (), (Index("prime"),)), "<mrow><mi>a</mi><mo>′</mo></mrow>"),
    (
        Parenthesised(Sum(((1, V), (-1, V)))),
        '<mrow><mo stretchy="false">(</mo><msub><mi>v</mi><mi>B</mi></msub><mo form="infix">−</mo>'
        '<msub><mi>v</mi><mi>B</mi></msub><mo stretchy="false">)</mo></mrow>',
    ),
    (Parenthesised(Fraction(V, V)), None),
    (Dotted(Symbol("phi"), 2), '<mover accent="true"><mi>φ</mi><mo stretchy="false">¨</mo></mover>'),
    (Number("\N{MINUS SIGN}0,5"), '<mo form="prefix">−</mo><mn>0,5</mn>'),
    (Measured(Number("45"), UnitText((("°", 1),), tight=True)), "<mn>45</mn><mtext>°</mtext>"),
    (
        Measured(Number("3"), UnitText((("см/с", 2),))),
        '<mn>3</mn><mspace width="0.167em"/><msup><mtext>см/с</mtext><mn>2</mn></msup>',
    ),
    (Surd(40, 3, 3), "<mfrac><mrow><mn>40</mn><msqrt><mn>3</mn></msqrt></mrow><mn>3</mn></mfrac>"),
    (Root(Sum(((1, V), (1, V)))), None),
    (Fraction(Product((Number("2"), V)), Symbol("OA")), None),
    (Equation(V, Sum(((-1, V), (1, A), (-1, Power(A, 2))))), None),
    (Function("cos", Symbol("phi")), None),
    (Power(Function("sin", Symbol("phi")), 2), None),
    (Absolute(Sum(((1, V), (-1, V)))), None),
    (Cross(Vector(Symbol("omega")), Vector(Symbol("AB"))), None),
    (PointCoordinates(Symbol("A"), Number("3"), Number("4")), None),
    (Graph(Symbol("O"), ((Number("1"), Symbol("A")),)), None),
]


def checked(formula: object) -> ET.Element:
    root = ET.fromstring(to_mathml(formula))
    for element in root.iter():
        space, name = element.tag[1:].split("}")
        assert space == NAMESPACE
        assert name in CORE
        if name in CHILDREN:
            assert len(element) == CHILDREN[name], ET.tostring(element, "unicode")
        if name in {"mi", "mn", "mo", "mtext"}:
            assert (element.text or "").strip()
            assert len(element) == 0
        else:
            assert not (element.text or "").strip()
    return root


@pytest.mark.parametrize(("formula", "inner"), FORMULAS)
def test_markup(formula: object, inner: str | None) -> None:
    checked(formula)
    if inner is not None:
        assert to_mathml(formula) == f'<math xmlns="{NAMESPACE}">{inner}</math>'


def test_parentheses_grow_with_fractions_and_roots_only() -> None:
    for inner, grows in ((V, False), (Power(V, 2), False), (Fraction(V, V), True), (Root(V), True)):
        for formula in (Parenthesised(inner), Absolute(inner)):
            signs = [sign for sign in checked(formula).iter() if sign.text in {"(", ")", "|"}]
            assert len(signs) == 2
            assert all((sign.get("stretchy", "true") == "true") is grows for sign in signs)


def test_words_are_escaped() -> None:
    assert "<mtext>&lt;b&gt;&amp;</mtext>" in to_mathml(UnitText((("<b>&", 1),)))


@pytest.mark.parametrize("name", family_names())
def test_every_quantity_reads_like_plain_text(name: str) -> None:
    language = load_language("ru")
    for form in load_family(name).forms.values():
        for asked in form.askable:
            formula = language.quantity(parse_quantity(asked, form.sample), form.symbols)
            bare = str.maketrans("", "", "_^ \xa0\u2009")
            text = "".join(checked(formula).itertext())
            assert sorted(text.translate(bare)) == sorted(to_plain(formula).translate(bare))
