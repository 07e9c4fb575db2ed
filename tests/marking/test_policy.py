"""What answers are worth, as the page about marking says it."""

from __future__ import annotations

import re
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import pytest

from variantgen.errors import InputError, Problem
from variantgen.exam.sections.marking_policy import CAUSES, read_policy, rounded
from variantgen.marking.typed_number import read_number
from variantgen.outputs.formats import parse_exam
from variantgen.tables import Table, parse_toml

PAGE = Path(__file__).parents[2] / "docs" / "marking.md"


def test_the_policy_of_the_docs() -> None:
    block = re.findall(r"```toml\n(.*?)```", PAGE.read_text("utf-8"), re.DOTALL)
    block = [text for text in block if "tolerance" in text]
    assert len(block) == 1
    problems: list[Problem] = []
    asked = {number: frozenset({"v_B", "a_B"}) for number in (1, 2, 3, 4)}
    policy = read_policy(Table(parse_toml(block[0], PAGE), "", problems), asked)
    assert problems == []
    assert policy.points == {1: 5, 2: 3}
    assert policy.is_struck(3, "v_B")
    assert policy.is_struck(2, "a_B")
    assert not policy.is_struck(2, "v_B")
    assert policy.grade(Fraction(85), Fraction(100)) == "5"
    assert policy.grade(Fraction(849, 10), Fraction(100)) == "4"
    assert policy.grade(Fraction(3), Fraction(10)) == ""


def test_the_docs_name_every_cause() -> None:
    assert set(re.findall(r"^\| `(\w+)` \|", PAGE.read_text("utf-8"), re.MULTILINE)) >= set(CAUSES)


def test_halves_are_rounded_up() -> None:
    step = Decimal("0.5")
    assert [rounded(Fraction(points, 100), step) for points in (24, 25, 74, 75, 100)] == [0, 0.5, 0.5, 1, 1]
    assert rounded(Fraction(1, 3), Decimal(0)) == Fraction(1, 3)


def test_the_table_of_an_exam_file(tmp_path: Path) -> None:
    text = 'title = "T"\nlanguage = "en"\n[[problem]]\nfamily = "four_bar"\nask = ["v_B"]\nform = "crank"\n'
    exam = parse_exam(text + '[marking]\nshares = { sign = 0.5 }\nstruck = ["1.v_B"]\n', tmp_path / "exam.toml", ())
    assert exam.marking.shares == {"sign": Decimal("0.5")}
    assert exam.marking.is_struck(1, "v_B")
    with pytest.raises(InputError, match=r"marking.struck: the problem asks for no such quantity"):
        parse_exam(text + '[marking]\nstruck = ["1.a_B"]\n', tmp_path / "exam.toml", ())


def test_every_spelling_of_the_docs_is_read() -> None:
    table = PAGE.read_text("utf-8").split("**Answers as typed.**")[1].split("\n\n")[1]
    rows = [re.findall(r"`([^`]+)`", row) for row in table.splitlines()[2:]]
    *numbers, signs, units = rows
    assert all(read_number(text) for row in numbers for text in row)
    assert read_number(signs[0])
    found = {text: read_number(f"3 {text}") for text in units}
    assert all(number is not None and number.unit is not None for number in found.values()), found
