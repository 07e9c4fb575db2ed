"""A variant depends on seed, student, problem, family, form and ranges, on no marking, questions or texts."""

from __future__ import annotations

from decimal import Decimal
from pathlib import Path

import pytest
from msgspec.structs import replace

from benchmarks.sheets import drawn_sheets
from variantgen.errors import InputError
from variantgen.exam.allocation import DrawRequest, ProblemSampler
from variantgen.exam.exam_file import parse_exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.families.asking import read_ask
from variantgen.families.reading.load import load_family, parse_family
from variantgen.families.restrict import restrict
from variantgen.resources import catalog_dir
from variantgen.tables import read_toml
from variantgen.variants.examined import examined

STUDENTS = [Student(f"s{i}", f"N{i}", f"M-{i % 4}") for i in range(48)]
HEAD = 'title = "T"\nlanguage = "en"\nseed = 11\n'
FOUR_BAR = ["v_B", "omega_AB", "omega_BC", "a_B", "epsilon_AB", "epsilon_BC"]
SPOOL = ["v_O", "omega_spool", "v_A", "a_O", "epsilon_spool", "a_A"]

Data = dict[str, list[tuple[str, str, dict[str, str], int, int]]]


def problems(four_bar: list[str] = FOUR_BAR, spool: list[str] = SPOOL, more: str = "") -> str:
    return (
        f'[[problem]]\nfamily = "four_bar"\nform = "crank"\nask = {four_bar}\n{more}\n'
        f'[[problem]]\nfamilies = ["spool", "spool"]\nask = {spool}\n'
    )


def sheets(text: str) -> tuple[Sheet, ...]:
    return drawn_sheets(replace(parse_exam(text, Path("exam.toml"), ()), seed="11"), STUDENTS)


def data(text: str) -> Data:
    """By student and problem what was drawn."""
    return {
        sheet.student.id: [
            (v.family.name, v.form.name, {name: str(value) for name, value in v.printed.items()}, v.sense, v.turns)
            for v in (item.variant for item in sheet.items)
        ]
        for sheet in sheets(text)
    }


@pytest.fixture(scope="module")
def usual() -> Data:
    return data(HEAD + problems())


@pytest.mark.parametrize(
    "text",
    [
        HEAD + "tolerance = 0.02\n" + problems(),
        HEAD + "tolerance = 0.05\n" + problems(),
        HEAD + "tolerance = { floor = 0.004, ceiling = 0.1 }\n" + problems(),
        HEAD + problems(more="points = 10"),
        HEAD + problems(FOUR_BAR[:-1]),
        HEAD + problems(FOUR_BAR[1:], SPOOL[1:]),
        HEAD + problems(["a_B", "omega_AB.abs", "omega_BC.sense"], ["v_A", "a_A"]),
        HEAD.replace('"T"', '"Another title"') + 'course = "Course"\n' + problems(),
        HEAD.replace('"en"', '"ru"') + problems() + '[notation]\nangular_acceleration = "alpha"\n',
    ],
    ids=["0.02", "0.05", "table", "points", "without one", "without the first", "few", "texts", "language"],
)
def test_marking_questions_and_texts_change_nobodys_data(usual: Data, text: str) -> None:
    found = data(text)
    assert [student for student in usual if usual[student] != found[student]] == []


def test_only_whether_accelerations_are_asked_matters() -> None:
    velocities = data(HEAD + problems(FOUR_BAR[:3], SPOOL[:3]))
    assert data(HEAD + problems(FOUR_BAR[:2], SPOOL[2:3])) == velocities


def test_the_answers_have_the_tolerance_of_the_exam() -> None:
    answer_tolerances = {
        a.relative_tolerance
        for s in sheets(HEAD + "tolerance = 0.05\n" + problems())
        for i in s.items
        for a in i.answers
    }
    assert answer_tolerances == {0.05}


def test_an_explicit_ceiling_draws_only_those_again_who_need_more(usual: Data) -> None:
    free = {s.student.id: s for s in sheets(HEAD + problems())}
    text = HEAD + "tolerance = { floor = 0.01, ceiling = 0.015 }\n" + problems()
    cut = {s.student.id: s for s in sheets(text)}
    above = {
        (student, item.task.number)
        for student, sheet in free.items()
        for item in sheet.items
        if max(answer.relative_tolerance for answer in item.answers) > 0.015
    }
    moved = {
        (student, item.task.number)
        for student, sheet in cut.items()
        for item, before in zip(sheet.items, free[student].items, strict=True)
        if item.variant != before.variant
    }
    assert above
    assert above <= moved
    # The others moved for somebody who drew again and has what they had, or nearly that.
    assert len(moved - above) <= 3
    assert max(a.relative_tolerance for s in cut.values() for i in s.items for a in i.answers) <= 0.015 + 1e-12
    exam = parse_exam(text, Path("exam.toml"), ())
    drawer = ProblemSampler(replace(exam, seed="11"))
    requests = [DrawRequest(student, place) for student in STUDENTS for place in range(len(exam.tasks))]
    assert drawer.cut(requests, drawer.variants(requests)) == len(above)


def test_questions_that_the_family_does_not_ask_are_looked_at() -> None:
    form = load_family("four_bar").forms["crank"]
    assert [q.name for q in examined(form, read_ask(form, ["v_B"]))] == FOUR_BAR[:3]
    assert [q.name for q in examined(form, read_ask(form, ["epsilon_AB"]))] == FOUR_BAR
    own = examined(form, read_ask(form, ["v_B.x", "omega_AB.sense"]))
    assert [q.name for q in own] == [*FOUR_BAR[:3], "v_B.x"]


def test_what_is_zero_in_all_ranges_is_looked_at_only_where_it_is_asked() -> None:
    """``epsilon = a_O / R`` of a rolling wheel is zero where its centre keeps its velocity."""
    family = restrict(load_family("rolling_wheel"), {"a_O": 0})
    form = next(iter(family.forms.values()))
    epsilon = "epsilon_wheel"
    assert epsilon in [q.name for q in read_ask(form)]
    assert epsilon not in [q.name for q in examined(form, read_ask(form, ["a_A"]))]
    assert epsilon in [q.name for q in examined(form, read_ask(form, [epsilon]))]


def screened(key: str, value: str) -> None:
    path = catalog_dir() / "slider_crank" / "family.toml"
    parse_family({**read_toml(path), "screens": {key: Decimal(value)}}, path)


@pytest.mark.parametrize(
    ("key", "right", "wrong", "said"),
    [("ceiling", "0.02", "0.05", "from 0.001 to 0.03"), ("mistakes", "0.05", "0.005", "from 0.01 to 0.2")],
)
def test_a_family_can_only_be_stricter(key: str, right: str, wrong: str, said: str) -> None:
    screened(key, right)
    with pytest.raises(InputError) as caught:
        screened(key, wrong)
    assert any(p.key.endswith(f"screens.{key}") and said in p.message for p in caught.value.problems)
