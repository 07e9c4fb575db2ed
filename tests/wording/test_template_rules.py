"""Statements are data of instructors: a template cannot hang, eat memory, or say something that nobody sees."""

from __future__ import annotations

import resource
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from variantgen.errors import InputError
from variantgen.resources import catalog_dir, templates_dir
from variantgen.wording.template import load_template

DOUBLING = "{% set a = ['x', 'x'] %}" + "{% set a = [a, a] %}" * 40 + "{% set b = ['x', 'x'] %}"
DOUBLING += "{% set b = [b, b] %}" * 40 + "{% if a == b %}same{% endif %}"


def template(folder: Path, text: str) -> Path:
    """A file with a template."""
    path = folder / "statement.en.j2"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (DOUBLING, "set of a list"),
        ('{% set a = ("x", "x") %}', "set of a list"),
        ('{% set a = "x" if zero("phi") else ["x"] %}', "set of a list"),
        ('{% set zero = "x".zfill %}{{ zero(20000000) }}', "another meaning of zero"),
        ('{% set zero = "x" %}', "another meaning of zero"),
        ("{% set choice = OA %}{{ choice.upper }}", "another meaning of choice"),
        ("{% set a, b = OA, OB %}", "set of several names"),
        ("{% set a = OA.zfill %}", "the attribute zfill"),
        ("{{ form.format }}", "the attribute format"),
        ("{{ choice.side.upper }}", "the attribute upper"),
        ("{{ speeds.append }}", "the attribute append"),
        (r'{{ "\ud800" }}', "U+D800 in quotes"),
        (r'{{ "\ue0000\ue001" }}', "U+E000, U+E001 in quotes"),
        (r'{% if form == "\u202e" %}x{% endif %}', "U+202E RIGHT-TO-LEFT OVERRIDE in quotes"),
    ],
)
def test_what_may_grow_or_hide_is_refused(text: str, said: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as error:
        load_template(template(tmp_path, f"First line.\n{text}"))
    assert f"line 2: {said} is not allowed in a statement" in str(error.value)
    assert "statement.en.j2" in str(error.value)


@pytest.mark.parametrize(("letter", "number"), [("\ue000", "U+E000"), ("\x1b", "U+001B"), ("\u200b", "U+200B")])
def test_what_cannot_be_seen_is_refused(letter: str, number: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as error:
        load_template(template(tmp_path, f"A rod.\n\tMore.\r\n{letter}7"))
    assert "line 3: the statement holds" in str(error.value)
    assert number in str(error.value)


def own_family(folder: Path, text: str) -> Path:
    """A copy of a family of the catalogue with another English statement."""
    target = folder / "own_bar"
    shutil.copytree(catalog_dir() / "four_bar", target)
    template(target, text)
    return target


@pytest.mark.parametrize("text", [DOUBLING, '{% set zero = "x".zfill %}{{ zero(20000000) }}'])
def test_a_small_template_neither_hangs_nor_eats_memory(text: str, tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "variantgen", "show", str(own_family(tmp_path, text))],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30)),
    )
    assert done.returncode == 2, done.stderr
    assert "is not allowed in a statement" in done.stderr


def test_a_symbol_keeps_its_meaning(tmp_path: Path) -> None:
    """A statement that prints another letter for a parameter would contradict the figure."""
    done = subprocess.run(
        [sys.executable, "-m", "variantgen", "show", str(own_family(tmp_path, "A\n{% set phi = OA %}{{ phi }}"))],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 2, done.stderr
    assert "line 2: the name has a meaning already (got phi)" in done.stderr


SHIPPED = sorted([*catalog_dir().glob("*/statement.*.j2"), *templates_dir().glob("new/family/statement.*.j2")])


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: f"{path.parent.name}-{path.suffixes[0][1:]}")
def test_shipped_templates_are_allowed(path: Path) -> None:
    assert load_template(path).variables


def test_a_template_that_is_changed_is_read_anew(tmp_path: Path) -> None:
    path = template(tmp_path, "one")
    first = load_template(path)
    assert load_template(path) is first
    template(tmp_path, "two")
    assert load_template(path).fill({}) == "two"
