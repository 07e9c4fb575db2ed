"""The option ``nice`` from the exam file to the key."""

from __future__ import annotations

import csv
import io
import json
from fractions import Fraction
from math import sqrt
from pathlib import Path

import pytest
from msgspec.structs import replace

from benchmarks.sheets import drawn_sheets
from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.exam.exam_file import read_exam
from variantgen.exam.roster import numbered

PROBLEM = '[[problem]]\nfamily = "ladder"\nform = "driven_at_wall"\nask = ["v_B", "omega_AB"]\n'
HEAD = 'title = "Quiz"\nlanguage = "ru"\n'


def written(folder: Path, content: str) -> Path:
    path = folder / "exam.toml"
    path.write_text(content, "utf-8")
    return path


def test_problems_with_and_without(tmp_path: Path) -> None:
    exam = read_exam(written(tmp_path, HEAD + PROBLEM + "nice = true\n" + PROBLEM))
    assert [task.nice for task in exam.tasks] == [True, False]
    sheets = drawn_sheets(replace(exam, seed="1"), numbered(20))
    angles = [[float(item.variant.printed["phi"]) for item in sheet.items] for sheet in sheets]
    assert {first for first, _ in angles} == {30, 45, 60}
    assert len({second for _, second in angles}) > 5
    # v_B = v_A tan(phi): sqrt(3)/3, 1 or sqrt(3) times the given velocity.
    for sheet in sheets:
        variant, (answer, _) = sheet.items[0].variant, sheet.items[0].answers
        factor = {30: 1 / sqrt(3), 45: 1.0, 60: sqrt(3)}[int(variant.printed["phi"])]
        assert answer.value == pytest.approx(float(variant.printed["v_A"]) * factor, rel=1e-7)
        # Roots have denominators up to 4: 2 / sqrt(3) has one, 5.5 / sqrt(3) = 11 sqrt(3) / 6 none.
        share = Fraction(variant.printed["v_A"]) / (3 if factor < 1 else 1)
        assert (answer.surd is not None) == (factor != 1.0 and share.denominator <= 4)


def test_a_problem_without_nice_is_not_changed_by_one_with(tmp_path: Path) -> None:
    students = numbered(12)
    one = drawn_sheets(replace(read_exam(written(tmp_path, HEAD + PROBLEM)), seed="1"), students)
    two = drawn_sheets(
        replace(read_exam(written(tmp_path, HEAD + PROBLEM + PROBLEM + "nice = true\n")), seed="1"), students
    )
    assert [s.items[0].variant.printed for s in one] == [s.items[0].variant.printed for s in two]


def test_key_and_manifest(tmp_path: Path) -> None:
    out = tmp_path / "out"
    text = HEAD + PROBLEM + "nice = true\nset = { phi = 30, v_A = 5 }\n" + PROBLEM
    assert main(["build", str(written(tmp_path, text)), "--variants", "3", "--out", str(out)]) == 0
    record = json.loads((out / "manifest.json").read_text("utf-8"))
    assert all([problem.get("nice") for problem in s["problems"]] == [True, None] for s in record["students"])
    (first, *_) = [p for p in record["students"][0]["problems"] if p["problem"] == 1]
    assert first["answers"][0]["value"] == pytest.approx(5 / sqrt(3), rel=1e-7)
    rows = list(csv.DictReader(io.StringIO((out / "key.csv").read_text("utf-8-sig"))))
    assert {row["value"] for row in rows if row["problem"] == "1" and row["quantity"] == "v_B"} == {"2.8867513"}
    by_student, *_ = page_texts(out / "key.pdf")
    assert "≈ 2,887" in by_student
    assert by_student.count("√") >= 3
    tables = "".join(page_texts(out / "key.pdf")[1:])
    assert "2,887" in tables
    assert "√" not in tables


@pytest.mark.parametrize(
    ("problem", "said"),
    [
        (PROBLEM + 'nice = "yes"\n', ["problem[1].nice", "true or false", "yes"]),
        ('[[problem]]\nfamily = "guided_plate"\nnice = true\n', ["problem[1].nice", "guided_plate", "leave nice out"]),
        (
            '[[problem]]\nfamily = "wheel_with_rod"\nform = "driven_by_slider"\nnice = true\n',
            ["problem[1].nice", "no hand-friendly variants", "another form or family"],
        ),
        (
            '[[problem]]\nfamily = "arc_yoke"\nset = { OA = 21 }\nnice = true\n',
            ["problem[1].nice", "has these values", "leave one of OA, DA, phi free"],
        ),
        (
            '[[problem]]\nfamily = "slider_crank"\nform = "central"\nrange = { phi = [65, 80] }\nnice = true\n',
            ["problem[1].range.phi", "the family draws 60, 120 deg"],
        ),
        (
            '[[problem]]\nfamily = "cam_disc"\nform = "roller"\nset = { R = 30, OC = 17, phi = 50 }\nnice = true\n',
            ["problem[1]: cam_disc/roller", "hand-friendly answers", "leave nice out"],
        ),
    ],
)
def test_what_cannot_be_is_told(
    problem: str, said: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, out = written(tmp_path, HEAD + problem), tmp_path / "out"
    assert main(["build", str(path), "--variants", "2", "--out", str(out)]) == 2
    message = capsys.readouterr().err
    assert not out.exists()
    for word in [str(path), *said]:
        assert word in message, message
