"""One body over every family: the text in words says what the figure shows, truly, and nothing else."""

from __future__ import annotations

import importlib
import importlib.util
import re
import string

import pytest

from tests.described_figures import COMPASS, DescribedFigure, asked_together, described_figures, pattern, words_of
from variantgen.families.reading.folders import family_names
from variantgen.mechanism.component import discover
from variantgen.resources import languages
from variantgen.variants.printed_data import shown_points
from variantgen.wording.formula import SymbolProperty, letters, to_plain
from variantgen.wording.language import load_language

FAMILIES = family_names()
KINDS = [*discover("variantgen.mechanism.joints"), *discover("variantgen.mechanism.drivers")]


@pytest.mark.parametrize("name", FAMILIES)
def test_text_is_whole_and_short(name: str) -> None:
    for each in described_figures(name):
        text = each.figure.alt
        assert 100 < len(text) <= 900, text
        assert 3 <= len(re.findall(r"\.(?: |$)", text)) <= 8, text
        assert text[0].isupper()
        assert text[-1] == "."
        assert not re.search(r"[{}]|None|  | [,.;)]|\( |\(\)|;\.|:\.", text), text


@pytest.mark.parametrize("velocities", [False, True])
@pytest.mark.parametrize("name", FAMILIES)
def test_everything_labelled_is_named_and_nothing_else(name: str, velocities: bool) -> None:
    for each in described_figures(name, velocities):
        text = each.figure.alt
        points = {each.named(point) for point in shown_points(each.variant, each.asked)}
        assert points <= each.labels
        said = words_of(text)
        spelled = {"".join(part) for word in said if "_" not in word for part in letters(word)}
        for label in each.labels:
            standing = re.search(rf"(?<!\w){re.escape(label)}(?!\w)", text)
            assert standing or (label in points and label in spelled), (label, text)
        # Letters and symbols of the text are those of the figure; names of bodies are spelled with its points.
        if each.language.name == "ru":
            names = said
        else:
            names = {word for word in said if re.search(r"[A-Zα-ω0-9_]", word[1:] or word) or len(word) == 1} - {"a"}
        for word in names:
            parts = {"".join(part) for part in letters(word)} if "_" not in word else set()
            assert word in each.labels | each.of_graphs or (parts and parts <= points), (word, text)


@pytest.mark.parametrize(("quantity", "shown"), [("v_B.x", True), ("v_B.angle", True), ("v_B", False)])
def test_axes_are_told_where_they_are_drawn(quantity: str, shown: bool) -> None:
    for each in asked_together("slider_crank", quantity):
        assert ({"x", "y"} <= each.labels) is shown
        assert (each.words["axes"] in each.items("marks")) is shown


@pytest.mark.parametrize("name", ["point_on_rotating_disc", "sliding_block_on_rotating_rod"])
def test_right_angles_are_told_and_right(name: str) -> None:
    marked = [each for each in described_figures(name) if each.variant.form.figure.right_angles]
    assert marked
    for each in marked:
        said = [item for item in each.items("marks") if pattern(each.words["right_angle"], corner=".*?").match(item)]
        for mark, item in zip(each.variant.form.figure.right_angles, said, strict=True):
            start, end = (each.z[name] - each.z[mark.at] for name in (mark.start, mark.end))
            assert abs((start * end.conjugate()).real) < 1e-9 * abs(start * end)
            assert each.words["at_corner"].format(corner=mark.at) in item


@pytest.mark.parametrize("name", FAMILIES)
def test_nothing_asked_is_told(name: str) -> None:
    for each in described_figures(name):
        sketched = each.variant.form.figure.sketch
        for quantity in (quantity for quantity in each.asked if quantity.name not in sketched):
            formula = each.language.quantity(quantity, each.variant.form.symbols)
            symbol = to_plain(formula.symbol if isinstance(formula, SymbolProperty) else formula)
            assert not re.search(rf"(?<!\w){re.escape(symbol)}(?!\w)", each.figure.alt), (symbol, each.figure.alt)


@pytest.mark.parametrize("name", FAMILIES)
def test_each_language_keeps_to_its_letters(name: str) -> None:
    for each in described_figures(name):
        if each.language.name == "ru":
            assert not re.search(r"[a-z]{2}", each.figure.alt.replace("rel", "")), each.figure.alt
        else:
            assert not re.search("[А-Яа-яЁё]", each.figure.alt), each.figure.alt


@pytest.mark.parametrize("name", FAMILIES)
def test_languages_say_the_same(name: str) -> None:
    by_variant: dict[int, list[DescribedFigure]] = {}
    for each in described_figures(name):
        by_variant.setdefault(id(each.variant), []).append(each)
    for group in by_variant.values():
        for key in ("parts", "positions", "marks", "arrows"):
            assert len({len(each.items(key)) for each in group}) == 1, [each.figure.alt for each in group]
        assert len({each.figure.alt.count(".") for each in group}) == 1


@pytest.mark.parametrize("lang", languages())
@pytest.mark.parametrize("stem", KINDS)
def test_every_joint_and_driver_has_its_phrase(stem: str, lang: str) -> None:
    phrases = load_language(lang).words("figure")
    assert any(key == stem or key.startswith(stem + "_") for key in phrases), f"[figure] {stem} = ... in {lang}.toml"
    name = f"variantgen.figure.alt_text.kinds.{stem}"
    if importlib.util.find_spec(name) is None:
        assert stem in phrases, "a kind without a module of its own is told by the phrase of its name"
    else:
        assert callable(importlib.import_module(name).tell)


def slots(phrase: str) -> set[str]:
    return {slot.partition(".")[0] for _, slot, _, _ in string.Formatter().parse(phrase) if slot}


@pytest.mark.parametrize("table", ["figure", "figure_place", "figure_way", "figure_side", "figure_line"])
def test_languages_have_the_same_phrases_with_the_same_slots(table: str) -> None:
    spoken = [load_language(lang).words(table) for lang in languages()]
    for words in spoken:
        assert [key for key in words if "." not in key] == [key for key in spoken[0] if "." not in key]
        for key, text in words.items():  # a form of a phrase has the slots of the phrase
            assert slots(text) == slots(spoken[0][key.partition(".")[0]]), key


# What inflects, by the slots that it stands in.
NOUNS = {
    "body disc first second other sleeve bodies": ("body", "disc", "disc_about"),
    "hinged": ("hinged", "on_fixed_hinge"),
    "line": ("level", "upright", "rising", "falling"),
}


@pytest.mark.parametrize("lang", languages())
def test_words_have_every_form_that_a_phrase_asks_for(lang: str) -> None:
    language = load_language(lang)
    known = {*language.words("figure"), *language.words("figure_line_attribute")}
    for phrase in language.words("figure").values():
        for _, slot, _, _ in string.Formatter().parse(phrase):
            name, _, form = (slot or "").partition(".")
            if form:
                nouns = next(nouns for slots, nouns in NOUNS.items() if name in slots.split())
                assert {f"{noun}.{form}" for noun in nouns} <= known, phrase


@pytest.mark.parametrize("lang", languages())
def test_directions_have_different_words(lang: str) -> None:
    language = load_language(lang)
    for table in ("figure_place", "figure_way"):
        assert sorted(language.words(table)) == sorted(COMPASS)
        assert len(set(language.words(table).values())) == len(COMPASS)
