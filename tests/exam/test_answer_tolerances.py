"""Tolerances of an exam: floor, ceiling, mistakes; in sheets, key and manifest."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

from benchmarks.sheets import drawn_sheets
from tests.pdf_text import page_texts
from variantgen.builder import build
from variantgen.errors import InputError
from variantgen.exam import answer_tolerances
from variantgen.exam.answer_tolerances import AnswerTolerances, hand_errors
from variantgen.exam.exam_file import read_exam
from variantgen.exam.roster import Student, numbered
from variantgen.exam.sections.tolerance import Tolerance
from variantgen.families.asking import read_ask
from variantgen.families.parameters.draw_rules import frame
from variantgen.families.reading.load import load_family
from variantgen.families.restrict import restrict
from variantgen.variants.distractors import distances, wrong_answers
from variantgen.variants.draw import draw
from variantgen.variants.variant import parameter_arrays, solve_variants

EXAM = """
title = "Exam"
language = "{language}"
{tolerance}
[solutions]
depth = "none"
[[problem]]
family = "four_bar"
form = "crank"
[[problem]]
family = "spool"
"""


def written(folder: Path, tolerance: str, language: str = "en") -> Path:
    path = folder / "exam.toml"
    path.write_text(EXAM.format(tolerance=tolerance, language=language), "utf-8")
    return path


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", Tolerance(0.01, None, True)),
        ("tolerance = 0.02", Tolerance(0.02, None, True)),
        ("tolerance = 0.05", Tolerance(0.05, None, True)),
        ("tolerance = { floor = 0.005, ceiling = 0.02, mistakes = false }", Tolerance(0.005, 0.02, False)),
    ],
)
def test_the_exam_file_says_the_tolerances(tmp_path: Path, text: str, expected: Tolerance) -> None:
    assert read_exam(written(tmp_path, text)).tolerance == expected


@pytest.mark.parametrize(
    ("text", "key", "said"),
    [
        ("tolerance = 0", "tolerance", "between 0 and 0.2"),
        ("tolerance = 0.5", "tolerance", "between 0 and 0.2"),
        ('tolerance = "1 %"', "tolerance", "a number or a table"),
        ("tolerance = { floor = 0.02, ceiling = 0.01 }", "tolerance.ceiling", "between the floor, 0.02, and 0.2"),
        ("tolerance = { flour = 0.02 }", "tolerance.flour", "unknown key"),
        ("tolerance = { floor = 0.3 }", "tolerance.floor", "between 0 and 0.2"),
    ],
)
def test_mistakes_in_the_exam_file_are_told(tmp_path: Path, text: str, key: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        read_exam(written(tmp_path, text))
    assert any(problem.key == key and said in problem.message for problem in caught.value.problems)


def test_no_variant_needs_more_than_the_ceiling_or_lets_a_mistake_pass() -> None:
    usual = restrict(load_family("four_bar"), None, None, ("crank",))
    form = usual.forms["crank"]
    family = replace(usual, forms={"crank": replace(form, screens=replace(form.screens, ceiling=0.02))})
    keys = [("margins", i) for i in range(40)]
    tight = AnswerTolerances()
    variants = draw(family, None, keys, screening=tight)
    assert [v.identity for v in variants] != [v.identity for v in draw(usual, None, keys, screening=AnswerTolerances())]
    asked = read_ask(variants[0].form)
    motion = solve_variants(variants, 2)
    needed = AnswerTolerances().tolerances(variants, asked, motion, range(40))
    assert np.max(needed) <= 0.02 + 1e-12
    assert np.min(needed) >= 0.01
    assert np.any(needed > 0.01)
    right = np.array([quantity.value(motion) for quantity in asked])
    on_paper = frame([v.sense for v in variants], [v.turns for v in variants])
    named = tight.unnoticed(variants, asked, motion, range(40))
    for name, values in wrong_answers(variants[0].form, parameter_arrays(variants), on_paper, asked, motion).items():
        distance = distances(right, values, asked)
        for i in range(40):
            touched = np.isfinite(distance[:, i])
            # Some answer shows the mistake, and the key names it at those that do not.
            assert not touched.any() or (distance[:, i] > needed[:, i])[touched].any()
            assert [name in own for own in named[i]] == list(distance[:, i] <= needed[:, i])
    assert any(names for own in named for names in own)


def test_no_tolerance_beyond_the_ceiling_is_larger_than_the_own_steps_need(monkeypatch: pytest.MonkeyPatch) -> None:
    """Steps of another variant may lead to an answer by a triangle that is thin in this one."""
    family = restrict(load_family("four_bar"), None, None, ("crank",))
    form = family.forms["crank"]
    variants = draw(family, None, [("fewer", i) for i in range(400)], screening=AnswerTolerances())
    asked, motion = read_ask(form, ["v_B", "omega_AB", "epsilon_AB"]), solve_variants(variants, 2)
    errors = hand_errors(variants, asked, motion, range(400))
    needed = AnswerTolerances().tolerances(variants, asked, motion, range(400))
    beyond = np.flatnonzero(np.any(errors > form.screens.ceiling, axis=0)).tolist()
    assert beyond
    for i in beyond:
        form.remembered.clear()
        monkeypatch.setattr(answer_tolerances, "_models", lambda variant, asked: lambda count: [variant])
        own = hand_errors([variants[i]], asked, motion, [i])[:, 0]
        assert np.all(needed[:, i] <= np.maximum(0.01, own + 1e-3))
    assert np.max(needed) < np.max(errors)


def test_without_the_screen_of_mistakes_more_is_drawn() -> None:
    family = restrict(load_family("four_bar_with_sleeve"))
    keys = [("margins", i) for i in range(12)]
    strict = draw(family, None, keys, screening=AnswerTolerances())
    lenient = draw(family, None, keys, screening=AnswerTolerances(Tolerance(mistakes=False)))
    assert sum(v.attempt for v in lenient) < sum(v.attempt for v in strict)


def test_where_no_method_leads_to_an_answer_the_data_decide(monkeypatch: pytest.MonkeyPatch) -> None:
    def nothing(book: object) -> None:
        raise LookupError("no method")

    monkeypatch.setattr("variantgen.methods.hand.repeatable_calculation.work_out", nothing)
    family = restrict(load_family("slider_crank"), None, None, ("central",))
    variants = draw(family, ["v_A", "v_B"], [("data", i) for i in range(5)])
    asked = read_ask(variants[0].form, ["v_A", "v_B"])
    found = AnswerTolerances(Tolerance(0.001)).tolerances(variants, asked, solve_variants(variants, 1), range(5))
    # v_A = omega OA: one per cent of each datum is sqrt(2) per cent of the answer; that of v_B is not smaller.
    assert np.all(found >= 0.004 * np.sqrt(2))
    assert np.all(found < 0.2)


def test_a_tolerance_depends_on_the_variant_alone(tmp_path: Path) -> None:
    exam = read_exam(written(tmp_path, ""))
    students = [Student(f"s{i}", "", "") for i in range(6)]
    some = {sheet.student.id: sheet for sheet in drawn_sheets(replace(exam, seed="5"), students)}
    more = [Student("new", "", ""), *students[::-1]]
    for sheet in drawn_sheets(replace(exam, seed="5"), more)[1:]:
        assert sheet.items == some[sheet.student.id].items


@pytest.mark.parametrize("family", ["disc_on_arc_with_rod", "guided_plate"])
def test_a_sheet_is_the_same_in_a_class_and_alone(tmp_path: Path, family: str) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(f'title = "T"\nlanguage = "en"\n[[problem]]\nfamily = "{family}"\n', "utf-8")
    exam, students = read_exam(path), numbered(9)
    for sheet in drawn_sheets(replace(exam, seed="8"), students):
        alone = drawn_sheets(replace(read_exam(path), seed="8"), [sheet.student])[0]
        assert alone.items[0].variant.printed == sheet.items[0].variant.printed
        assert alone.items[0].answers == sheet.items[0].answers


@pytest.mark.parametrize(
    ("language", "words"),
    [("en", "Tolerance: ±1 %, where nothing else is said"), ("ru", "Допуск: ±1 %, если не указано иное")],
)
def test_key_and_manifest_have_the_tolerances(tmp_path: Path, language: str, words: str) -> None:
    exam = read_exam(written(tmp_path, "", language))
    out = tmp_path / "out"
    build(exam, numbered(8), out, "7")
    content = json.loads((out / "manifest.json").read_text("utf-8"))
    output = content["exam"]
    assert (output["tolerance"], output["tolerance_ceiling"], output["mistakes_screened"]) == (0.01, None, True)
    answers = [a for s in content["students"] for p in s["problems"] for a in p["answers"]]
    wide = [a for a in answers if a["relative_tolerance"] > 0.01]
    assert wide
    for answer in answers:
        assert 0.01 <= answer["relative_tolerance"] <= 0.03 + 1e-12
        assert answer["tolerance"] == pytest.approx(answer["relative_tolerance"] * abs(answer["value"]), rel=0.01)
    marked = [a for a in answers if "unnoticed" in a]
    assert marked
    assert any("forgotten" in name for a in marked for name in a["unnoticed"])
    rows = list(csv.DictReader(io.StringIO((out / "key.csv").read_text("utf-8-sig"))))
    assert [row["unnoticed"] for row in rows] == ["; ".join(a.get("unnoticed", [])) for a in answers]
    text = " ".join(" ".join(page_texts(out / "key.pdf")).replace("\N{NO-BREAK SPACE}", " ").split())
    assert words in text
    mark = f"±{100 * wide[0]['relative_tolerance']:.3g} %"
    assert (mark.replace(".", ",") if language == "ru" else mark) in text


def test_the_floor_is_the_least_tolerance(tmp_path: Path) -> None:
    exam = replace(read_exam(written(tmp_path, "")), tolerance=Tolerance(0.04, 0.05))
    sheets = drawn_sheets(replace(exam, seed="1"), [Student("a", "", "")])
    assert all(answer.relative_tolerance == 0.04 for item in sheets[0].items for answer in item.answers)
