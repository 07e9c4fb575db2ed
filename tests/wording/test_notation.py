"""Notation: the letter of angular acceleration and the marks of components, wherever a symbol is written."""

from __future__ import annotations

import pytest

from variantgen.algebra.name import Name
from variantgen.errors import InputError
from variantgen.families.load import load_family
from variantgen.wording.formula import to_plain
from variantgen.wording.language import load_language
from variantgen.wording.notation import Notation, notation_of
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.solution.quantity_symbols import Symbols

FORM = load_family("four_bar").forms["crank"]


@pytest.mark.parametrize(
    ("words", "angular", "angle", "normal"),
    [
        ((), "ε_AB", "α", "a^n_B"),
        (("alpha",), "α_AB", "δ", "a^n_B"),
        (("rotational",), "ε_AB", "α", "a^ос_B"),
        (("alpha", "rotational"), "α_AB", "δ", "a^ос_B"),
    ],
)
def test_letters(words: tuple[str, ...], angular: str, angle: str, normal: str) -> None:
    language = load_language("ru", notation_of(words))
    assert to_plain(language.symbol("epsilon_AB", {})) == angular
    assert to_plain(language.symbol("alpha", {})) == angle, "an angle must not be taken for the acceleration"
    symbols = Symbols(FORM, language, load_phrases("ru"), {})
    assert to_plain(symbols.of(Name("epsilon", "AB"))) == angular
    assert to_plain(symbols.of(Name("a", "B", part="n"))) == normal


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
