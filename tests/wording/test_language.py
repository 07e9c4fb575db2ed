"""Numbers, units and symbols as each language prints them."""

from __future__ import annotations

from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from variantgen.families.parameters.units import UNITS
from variantgen.families.quantities import Quantity
from variantgen.outputs.documents.sheet_data import points_text
from variantgen.resources import languages
from variantgen.wording.formula import Equation, Measured, Symbol, to_plain, to_typst
from variantgen.wording.language import load_language, round_text
from variantgen.wording.plurals import plural_category

EN, RU = load_language("en"), load_language("ru")


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"), (1234.567, "1235"), (0.0123456, "0.01235"), (-2.5, "-2.500"), (99.996, "100.0"),
        (1e-7, "0.0000001000"), (123456.0, "123500"), (0.5, "0.5000"),
    ],
)  # fmt: skip
def test_four_significant_digits_without_exponents(value: float, text: str) -> None:
    assert round_text(value, 4) == text


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (15.0, "15"), (136.0, "136"), (-0.5, "\N{MINUS SIGN}0,5"), (2.75, "2,75"), (0.0, "0"), (-0.0, "0"),
        (14.999999999999998, "15"), (136.04, "136,0"), (15.001, "15,00"), (1234.5, "1235"), (20000.0, "20000"),
    ],
)  # fmt: skip
def test_a_short_decimal_is_an_answer_without_zeros_after_it(value: float, text: str) -> None:
    assert RU.answer(Quantity("v", "A"), value).text == text


def test_a_step_and_its_answer_end_alike() -> None:
    """2.50049995 is recorded as 2.5005; the step before the answer knows what the answer will be."""
    assert round_text(2.50049995, 4) == EN.answer(Quantity("a", "A"), 2.50049995).text == "2.501"
    assert round_text(2.5004999, 4) == EN.answer(Quantity("a", "A"), 2.5004999).text == "2.500"


@given(st.floats(1e-6, 1e6))
def test_a_printed_answer_is_within_its_rounding(value: float) -> None:
    assert abs(float(round_text(value, 4)) / value - 1) <= 0.5e-3
    assert "e" not in round_text(value, 4)


def test_decimal_mark_and_minus() -> None:
    assert RU.decimal(Decimal("-0.250")).text == "\N{MINUS SIGN}0,25"
    assert EN.decimal(Decimal("1E+2")).text == "100"


def test_a_number_and_its_unit_are_not_separated() -> None:
    value = Measured(RU.decimal(Decimal("3.5")), RU.unit(UNITS["rad/s^2"]))
    assert to_plain(Equation(Symbol("omega"), value)) == "ω = 3,5\N{NO-BREAK SPACE}рад/с²"
    assert to_plain(Measured(EN.decimal(Decimal(60)), EN.unit(UNITS["deg"]))) == "60°"


def test_every_language_has_the_same_words_and_all_units() -> None:
    shape = {
        name: {table: {key.partition(".")[0] for key in words} for table, words in load_language(name).tables.items()}
        for name in languages()
    }
    for tables in shape.values():
        del tables["plural_rules"]
        assert tables == shape["en"]
    assert shape["en"]["units"] == set(UNITS)


@pytest.mark.parametrize("name", languages())
def test_what_is_counted_has_all_plural_categories(name: str) -> None:
    tables = load_language(name).tables
    needed = set(tables["plural_rules"]) | {plural_category(tables["plural_rules"], n) for n in range(1000)}
    for what in {key.partition(".")[0] for key in tables["plurals"]}:
        assert {key.partition(".")[2] for key in tables["plurals"] if key.startswith(what + ".")} == needed


@pytest.mark.parametrize(
    ("points", "english", "russian"),
    [
        (0, "0 points", "0 баллов"), (1, "1 point", "1 балл"), (2, "2 points", "2 балла"), (4, "4 points", "4 балла"),
        (5, "5 points", "5 баллов"), (10, "10 points", "10 баллов"), (11, "11 points", "11 баллов"),
        (12, "12 points", "12 баллов"), (14, "14 points", "14 баллов"), (20, "20 points", "20 баллов"),
        (21, "21 points", "21 балл"), (22, "22 points", "22 балла"), (25, "25 points", "25 баллов"),
        (101, "101 points", "101 балл"), (111, "111 points", "111 баллов"), (1000, "1000 points", "1000 баллов"),
    ],
)  # fmt: skip
def test_plurals(points: int, english: str, russian: str) -> None:
    assert EN.counted(points, "points") == english.replace(" ", "\N{NO-BREAK SPACE}")
    assert RU.counted(points, "points") == russian.replace(" ", "\N{NO-BREAK SPACE}")
    assert points_text(points, RU) == RU.counted(points, "points")
    assert points_text(None, RU) == ""


@pytest.mark.parametrize(
    ("name", "typst"),
    [
        ("omega_OA", "omega_(O A)"), ("v_O1", "v_(O_(1))"), ("OC", "O C"), ("phi", "phi"), ("v_rel_C", 'v_("rel" C)'),
        ("a_B.x", "a_(B x)"), ("omega_wheel", "omega"),
    ],
)  # fmt: skip
def test_symbols(name: str, typst: str) -> None:
    assert to_typst(EN.symbol(name, {"wheel": ""})) == typst


@pytest.mark.parametrize(
    ("value", "written"),
    [("1.666666666667", "5/3"), ("-2.166666666667", "−13/6"), ("0.25", "0,25"), ("0.123456789012", "0,123456789012")],
)
def test_a_quotient_that_does_not_come_out_is_printed_as_a_fraction(value: str, written: str) -> None:
    assert load_language("ru").decimal(Decimal(value)).text == written
