"""Words are data: every key in every language, every one that a page uses."""

from __future__ import annotations

import ast
import re
import tomllib
from string import Formatter

import pytest
from jinja2 import Environment, TemplateSyntaxError

from variantgen.errors import InputError, Problem
from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.studio.messages import command_text, error_text, in_language
from variantgen.studio.words import ASSETS, LANGUAGES

PARTS = ("choose", "compose", "build", "roster", "mark", "play")  # pages whose pieces are templates of their own


def tables(language: str) -> dict[str, dict[str, str]]:
    return tomllib.loads((ASSETS / "words" / f"{language}.toml").read_text("utf-8"))


def named(text: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(text) if name}


def test_languages_have_the_same_keys_that_name_the_same_things() -> None:
    english, *others = [tables(language) for language in LANGUAGES]
    for other in others:
        assert {t: set(w) for t, w in english.items() if not t.startswith("plural")} == {
            t: set(w) for t, w in other.items() if not t.startswith("plural")
        }
        for table, words in english.items():
            for key in words if not table.startswith("plural") else ():
                assert named(words[key]) == named(other[table][key]), (table, key)
                assert words[key] == "" or other[table][key].strip(), (table, key)
        assert {key.partition(".")[0] for key in other["plurals"]} == {k.partition(".")[0] for k in english["plurals"]}


def test_pages_use_words_that_there_are() -> None:
    english = tables("en")
    for path in sorted((ASSETS / "pages").glob("*.j2")):
        table = path.name.partition(".")[0]
        own = english.get(table) or {key: word for name in PARTS for key, word in english[name].items()}
        for name in re.findall(r"\bwords\.(\w+)", path.read_text("utf-8")):
            assert name in own or name in ("get", "title"), (path.name, name)
        for name in re.findall(r"\bframe\.(?!html)(\w+)", path.read_text("utf-8")):
            assert name in english["frame"], (path.name, name)


def test_every_form_of_the_catalogue_is_told() -> None:
    told = tomllib.loads((ASSETS / "catalogue.toml").read_text("utf-8"))
    assert set(told) == set(family_names())
    for name, forms in told.items():
        family = load_family(name)
        assert set(forms) == set(family.forms), name
        for own in forms.values():
            assert own["level"] in (1, 2, 3)
            assert len(family.forms) == 1 or (own["en"] and own["ru"])


def messages_of_the_studio() -> set[str]:
    """What the studio says of wrong input, with {} for what is named in it."""
    found = set()
    for path in ASSETS.parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Problem":
                for said in [*node.args[:1], *(word.value for word in node.keywords if word.arg == "remedy")]:
                    parts = said.values if isinstance(said, ast.JoinedStr) else [said]
                    constants = [part.value if isinstance(part, ast.Constant) else "{}" for part in parts]
                    found.add("".join(map(str, constants)))
    return found - {"{}"}


def test_messages_of_the_studio_are_told_in_russian() -> None:
    known = tomllib.loads((ASSETS / "messages" / "ru.toml").read_text("utf-8"))
    assert messages_of_the_studio() - known.keys() == set()
    assert all(english.count("{}") == russian.count("{}") for english, russian in known.items())
    assert in_language("expected a whole number, 1 to 5", "ru") == "ожидалось целое число от 1 до 5"
    assert in_language("unknown key (got pionts)", "ru") == "неизвестный ключ (получено pionts)"
    assert in_language("unknown key (pionts)", "ru") == "неизвестный ключ (pionts)"
    assert in_language("did you mean points?", "ru") == "имелось в виду points?"
    assert in_language("unknown key", "en") == in_language("unknown key", "") == "unknown key"
    assert in_language("nobody has said this", "ru") == "nobody has said this"
    error = InputError(Problem("the id stands twice", "list.csv", "row 3", "7", "it is the id of row 2 too"))
    assert (
        error_text(error, "ru") == "list.csv: row 3: номер стоит дважды (получено 7)\n    этот номер и у другой: row 2"
    )


def in_russian(text: str) -> bool:
    """Whether no English word is left; names in quotes are those of the file."""
    return not re.search(r"[a-z]{3,}", re.sub(r"'[^']*'", "", text).replace("TOML", ""))


@pytest.mark.parametrize(
    "text",
    [
        "a = ", "a b", "a = 1 2", "[a", "[[a]", "a = [1", "a = {b = 1", "a = 1\na = 2", "[a]\n[a]", 'a = "x',
        "= 1", "a = 1,5", 'a = "\\q"', 'a = "\x01"', "a = 2026-13-01", "a = {b = 1, b = 2}",
        "a = [1]\n[[a]]", "a = '''x",
    ],
)  # fmt: skip
def test_what_the_reader_of_toml_says_is_told_in_russian(text: str) -> None:
    with pytest.raises(tomllib.TOMLDecodeError) as error:
        tomllib.loads(text)
    told = in_language(f"is not valid TOML: {error.value}", "ru")
    assert in_russian(told), told
    assert re.search(r"\(строка [12]|\(в конце файла", told)


@pytest.mark.parametrize(
    "text",
    [
        "{{ a", "{{ a b }}", "{% if a %}", "{% wish %}", "{% if a %}{% endfor %}", "{# a", "{{ a | b }}",
        "{{ 1 is b }}", "{{ ! }}", "{% endif %}",
    ],
)  # fmt: skip
def test_what_the_reader_of_templates_says_is_told_in_russian(text: str) -> None:
    with pytest.raises(TemplateSyntaxError) as error:
        Environment().from_string(text)
    told = in_language(f"line {error.value.lineno}: the template fails: {error.value.message}", "ru")
    assert told.startswith("строка 1: ") and in_russian(told), told


def test_what_a_command_says_is_told_in_russian() -> None:
    said = "variantgen: /x/exam.toml: problem[1].tolerance: expected a number (got none)\n    did you mean 5?\n"
    assert command_text(said, "en") == said.removeprefix("variantgen: ").strip()
    told = "/x/exam.toml: problem[1].tolerance: ожидалось число (получено none)\n    имелось в виду 5?"
    assert command_text(said, "ru") == told
