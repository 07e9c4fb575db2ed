"""Notation: the letter of angular acceleration and the marks of components, wherever a symbol is written."""

from __future__ import annotations

import pytest

from variantgen.algebra.name import Name
from variantgen.errors import InputError
from variantgen.families.reading.load import load_family
from variantgen.wording.formula import to_plain
from variantgen.wording.language import load_language
from variantgen.wording.notation import Notation, notation_of
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.solution.quantity_symbols import Symbols

FORM = load_family("four_bar").forms["crank"]


@pytest.mark.parametrize(
    ("lang", "words", "angular", "angle", "normal"),
    [
        ("ru", (), "ε_AB", "α", "a^n_B"),
        ("ru", ("alpha",), "α_AB", "δ", "a^n_B"),
        ("ru", ("rotational",), "ε_AB", "α", "a^ос_B"),
        ("ru", ("alpha", "rotational"), "α_AB", "δ", "a^ос_B"),
        ("en", (), "α_AB", "δ", "(a_B)_n"),
        ("en", ("epsilon",), "ε_AB", "α", "(a_B)_n"),
        ("en", ("rotational",), "α_AB", "δ", "(a_B)_cp"),
    ],
)
def test_letters(lang: str, words: tuple[str, ...], angular: str, angle: str, normal: str) -> None:
    language = load_language(lang, notation_of(words))
    assert to_plain(language.symbol("epsilon_AB", {})) == angular
    assert to_plain(language.symbol("alpha", {})) == angle, "an angle must not be taken for the acceleration"
    symbols = Symbols(FORM, language, load_phrases(lang), {})
    assert to_plain(symbols.of(Name("epsilon", "AB"))) == angular
    assert to_plain(symbols.of(Name("a", "B", part="n"))) == normal


@pytest.mark.parametrize(
    ("name", "ru", "en"),
    [
        (Name("v", "B", "A"), "v_BA", "v_B/A"),
        (Name("a", "B", "A", "tau"), "a^τ_BA", "(a_B/A)_t"),
        (Name("a", "O1", part="n"), "a^n_O1", "(a_O1)_n"),
        (Name("v", "C", part="tr"), "v_пер C", "v_C′"),
        (Name("a", "C", "B", "tr tau"), "a^τ_пер CB", "(a_C′/B)_t"),
        (Name("a", "C", part="rel tau"), "a^τ_отн C", "(a_rel C)_t"),
        (Name("a", "C", part="cor"), "a_К C", "a_Cor C"),
        (Name("v", "M", part="on_tau"), "v_Mτ", "v_Mt"),
        (Name("drawn", "B", "A", "tau", "a"), "l^τ_BA", "(l_B/A)_t"),
    ],
)
def test_each_language_has_the_letters_of_its_textbooks(name: Name, ru: str, en: str) -> None:
    written = [
        to_plain(Symbols(FORM, load_language(lang), load_phrases(lang), {}).of(name))
        .replace(" τ", "τ")
        .replace(" t", "t")
        for lang in ("ru", "en")
    ]
    assert written == [ru, en]


def test_a_body_without_a_name_keeps_its_acceleration_apart_from_an_angle() -> None:
    language = load_language("en", Notation("alpha"))
    bodies = load_family("rolling_wheel").forms[""].symbols
    assert bodies["wheel"] == ""
    written = [to_plain(language.symbol(name, bodies)) for name in ("epsilon_wheel", "alpha")]
    assert written == ["α", "δ"]


@pytest.mark.parametrize("make", [lambda: Notation("beta"), lambda: notation_of(["alfa"])])
def test_unknown_notation(make: object) -> None:
    with pytest.raises(InputError, match="unknown notation"):
        make()  # type: ignore[operator]
