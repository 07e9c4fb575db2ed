"""The sentences of solutions: equal in content in all languages, with fields that the facts can fill."""

from __future__ import annotations

import re

import pytest

from variantgen.resources import templates_dir
from variantgen.wording.language import languages
from variantgen.wording.solution.phrases import Field, Letter, Phrases, cut, load_phrases

CASES = {"", "of", "to", "by", "on", "what"}


def fields(phrases: Phrases, key: str) -> set[str]:
    return {part.name for part in phrases.sentences[key] if isinstance(part, Field)}


def test_every_language_has_the_same_files_and_sentences() -> None:
    folders = [templates_dir() / "solution" / name for name in languages()]
    assert len({frozenset(path.name for path in folder.glob("*.toml")) for folder in folders}) == 1
    assert len({frozenset(load_phrases(name).sentences) for name in languages()}) == 1
    for table in ("words", "bodies", "functions"):
        assert len({frozenset(getattr(load_phrases(name), table)) for name in languages()}) == 1


@pytest.mark.parametrize("key", sorted(load_phrases("en").sentences))
def test_a_sentence_says_the_same_of_the_same_things(key: str) -> None:
    found = {name: fields(load_phrases(name), key) for name in languages()}
    assert len({frozenset(names) for names in found.values()}) == 1, found


@pytest.mark.parametrize("name", languages())
def test_sentences_are_whole(name: str) -> None:
    phrases = load_phrases(name)
    for key, phrase in phrases.sentences.items():
        text = "".join(part if isinstance(part, str) else "X" for part in phrase)
        assert text.strip() == text, key
        assert text, key
        assert not re.search(r"[{}]|  ", text), key
        for part in phrase:
            if isinstance(part, Field):
                assert part.case in CASES, key
        if name == "ru":
            # What is put together of fields alone has no words of its own.
            own = "".join(part for part in phrase if isinstance(part, str))
            assert re.search("[а-яё]", own, re.IGNORECASE) or not re.search(r"[^\W\d_]", own), key


@pytest.mark.parametrize("name", languages())
def test_bodies_have_a_name_in_every_case(name: str) -> None:
    for kind, cases in load_phrases(name).bodies.items():
        assert set(cases) == {"name", *CASES} - {""}, kind
        assert all(cases.values()), kind


def test_a_sentence_is_cut_at_its_fields() -> None:
    assert cut("a {b} c{d.of}.") == ("a ", Field("b"), " c", Field("d", "of"), ".")
    assert cut("axis {=x}") == ("axis ", Letter("x"))
    assert cut("plain") == ("plain",)
