"""Texts of exam files with simple formulas: what is read, what is refused, and that text stays text."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from variantgen.errors import InputError
from variantgen.wording.formula import (
    Fraction,
    Index,
    Measured,
    Number,
    Power,
    Product,
    Relation,
    Root,
    Sum,
    Symbol,
    UnitText,
    to_plain,
    to_typst,
)
from variantgen.wording.inline import inline
from variantgen.wording.language import load_language
from variantgen.wording.latex import to_latex
from variantgen.wording.mathml import to_mathml

EN, RU = load_language("en"), load_language("ru")
V_B = Symbol("v", (Index("B"),))


@pytest.mark.parametrize(
    ("text", "runs"),
    [
        ("Give three digits.", ("Give three digits.",)),
        ("", ()),
        ("$v_B$", (V_B,)),
        ("Draw $v_B$, then $ v_{B} $.", ("Draw ", V_B, ", then ", V_B, ".")),
        (r"It costs 5\$ or \$.", ("It costs 5$ or $.",)),
        (r"\input{x} #read <b> & _ ^", (r"\input{x} #read <b> & _ ^",)),
    ],
)
def test_text_and_formulas(text: str, runs: tuple[object, ...]) -> None:
    assert inline(text, EN) == runs


@pytest.mark.parametrize(
    ("source", "formula"),
    [
        (r"\omega_{OA}", Symbol("omega", (Index("OA"),))),
        ("omega_OA", Symbol("omega", (Index("OA"),))),
        ("ω_OA", Symbol("omega", (Index("OA"),))),
        (r"\varepsilon_1", Symbol("epsilon", (Index("1"),))),
        ("O1A", Symbol("O1A")),
        ("v_{B x}", Symbol("v", (Index("B"), Index("x")))),
        ("a_B^n", Symbol("a", (Index("B"),), (Index("n"),))),
        (r"a_B^\tau", Symbol("a", (Index("B"),), (Index("tau"),))),
        ("v_max", Symbol("v", (Index("max", upright=True),))),
        ("v_отн", Symbol("v", (Index("отн", upright=True),))),
        ("x^2", Power(Symbol("x"), 2)),
        ("s^{-1}", Power(Symbol("s"), -1)),
        ("12", Number("12")),
        ("9,8", Number("9.8")),
        ("30°", Measured(Number("30"), UnitText((("°", 1),), True))),
        ("9.8 m/s^2", Measured(Number("9.8"), UnitText((("m/s", 2),)))),
        (r"25\,cm/s", Measured(Number("25"), UnitText((("cm/s", 1),)))),
        ("3 m", Measured(Number("3"), UnitText((("m", 1),)))),
        ("3 mu", Product((Number("3"), Symbol("mu")))),
        ("v = 5", Relation((Symbol("v"), Number("5")), ("=",))),
        (r"v \approx 5 cm", Relation((Symbol("v"), Measured(Number("5"), UnitText((("cm", 1),)))), ("≈",))),
        ("-a + b", Sum(((-1, Symbol("a")), (1, Symbol("b"))))),
        (r"2 \cdot R", Product((Number("2"), Symbol("R")))),
        ("a/b", Fraction(Symbol("a"), Symbol("b"))),
        (r"\sqrt{3}/2", Fraction(Root(Number("3")), Number("2"))),
    ],
)
def test_formulas(source: str, formula: object) -> None:
    assert inline(f"${source}$", EN) == (formula,)


def test_numbers_and_units_are_those_of_the_language() -> None:
    (formula,) = inline("$g = 9.81 м/с^2$", RU)
    assert not isinstance(formula, str)
    assert to_plain(formula) == "g = 9,81\N{NO-BREAK SPACE}м/с²"
    for unit in ("m/s^2", "м/с^2"):
        assert inline(f"$9,81 {unit}$", RU) == (Measured(Number("9,81"), UnitText((("м/с", 2),))),)
    assert inline("$45 deg$", RU) == (Measured(Number("45"), UnitText((("°", 1),), True)),)
    (formula,) = inline("$v_rel_C$", RU)
    assert formula == Symbol("v", (Index("отн", upright=True), Index("C")))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Take $g", "a dollar sign without the other one"),
        ("5 $ and $x$", "a dollar sign without the other one"),
        ("$$", "an empty formula"),
        ("$ $", "an empty formula"),
        (r"$\input{/etc/passwd}$", r"an unknown command \input"),
        (r"$\write18{x}$", r"an unknown command \write"),
        ('$#read("x")$', "a formula that cannot be read"),
        ("$speed$", "points in capitals"),
        ("$a +$", "ends too early"),
        ("$a = = b$", "a formula that cannot be read"),
        ("$(a$", "expected  )"),
        ("$v_{#x}$", "an index that cannot be read"),
        ("$v_$", "an index or a power that cannot be read"),
        ("$2^x$", "a power that is no whole number"),
        ("$3 kg$", "points in capitals, from  kg"),
        ("$" + "(" * 100 + "a" + ")" * 100 + "$", "a formula of more than 200 characters"),
        ("$" + "(" * 20 + "a" + ")" * 20 + "$", "too many parentheses"),
        ("$a < b$", "a formula that cannot be read"),
    ],
)
def test_what_cannot_be_read_is_refused(text: str, said: str) -> None:
    with pytest.raises(InputError) as error:
        inline(text, EN)
    assert said in str(error.value)


@given(st.text(alphabet=st.sampled_from(r"vaB1x_^{}()=+-·/\ ω,.23cms°$#[]&%<>\"'~")))
def test_any_text_is_read_or_refused(text: str) -> None:
    """Whatever is read can be written in every markup, and what is no formula is the text itself."""
    try:
        runs = inline(text, EN)
    except InputError as error:
        assert str(error)
        return
    if "$" not in text:
        assert runs == ((text,) if text else ())
    for run in runs:
        if not isinstance(run, str):
            assert all(write(run) for write in (to_plain, to_typst, to_latex, to_mathml))


@pytest.mark.parametrize("typed", ["9.8 м/с^2", "9,8 м/с²", "9.8 m/s^2"])
def test_a_unit_may_be_typed_as_the_language_writes_it_or_by_its_name_in_files(typed: str) -> None:
    assert inline(f"$g = {typed}$", RU) == (
        Relation((Symbol("g"), Measured(Number("9,8"), UnitText((("м/с", 2),)))), ("=",)),
    )
