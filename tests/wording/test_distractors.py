"""Every mistake that a key may name has words in every language."""

from __future__ import annotations

import re

import pytest

from tests.solved_cases import every_case, quantities, variant_of
from variantgen.families.parameters.draw_rules import frame
from variantgen.resources import languages
from variantgen.variants.distractors import wrong_answers
from variantgen.variants.variant import parameter_arrays, solve_variants
from variantgen.wording.distractors import mistake_text
from variantgen.wording.language import load_language


@pytest.mark.parametrize(
    ("mistake", "en", "ru"),
    [
        (
            "normal acceleration of AB reversed",
            "normal acceleration of AB reversed",
            "нормальное ускорение при вращении звена AB направлено в обратную сторону",
        ),
        (
            "normal acceleration of wheel forgotten",
            "normal acceleration of 1 forgotten",
            "не учтено нормальное ускорение при вращении звена 1",
        ),
        (
            "normal acceleration of cam reversed",
            "normal acceleration reversed",
            "нормальное ускорение направлено в обратную сторону",
        ),
        ("Coriolis acceleration of C forgotten",) * 2 + ("не учтено ускорение Кориолиса точки C",),
        ("given accelerations reversed",) * 2 + ("заданные ускорения взяты с обратным знаком",),
        ("phi in degrees for radians", "φ in degrees for radians", "φ в градусах вместо радианов"),
        ("B on the other branch", "B on the other side", "точка B взята по другую сторону"),
        ("something else", "something else", "something else"),
    ],
)
def test_words(mistake: str, en: str, ru: str) -> None:
    symbols = {"wheel": "1", "cam": ""}
    assert mistake_text(mistake, load_language("en"), symbols) == en
    assert mistake_text(mistake, load_language("ru"), symbols) == ru


def test_every_mistake_of_the_catalogue_has_words() -> None:
    forms = {id(case.form): (family, case) for family, case in every_case()}
    names = set()
    for family, case in forms.values():
        variant, asked = variant_of(family, case), quantities(case)
        motion = solve_variants([variant], 2)
        found = wrong_answers(
            case.form, parameter_arrays([variant]), frame([variant.sense], [variant.turns]), asked, motion
        )
        names |= {(name, tuple(case.form.symbols.items())) for name in found}
    assert len(names) > 100
    for language in map(load_language, languages()):
        for name, symbols in names:
            output = mistake_text(name, language, dict(symbols))
            assert "_" not in output.replace("φ_", "")
            if language.name == "ru":
                assert not re.search(r"[a-z]{3}", output), output
