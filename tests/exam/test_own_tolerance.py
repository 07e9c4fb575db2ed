"""A problem with a tolerance of its own: other marks, the same data."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from msgspec.structs import replace

from benchmarks.sheets import drawn_sheets
from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.exam.exam import Exam
from variantgen.exam.roster import numbered
from variantgen.exam.sections.tolerance import Tolerance
from variantgen.exam.sheets import Sheet
from variantgen.outputs.formats import read_exam

HEAD = 'title = "Quiz"\nlanguage = "en"\nformats = ["pdf"]\n{top}\n[solutions]\ndepth = "none"\n'
FOUR_BAR = '[[problem]]\nfamily = "four_bar"\nform = "crank"\nask = ["v_B", "omega_AB.sense"]\n{own}\n'


def exam_file(folder: Path, top: str, *own: str) -> Path:
    path = folder / "exam.toml"
    path.write_text(HEAD.format(top=top) + "".join(FOUR_BAR.format(own=one) for one in own), "utf-8")
    return path


def exam(folder: Path, top: str, *own: str) -> Exam:
    return read_exam(exam_file(folder, top, *own))


def sheets(found: Exam) -> tuple[Sheet, ...]:
    return drawn_sheets(replace(found, seed="3"), numbered(20))


def test_each_problem_is_marked_by_its_own(tmp_path: Path) -> None:
    found = exam(tmp_path, "tolerance = 0.04", "", "tolerance = 0.1", "tolerance = 0.015")
    for sheet in sheets(found):
        speeds = [item.answers[0] for item in sheet.items]
        assert [answer.relative_tolerance for answer in speeds][:2] == [0.04, 0.1]
        # What rounding needs may be more than 1.5 %.
        assert 0.015 <= speeds[2].relative_tolerance <= 0.03
        for answer in speeds:  # rounded to three digits
            assert answer.tolerance == pytest.approx(answer.relative_tolerance * abs(answer.value), rel=5e-3)
        assert all(item.answers[1].tolerance == 0 for item in sheet.items)


def test_data_do_not_depend_on_it(tmp_path: Path) -> None:
    usual, other = (sheets(exam(tmp_path, "", "", own)) for own in ("", "tolerance = 0.1"))
    for one, two in zip(usual, other, strict=True):
        assert [item.variant.printed for item in one.items] == [item.variant.printed for item in two.items]
        assert [item.answers[0].value for item in one.items] == [item.answers[0].value for item in two.items]
        assert one.items[1].answers[0].relative_tolerance < two.items[1].answers[0].relative_tolerance == 0.1


@pytest.mark.parametrize(
    ("top", "own", "wanted"),
    [
        ("tolerance = 0.02", "", Tolerance(0.02)),
        ("tolerance = 0.02", "tolerance = 0.05", Tolerance(0.05)),
        ("tolerance = { floor = 0.02, mistakes = false }", "tolerance = 0.05", Tolerance(0.05, None, False)),
        ("tolerance = { floor = 0.02, ceiling = 0.03 }", "tolerance = 0.05", Tolerance(0.05, 0.05)),
        ("tolerance = { floor = 0.02, ceiling = 0.03 }", "tolerance = { floor = 0.01 }", Tolerance(0.01, 0.03)),
        ("tolerance = 0.02", "tolerance = { ceiling = 0.04 }", Tolerance(0.02, 0.04)),
    ],
)
def test_what_is_not_said_is_that_of_the_exam(top: str, own: str, wanted: Tolerance, tmp_path: Path) -> None:
    found = exam(tmp_path, top, own)
    assert found.tolerance_of(found.tasks[0]) == wanted


def test_a_ceiling_of_one_problem_leaves_the_others_alone(tmp_path: Path) -> None:
    free, cut = (sheets(exam(tmp_path, "", own, "")) for own in ("", "tolerance = { floor = 0.005, ceiling = 0.01 }"))
    assert [s.items[1].variant.printed for s in free] == [s.items[1].variant.printed for s in cut]
    assert all(s.items[0].answers[0].relative_tolerance <= 0.01 for s in cut)
    assert any(s.items[0].answers[0].relative_tolerance > 0.01 for s in free)


@pytest.mark.parametrize(
    ("own", "said"),
    [
        ("tolerance = 0", "problem[1].tolerance: expected a number between 0 and 0.2"),
        ('tolerance = "2 %"', "problem[1].tolerance: expected a number or a table"),
        ("tolerance = { floor = 0.05, ceiling = 0.01 }", "problem[1].tolerance.ceiling: expected a number between"),
        ("tolerance = { flor = 0.05 }", "problem[1].tolerance.flor: unknown key"),
    ],
)
def test_mistakes(own: str, said: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as error:
        exam(tmp_path, "", own)
    assert said in str(error.value)


def test_the_key_says_where_a_tolerance_differs(tmp_path: Path) -> None:
    """A narrower one too: the key would say 4 % of it otherwise."""
    path, out = exam_file(tmp_path, "tolerance = 0.04", "", "tolerance = 0.1", "tolerance = 0.031"), tmp_path / "out"
    assert main(["build", str(path), "--variants", "2", "--out", str(out)]) == 0
    said = "".join(page_texts(out / "key.pdf"))
    assert "Tolerance: ±4" in said
    assert said.count("±10") == said.count("±3.1") == 4  # by student and by problem
    with (out / "key.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["quantity"] == "v_B"]
    parts = [float(row["tolerance"]) / abs(float(row["value"])) for row in rows]
    assert parts == pytest.approx([0.04, 0.1, 0.031] * 2, rel=5e-3)
    assert main(["verify", str(out)]) == 0
