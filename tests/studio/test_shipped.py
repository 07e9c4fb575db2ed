"""The gallery of the first start: cards and figures of the catalogue that come with the package are those of today."""

from __future__ import annotations

import pytest

from tests.studio.asking import Asking
from variantgen.resources import catalog_dir
from variantgen.studio.gallery.cards import cards_of, family_files
from variantgen.studio.gallery.figures import FIRST_SEED, draw_card
from variantgen.studio.gallery.shipped import is_current, shipped_cards, shipped_figure
from variantgen.studio.studio import Studio
from variantgen.studio.words import LANGUAGES

ANEW = "python -m variantgen.studio.gallery.shipping"


@pytest.mark.parametrize("family, form", [("four_bar", "crank"), ("spool", ""), ("planetary_train", "two_planets")])
def test_some_figures_are_up_to_date(studio: Studio, family: str, form: str) -> None:
    path = catalog_dir() / family / "family.toml"
    drawn = {language: draw_card(studio.workspace, family, form, FIRST_SEED, language) for language in LANGUAGES}
    assert drawn == {language: shipped_figure(family, path, form, language) for language in LANGUAGES}, ANEW
    without = [{k: v for k, v in card.items() if k != "version"} for card in cards_of(family, path, studio.workspace)]
    assert without == shipped_cards(family, path), ANEW


def test_nearly_all_families_are_there(studio: Studio) -> None:
    files = family_files(studio.workspace)
    old = [name for name, path in files.items() if not is_current(name, path)]
    assert len(old) <= 3, (old, ANEW)


def test_a_changed_family_is_drawn_anew(client: Asking, studio: Studio) -> None:
    """A family of the folder that bears the name of one of the catalogue has its own figure."""
    source, own = catalog_dir() / "spool", studio.workspace.folder / "spool"
    own.mkdir()
    for path in source.iterdir():
        (own / path.name).write_bytes(path.read_bytes())
    text = (own / "family.toml").read_text("utf-8")
    (own / "family.toml").write_text(text.replace("title = {", "source = 'own'\ntitle = {", 1), "utf-8")
    assert client.get("/figure/spool/-/11.svg").status == 400  # two sources
    (own / "family.toml").write_text(text, "utf-8")
    found = client.get("/figure/spool/-/11.svg")
    assert found.status == 200 and list(studio.workspace.state("cache", "figures").iterdir())
