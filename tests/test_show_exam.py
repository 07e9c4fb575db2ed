"""``show EXAM.toml``: the sheet that one student gets, the same as that of a build."""

from __future__ import annotations

import csv
import re

import pytest

from variantgen.cli import main

EXAM = """
title = "Homework 7"
course = "Kinematics"
language = "en"
seed = 11

[[problem]]
family = "slider_crank"
form = "central"
ask = ["v_B"]
set = { OA = 20, AB = 60 }
range = { phi = [60, 65] }
points = 10

[[problem]]
family = "rolling_wheel"
ask = ["v_A"]
"""
CLASS = "id;name;group\n7;Anna Low;A\n8;Boris High;B\n9;Clara High;B\n"


@pytest.fixture
def exam(tmp_path):
    (tmp_path / "exam.toml").write_text(EXAM, encoding="utf-8")
    (tmp_path / "class.csv").write_text(CLASS, encoding="utf-8")
    return tmp_path / "exam.toml"


def _text(capsys, *arguments: str) -> str:
    assert main(["show", *arguments]) == 0
    return re.sub(r"\s+", " ", capsys.readouterr().out)


def test_the_sheet_is_that_of_a_build(exam, tmp_path, capsys):
    """Few variants are left, so that students of the class had to draw again."""
    roster = ["--roster", str(tmp_path / "class.csv")]
    out = tmp_path / "out"
    assert main(["build", str(exam), *roster, "--out", str(out)]) == 0
    capsys.readouterr()
    with (out / "key.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    for student in ("7", "8", "9"):
        shown = _text(capsys, str(exam), *roster, "--student", student)
        own = [row for row in rows if row["id"] == student]
        assert own[0]["code"] in shown
        for row in own:
            assert f"{row['quantity']} = {float(row['value']):.4g} {row['unit']}" in shown


def test_a_seed_and_a_student_without_a_class(exam, capsys):
    first = _text(capsys, str(exam))
    assert "Homework 7 Kinematics Variant 1 · " in first
    assert "Problem 1 (10 points). Slider-crank mechanism" in first
    assert _text(capsys, str(exam), "--student", "1", "--seed", "11") == first
    assert _text(capsys, str(exam), "--seed", "12") != first
    assert "Variant 5 · " in _text(capsys, str(exam), "--student", "5")


def test_the_solutions(exam, capsys):
    found = _text(capsys, str(exam), "--explain")
    assert found.count("Answer: ") == 2
    assert "1. Geometry" in found


@pytest.mark.parametrize("ending", ["pdf", "png", "svg"])
def test_pages(ending, exam, tmp_path, capsys):
    goal = tmp_path / f"page.{ending}"
    assert main(["show", str(exam), "--out", str(goal)]) == 0
    assert goal.stat().st_size > 5000
    assert f"written: {goal}" in capsys.readouterr().err


def test_the_motion_of_a_problem(exam, tmp_path, capsys):
    """It is that of the sheet: the title and the student stand on it; another sheet moves in another way."""
    made = []
    for student in ("1", "2"):
        goal = tmp_path / f"{student}.svg"
        assert main(["show", str(exam), "--student", student, "--problem", "2", "--motion", str(goal)]) == 0
        assert capsys.readouterr().out == ""
        made.append(goal.read_bytes())
    assert made[0] != made[1]
    for wrong, said in (
        (["--problem", "3", "--motion", "x.svg"], "the sheet has problems 1 to 2"),
        (["--problem", "0", "--motion", "x.svg"], "the sheet has problems 1 to 2"),
        (["--problem", "2"], "add --motion FILE"),
    ):
        assert main(["show", str(exam), *wrong]) == 2
        assert said in capsys.readouterr().err
    assert main(["show", "rolling_wheel", "--problem", "1", "--motion", "x.svg"]) == 2
    assert "--problem" in capsys.readouterr().err


def test_a_picture_for_each_page(tmp_path, capsys):
    goal = tmp_path / "page.png"
    assert main(["show", "sample_en", "--explain", "--out", str(goal)]) == 0
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names[:2] == ["page-2.png", "page-3.png"]
    assert "page.png" in names


def test_a_part_of_a_name(exam, tmp_path, capsys):
    roster = ["--roster", str(tmp_path / "class.csv")]
    assert "Boris High · " in _text(capsys, str(exam), *roster, "--student", "boris")
    assert main(["show", str(exam), *roster, "--student", "High"]) == 2
    assert "2 students may be meant" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["sample_en", "--set", "OA=20"], "--set: has no meaning for an exam"),
        (["sample_en", "--lang", "ru"], "--lang: has no meaning for an exam"),
        (["sample_en", "--view", "velocity_plan"], "--view: has no meaning for an exam"),
        (["four_bar", "--view", "velocity_plan"], "--view: only has a meaning for a figure"),
        (["four_bar", "--notation", "alpha"], "--notation: only has a meaning for solutions"),
        (["four_bar", "--student", "7"], "--student: only has a meaning for an exam"),
        (["sample_en", "--out", "page.docx"], "unknown format"),
    ],
)
def test_wrong_options(arguments, said, capsys):
    assert main(["show", *arguments]) == 2
    assert said in capsys.readouterr().err


@pytest.mark.parametrize("option", ["--seed", "--student"])
def test_an_empty_text_is_no_value(option, capsys):
    with pytest.raises(SystemExit) as left:
        main(["show", "sample_en", option, ""])
    assert left.value.code == 2
    assert f"argument {option}: expected a text that is not empty" in capsys.readouterr().err


@pytest.mark.parametrize("command", ["list", "solve"])
def test_other_commands_say_that_it_is_an_exam(command, exam, capsys):
    for name in (str(exam), "sample_en"):
        assert main([command, name]) == 2
        said = capsys.readouterr().err
        assert said.startswith(f"variantgen: {name}: this is an exam, ")
        assert f"variantgen show {name}  or  variantgen build {name}" in said


def test_a_misspelt_exam_is_told_as_one(tmp_path, capsys):
    """Neither [[problem]] nor a language, but nothing of a mechanism either."""
    path = tmp_path / "exam.toml"
    path.write_text('title = "T"\n[[problems]]\nfamily = "four_bar"\n', encoding="utf-8")
    assert main(["show", str(path)]) == 2
    said = capsys.readouterr().err
    assert "language: missing" in said
    assert "did you mean problem?" in said
    assert main(["list", str(path)]) == 2
    assert "this is an exam" in capsys.readouterr().err


def test_a_wrong_exam_is_told_as_one(tmp_path, capsys):
    path = tmp_path / "exam.toml"
    path.write_text(EXAM.replace('"slider_crank"', '"slider_crnk"'), encoding="utf-8")
    assert main(["show", str(path)]) == 2
    assert "problem[1]" in capsys.readouterr().err
