"""One word for one thing in everything that is read, and no letter with two meanings."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from decimal import Decimal
from pathlib import Path

import pytest
from msgspec.structs import replace

from variantgen.check.family import check_family
from variantgen.check.glossary import avoided_words, family_words, terms
from variantgen.check.letters import ambiguous_letters
from variantgen.families.asking import read_ask
from variantgen.families.parameters.parameter import Parameter
from variantgen.families.parameters.units import UNITS
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.resources import catalog_dir, languages, templates_dir
from variantgen.tables import read_toml
from variantgen.wording.language import load_language
from variantgen.wording.notation import Notation


@pytest.mark.parametrize(
    ("language", "text", "keys"),
    [
        ("en", "The rod is hinged to a sleeve; the thread is inextensible.", ["cord", "pin", "collar"]),
        ("en", "The collar is pinned to the rod, the cord does not slip.", []),
        ("en", "It turns counter-clockwise (its rotation slows down).", ["counterclockwise", "speeding"]),
        ("en", "We draw the plan with the pole p.", []),
        ("ru", "имеет угловое ускорение (вращение замедленное)", ["speeding"]),
        ("ru", "Нить перекинута через блок, муфта скользит по стержню.", []),
        (
            "ru",
            "Трос навит на барабан; втулка скользит; против часовой стрелки",
            ["cord", "collar", "counterclockwise"],
        ),
    ],
)
def test_avoided_words_are_found(language: str, text: str, keys: list[str]) -> None:
    assert [term.key for _, term in avoided_words(text, language)] == keys


def test_every_language_names_the_same_things() -> None:
    keys = {language: [term.key for term in terms(language)] for language in languages()}
    assert len(keys["en"]) > 10
    assert all(found == keys["en"] for found in keys.values())


def texts(value: object) -> Iterator[str]:
    if isinstance(value, dict):
        for item in value.values():
            yield from texts(item)
    elif isinstance(value, str):
        yield re.sub(r"\{[^}]*\}", "", value)  # the names of facts are no text


@pytest.mark.parametrize("language", languages())
def test_templates_keep_to_the_glossary(language: str) -> None:
    folder = templates_dir()
    files = [folder / "words" / f"{language}.toml", *sorted((folder / "solution" / language).glob("*.toml"))]
    assert len(files) > 20
    found = [
        f"{path.name}: {word} ({term.use}) in {text}"
        for path in files
        for text in texts(read_toml(path))
        for word, term in avoided_words(text, language)
    ]
    assert not found, "\n".join(found)


def test_the_catalogue_keeps_to_the_glossary() -> None:
    assert [(name, *found) for name in family_names() for found in family_words(load_family(name))] == []


def test_check_tells_an_author(tmp_path: Path) -> None:
    copy = tmp_path / "spool"
    shutil.copytree(catalog_dir() / "spool", copy)
    path = copy / "statement.en.j2"
    path.write_text(path.read_text("utf-8").replace("cord", "thread", 1), "utf-8")
    remarks = check_family(str(copy / "family.toml"), seeds=3).remarks
    said = "statement.en.j2: 'thread' is called 'cord' elsewhere (templates/glossary/en.toml)"
    assert [remark for remark in remarks if "elsewhere" in remark] == [said]


def test_the_page_of_the_glossary_has_every_term() -> None:
    page = (Path(__file__).parents[1] / "docs" / "glossary.md").read_text("utf-8").lower()
    assert [term.use for language in languages() for term in terms(language) if term.use.lower() not in page] == []


@pytest.mark.parametrize(
    ("name", "language", "notation", "both"),
    [
        ("delta", "en", "", "δ stands for alpha and for delta"),
        ("delta", "ru", "", ""),
        ("delta", "ru", "alpha", "δ stands for alpha and for delta"),
        ("epsilon", "ru", "", "ε stands for epsilon and for epsilon_wheel"),
        ("epsilon_0", "ru", "", "ε_0 and ε stands for epsilon_0 and for epsilon_wheel"),
        ("beta", "en", "", ""),
    ],
)
def test_a_letter_with_two_meanings_is_told(name: str, language: str, notation: str, both: str) -> None:
    """The wheel has the angle alpha and the asked angular acceleration of a body without a name."""
    form = load_family("rolling_wheel").forms[""]
    angle = Parameter(name, UNITS["deg"], (Decimal(30),), symbol=name)
    form = replace(form, parameters={**form.parameters, name: angle})
    found = list(ambiguous_letters(form, read_ask(form), load_language(language, Notation(notation))))
    assert [message.partition(";")[0] for message in found] == ([both] if both else [])
