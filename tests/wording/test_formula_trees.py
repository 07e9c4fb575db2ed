"""Formulas of any structure: plain text has the value of the tree, and every markup is taken by those who read it."""

from __future__ import annotations

import html5lib
import pytest
from hypothesis import Phase, assume, given, settings
from hypothesis import strategies as st
from matplotlib import rc_context
from matplotlib.mathtext import MathTextParser

from tests.wording import exact_reader
from tests.wording.exact_reader import PRIME, AmbiguousError, read
from tests.wording.formulas import deg, num, sym
from tests.wording.latex_reader import in_line
from variantgen.outputs.single.motion_plot import STYLE
from variantgen.outputs.typst.markup import markup
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.wording.formula import (
    Absolute,
    Cross,
    Dotted,
    Equation,
    Formula,
    FormulaList,
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
    Relation,
    Root,
    Sum,
    Surd,
    Symbol,
    SymbolProperty,
    UnitText,
    Vector,
    to_plain,
)
from variantgen.wording.formula.tree import GREEK, SIGNS
from variantgen.wording.html import to_html
from variantgen.wording.latex import to_latex
from variantgen.wording.mathtext import to_mathtext

# Symbols with the text that they have in plain text, and a value.
SYMBOLS = {
    sym("a"): ("a", 1000003),
    sym("omega", "OA"): ("ω_OA", 2000003),
    sym("OA"): ("OA", 3000017),
    sym("a", "B", "n"): ("a^n_B", 4000037),
}
NAMES = dict(SYMBOLS.values())
NUMBERS = ["0", "2", "3", "17", "0.5", "20.3", "-1", "-4", "-0.25"]
DIGITS = st.sampled_from(NUMBERS)
LEAVES: st.SearchStrategy[Formula] = st.one_of(
    st.sampled_from(list(SYMBOLS)),
    DIGITS.map(num),
    DIGITS.map(deg),
    st.builds(Surd, st.integers(-5, 5).filter(bool), st.integers(1, 3), st.sampled_from([1, 2, 3])),
)


def several(inner: st.SearchStrategy[Formula]) -> st.SearchStrategy[tuple[Formula, ...]]:
    """One to four formulas."""
    return st.lists(inner, min_size=1, max_size=4).map(tuple)


def sums(inner: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    """Sums with any signs."""
    return st.lists(st.tuples(st.sampled_from([1, -1]), inner), min_size=1, max_size=4).map(lambda t: Sum(tuple(t)))


def arithmetic(inner: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    """One more layer of arithmetic."""
    return st.one_of(
        sums(inner),
        several(inner).map(Product),
        st.builds(Fraction, inner, inner),
        st.builds(Power, inner, st.integers(-2, 12)),
        st.builds(Root, inner),
        st.builds(Function, st.sampled_from(["cos", "sin", "arctg"]), inner),
        st.builds(Parenthesised, inner),
        st.builds(Absolute, inner),
    )


def value(formula: Formula) -> int:
    """The value of a tree by the arithmetic of the reader."""
    match formula:
        case Symbol():
            return SYMBOLS[formula][1]
        case Number(text):
            size = exact_reader.decimal(text.lstrip("−"))
            return -size if text.startswith("−") else size
        case Measured(number):
            return exact_reader.degrees(value(number))
        case Surd(p, q, n):
            return exact_reader.quotient(p * (exact_reader.root(n) if n > 1 else 1), q)
        case Sum(terms):
            return sum(sign * value(term) for sign, term in terms)
        case Product(factors):
            found = 1
            for factor in factors:
                found = found * value(factor) % PRIME
            return found
        case Fraction(above, below):
            return exact_reader.quotient(value(above), value(below))
        case Power(base, exponent):
            return exact_reader.power(value(base), exponent)
        case Root(inner):
            return exact_reader.root(value(inner))
        case Function(name, inner):
            return exact_reader.function(name, value(inner))
        case Parenthesised(inner):
            return value(inner)
        case Absolute(inner):
            return exact_reader.modulus(value(inner))
    raise AssertionError(formula)


# Small trees are quickly read: some more of them than usual.
MANY = settings(max_examples=8 * settings.default.max_examples)


@MANY
@given(st.recursive(LEAVES, arithmetic, max_leaves=10))
def test_what_is_printed_has_the_value_of_the_tree(formula: Formula) -> None:
    try:
        wanted = value(formula) % PRIME
    except ZeroDivisionError:
        assume(False)
    assert read(to_plain(formula), NAMES) == wanted
    assert read(in_line(to_latex(formula)), NAMES) == wanted


@pytest.mark.parametrize(
    "text", ["a / a · a", "a / a / a", "√a^2", "cos\xa0a^2", "a · −2", "a + −2", "cos a", "2a", "(a"]
)
def test_the_reader_refuses_what_is_read_in_two_ways(text: str) -> None:
    with pytest.raises(AmbiguousError):
        read(text, {"a": 2})


def test_the_reader_of_latex_keeps_what_bars_and_roots_hold_together() -> None:
    a = sym("a")
    assert in_line(r"\frac{a - 1}{\sqrt{a \cdot \frac{2}{3}}}") == "((a − 1) / ((√(a · ((2) / (3))))))"
    assert in_line(to_latex(Power(Function("cos", Sum(((1, a), (1, a)))), 2))) == "cos^2(a + a)"
    assert in_line(r"\mathop{\text{cos}}\nolimits^{2} a \cdot 2\sqrt{3}") == "cos^2\xa0a · 2\xa0(√(3))"


def test_the_reader_calculates() -> None:
    names = {"a": 3, "ω_OA": 5}
    assert read("2\xa0a · (−4) + 12 / (a · 2)", names) == (2 * 3 * -4 + 2) % PRIME
    assert read("−a^2 − (−0.5) · 4", names) == (-9 + 2) % PRIME
    assert read("a · cos^2\xa0ω_OA", names) == 3 * exact_reader.function("cos", 5) ** 2 % PRIME
    assert read("4√3/2", names) == 2 * exact_reader.root(3) % PRIME
    assert read("|a − 5| / √(a)", names) == exact_reader.quotient(exact_reader.modulus(-2), exact_reader.root(3))


# Anything goes: words with all the marks of the markups in them, kinds within kinds that say nothing together.
WORDS = st.text("abcDEабв019 .,-−_^$&#%{}[]()<>\\\"'`~@*/+=|;:!?°", min_size=1, max_size=6)
LETTERS = st.sampled_from(["a", "v", "OA", "O1", "O2B", "x", *sorted(GREEK.keys() - {"prime"})])
INDICES = st.lists(st.one_of(LETTERS.map(Index), st.builds(Index, WORDS, st.just(True))), min_size=0, max_size=2).map(
    tuple
)
ANY_SYMBOL = st.one_of(
    LETTERS.map(Symbol), st.builds(Symbol, st.sampled_from(["v", "a", "omega"]), INDICES, INDICES, INDICES)
)
PARTS = st.lists(st.tuples(WORDS, st.integers(-2, 2)), min_size=1, max_size=2).map(tuple)
UNITS = st.builds(UnitText, PARTS, st.booleans())
ANY_LEAF: st.SearchStrategy[Formula] = st.one_of(
    ANY_SYMBOL,
    st.builds(Number, WORDS),
    UNITS,
    st.builds(Measured, st.builds(Number, WORDS), st.one_of(UNITS, st.just(UnitText(())))),
    st.builds(SymbolProperty, st.sampled_from(["modulus", "angle", "sense"]), ANY_SYMBOL),
    st.builds(Vector, ANY_SYMBOL),
    st.builds(Dotted, ANY_SYMBOL, st.sampled_from([1, 2])),
    LEAVES,
)


def chains(inner: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    """Two or three sides with any signs."""
    two = st.tuples(st.tuples(inner, inner), st.tuples(st.sampled_from(SIGNS)))
    three = st.tuples(st.tuples(inner, inner, inner), st.tuples(st.sampled_from(SIGNS), st.sampled_from(SIGNS)))
    return st.one_of(two, three).map(lambda parts: Relation(*parts))


def layer(inner: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    """One more layer of any kind."""
    legs = st.lists(st.tuples(inner, ANY_SYMBOL), max_size=2).map(tuple)
    return st.one_of(
        arithmetic(inner),
        st.builds(Function, WORDS, inner),
        st.builds(Cross, inner, inner),
        st.builds(PointCoordinates, ANY_SYMBOL, inner, inner),
        st.builds(Equation, inner, inner),
        several(inner).map(FormulaList),
        chains(inner),
        st.builds(Graph, ANY_SYMBOL, legs),
    )


ANYTHING = st.recursive(ANY_LEAF, layer, max_leaves=8)


# Many formulas at a time, since each document costs a start of the engine; so without a search for a smaller example.
@settings(max_examples=20, phases=[Phase.generate])
@given(st.lists(ANYTHING, min_size=25, max_size=25))
def test_the_engine_takes_anything(formulas: list[Formula]) -> None:
    with typesetter() as engine:
        source = '#import "common.typ": formula, inputs\n#for markup in json(inputs.data) { formula(markup) }\n'
        (engine.root / "any.typ").write_text(source, "utf-8")
        assert engine.compile("any.typ", [markup(formula) for formula in formulas])


@given(ANYTHING)
def test_matplotlib_takes_anything(formula: Formula) -> None:
    markup = to_mathtext(formula)
    assert " " not in markup
    with rc_context(STYLE):
        assert MathTextParser("path").parse(markup).width > 0


@given(ANYTHING)
def test_the_strict_reader_of_html_takes_anything(formula: Formula) -> None:
    page = f"<!DOCTYPE html><title>x</title><p>{to_html(formula)}</p>"
    tree = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(page)
    assert [found.tag for found in tree.find("body")] == ["p"]


@given(ANYTHING)
def test_brackets_of_latex_and_typst_are_closed(formula: Formula) -> None:
    """Outside the words, what opens is closed, in its order."""
    latex = to_latex(formula)
    for escape in (r"\{", r"\}", r"\\"):
        latex = latex.replace(escape, "")
    depth = 0
    for letter in latex:
        depth += (letter == "{") - (letter == "}")
        assert depth >= 0
    assert depth == 0
    assert latex.count(r"\left") == latex.count(r"\right")
