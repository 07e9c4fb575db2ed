"""The sentences of solutions: equal in content in all languages, with fields that the facts can fill."""

from __future__ import annotations

import re

import pytest

from variantgen.resources import languages, templates_dir
from variantgen.wording.solution.phrases import Letter, Phrases, SentenceField, cut, load_phrases


def fields(phrases: Phrases, key: str) -> set[str]:
    return {part.name for part in phrases.sentences[key] if isinstance(part, SentenceField)}


def plain(key: str) -> str:
    """The key of a sentence without the name of its form: ``graphical.image`` of ``graphical.image.of``."""
    return ".".join(key.split(".")[:2])


def test_every_language_has_the_same_files_and_sentences() -> None:
    folders = [templates_dir() / "solution" / name for name in languages()]
    assert len({frozenset(path.name for path in folder.glob("*.toml")) for folder in folders}) == 1
    assert len({frozenset(map(plain, load_phrases(name).sentences)) for name in languages()}) == 1
    for table in ("words", "bodies", "functions"):
        assert len({frozenset(getattr(load_phrases(name), table)) for name in languages()}) == 1


@pytest.mark.parametrize("key", sorted({plain(key) for key in load_phrases("en").sentences}))
def test_a_sentence_says_the_same_of_the_same_things(key: str) -> None:
    found = {
        (name, each): fields(load_phrases(name), each)
        for name in languages()
        for each in load_phrases(name).sentences
        if plain(each) == key
    }
    assert len({frozenset(names) for names in found.values()}) == 1, found


@pytest.mark.parametrize("name", languages())
def test_sentences_are_whole(name: str) -> None:
    phrases = load_phrases(name)
    for key, phrase in phrases.sentences.items():
        text = "".join(part if isinstance(part, str) else "X" for part in phrase)
        assert text.strip() == text, key
        assert text, key
        assert not re.search(r"[{}]|  ", text), key
        if name == "ru":
            # What is put together of fields alone has no words of its own.
            own = "".join(part for part in phrase if isinstance(part, str))
            assert re.search("[а-яё]", own, re.IGNORECASE) or not re.search(r"[^\W\d_]", own), key


@pytest.mark.parametrize("name", languages())
def test_names_have_every_form_that_a_sentence_asks_for(name: str) -> None:
    phrases = load_phrases(name)
    asked: dict[bool, set[str]] = {True: set(), False: set()}  # of places of a plan, of bodies
    for key, phrase in phrases.sentences.items():
        asked[key.startswith("graphical.")] |= {part.form for part in phrase if isinstance(part, SentenceField)}
        asked[False] -= {"", "under"}  # what lies under a point is no body
        asked[True] -= {""}
    for place in ("graphical.image", "graphical.end", "graphical.start"):
        assert {place, *(f"{place}.{form}" for form in asked[True])} == {
            k for k in phrases.sentences if plain(k) == place
        }
    for kind, names in phrases.bodies.items():
        assert {"name", *asked[False]} <= set(names), kind
        assert set(names) == set(phrases.bodies["link"]), kind
        assert all(names.values()), kind


def test_a_sentence_is_cut_at_its_fields() -> None:
    assert cut("a {b} c{d.of}.") == ("a ", SentenceField("b"), " c", SentenceField("d", "of"), ".")
    assert cut("axis {=x}") == ("axis ", Letter("x"))
    assert cut("plain") == ("plain",)
