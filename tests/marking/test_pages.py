"""What students get back, and the statistics of a class."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

import openpyxl
import pytest
from msgspec.structs import replace

from tests.marking.test_marks import Mark, acceleration, built, key, long, mark, order, parameters
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Answer
from variantgen.families.parameters.units import unit
from variantgen.families.quantities import split_name
from variantgen.marking.class_statistics import Advice, class_facts
from variantgen.marking.diagnosis.causes import Cause
from variantgen.marking.marks import Marked, MarkedAnswer, StudentTotal, Verdict

__all__ = ["built", "mark"]


def marked(points: list[tuple[int, int, str]]) -> Marked:
    """Marks of students with two problems of one answer each: points (0 or 1) in both, the form of the first."""
    answer = Answer(split_name("v_B"), unit("cm/s"), 10.0, 0.1)
    marks, totals = [], []
    for place, (first, second, form) in enumerate(points):
        for number, got in ((1, first), (2, second)):
            verdict = Verdict.RIGHT if got else Verdict.WRONG
            cause = None if got else Cause("sign")
            one = MarkedAnswer(place, number, form if number == 1 else "b", answer, "1", 1.0, verdict, cause)
            marks.append(replace(one, points=Fraction(got), of=Fraction(1)))
        sums = {1: Fraction(first), 2: Fraction(second)}
        totals.append(
            StudentTotal(Student(str(place), ""), f"C{place}", sums, Fraction(first + second), Fraction(2), "", 2)
        )
    return Marked(tuple(marks), tuple(totals), ())


def test_share_and_correlation_by_hand() -> None:
    facts = class_facts(marked([(1, 1, "a"), (1, 0, "a"), (0, 0, "a"), (0, 0, "a")]))
    first, second = facts.problems
    assert (first.share, second.share) == (0.5, 0.25)
    # Points 1 1 0 0 and 1 0 0 0: covariance 1/8, variances 1/4 and 3/16.
    assert first.discrimination == pytest.approx((1 / 8) / ((1 / 4) * (3 / 16)) ** 0.5)
    assert first.causes == ((Cause("sign"), 2),)
    assert facts.shares == (1.0, 0.5, 0.0, 0.0)
    assert facts.equal_forms == {}


def test_forms_that_are_not_equally_hard() -> None:
    """Six of six right against none of six: of the 924 ways to choose six of twelve two give as much."""
    facts = class_facts(marked([(1, 0, "a")] * 6 + [(0, 0, "b")] * 6))
    assert facts.equal_forms[1] == pytest.approx(2 / 924, abs=0.002)
    (uneven,) = facts.uneven
    assert (uneven.number, uneven.forms, uneven.right) == (1, ("a", "b"), ((6, 0), (0, 6)))
    assert uneven.probability == pytest.approx(2 / 924)
    sign = Cause("sign")
    assert facts.advice == (
        Advice("teach", 1, "v_B", sign),
        Advice("strike", 2, "v_B"),
        Advice("teach", 2, "v_B", sign),
    )
    same = class_facts(marked([(1, 0, "a"), (0, 0, "a"), (1, 0, "b"), (0, 0, "b")] * 3))
    assert same.equal_forms[1] == 1.0
    assert same.uneven == ()
    mirrored = class_facts(marked([(1, 0, "a")] * 6 + [(0, 0, "a")] * 6), {(place, 1) for place in range(6)})
    assert mirrored.mirrored[1] == pytest.approx(2 / 924, abs=0.002)


def test_who_handed_in_nothing_does_not_count() -> None:
    found = marked([(1, 1, "a"), (0, 0, "a")])
    absent = replace(found.totals[1], handed_in=0)
    facts = class_facts(replace(found, totals=(found.totals[0], absent)))
    assert (facts.students, facts.handed_in) == (2, 1)
    assert facts.problems[0].share == 1.0


def test_the_pages(built: Path, mark: Mark, tmp_path: Path) -> None:
    right = key(built)
    first, second, third = order(built)
    answers = [(first, f"1.{name}", f"{right[second, f'1.{name}']:.4g}") for name in ("v_B", "omega_AB", "a_B")]
    answers += [(second, "1.v_B", "<b>bold</b>"), (second, "2.v_O", f"{right[second, '2.v_O']:.4g}")]
    _, marks, _, _ = mark(long(tmp_path, answers))
    code = {row["id"]: row["code"] for row in marks}
    pages = {path.stem: path.read_text("utf-8") for path in (tmp_path / "marks" / "feedback").iterdir()}
    assert set(pages) == {code[first], code[second]}, code[third]
    assert code[second] not in pages[code[first]], "a suspicion is no feedback"
    assert "&lt;b&gt;bold&lt;/b&gt;" in pages[code[second]]
    assert "cannot be read as a number" in pages[code[second]]
    statistics = (tmp_path / "marks" / "statistics.html").read_text("utf-8")
    assert "2 / 3" in statistics
    assert all(
        "script" not in page and "http" not in re.sub(r"http-equiv|http://www.w3.org\S*", "", page)
        for page in pages.values()
    )


def test_the_steps_of_the_solution_that_are_needed(built: Path, mark: Mark, tmp_path: Path) -> None:
    """Of two wrong answers the steps in which they are found are shown, with their values; right ones need none."""
    right = key(built)
    first, second, _ = order(built)
    answers = [
        (first, "1.omega_AB", "77"),
        (first, "1.a_B", "0.77"),
        (second, "1.v_B", f"{right[second, '1.v_B']:.5g}"),
    ]
    _, marks, _, _ = mark(long(tmp_path, answers), options=["--steps"])
    code = {row["id"]: row["code"] for row in marks}
    page = (tmp_path / "marks" / "feedback" / f"{code[first]}.html").read_text("utf-8")
    steps = page.split("Worked solution, step ")[1:]
    assert [step.partition(".")[0] for step in steps] == ["2", "3"]
    for step, name in zip(steps, ("omega_AB", "a_B"), strict=True):
        assert f"<mn>{abs(right[first, f'1.{name}']):#.4g}</mn>" in step
    assert "Worked solution" not in (tmp_path / "marks" / "feedback" / f"{code[second]}.html").read_text("utf-8")


def test_causes_and_numbers_are_printed_as_in_the_table(built: Path, mark: Mark, tmp_path: Path) -> None:
    """What an answer follows from stands by its symbol, the student's own number with a true minus."""
    first = order(built)[0]
    wrong = 1.3 * key(built)[first, "1.omega_AB"]
    follows = acceleration(parameters(built, 0), rod=1.3)
    other = f"-{key(built)[first, '2.v_O']:.5g}"
    _, marks, _, _ = mark(
        long(
            tmp_path,
            [(first, "1.omega_AB", f"{wrong:.6g}"), (first, "1.a_B", f"{follows:.5g}"), (first, "2.v_O", other)],
        )
    )
    code = next(row["code"] for row in marks if row["id"] == first)
    page = (tmp_path / "marks" / "feedback" / f"{code}.html").read_text("utf-8")
    assert re.search(r"It follows from: <math.{0,80}<mi>ω</mi>", page)
    assert "omega_AB" not in page
    assert other.replace("-", "\N{MINUS SIGN}") in page
    assert other not in page


@pytest.mark.parametrize("layout", ["worksheet", "columns of the form, as in earlier versions"])
def test_points_by_hand_for_who_has_no_answers(layout: str, built: Path, mark: Mark, tmp_path: Path) -> None:
    """Corrections alone make a page; 20 points of 8 are cut and told."""
    book = openpyxl.load_workbook(built / "grading.xlsx")
    form, sheet, _ = book.worksheets
    if layout != "worksheet":
        book.remove(sheet)
        sheet = form
    head = next(row for row in sheet.iter_rows() if row[0].value == "Variant")
    column = next(cell.column for cell in head if str(cell.value).startswith("±"))
    row = head[0].row + 1
    for cells in form.iter_rows(min_row=7) if sheet is form else ():
        for cell in cells:
            if form.cell(6, cell.column).value == "±":
                cell.value = None
    codes = [sheet.cell(row + k, 1).value for k in range(2)]
    sheet.cell(row, column, 1.5)
    sheet.cell(row + 1, column, 20)
    book.save(tmp_path / "filled.xlsx")
    _, _, totals, left = mark(tmp_path / "filled.xlsx")
    assert {total["code"]: total["1"] for total in totals if total["code"] in codes} == {codes[0]: "1.5", codes[1]: "8"}
    assert [item["why"] for item in left] == ["the problem has 0 to 8 points: it cannot have 20"]
    page = (tmp_path / "marks" / "feedback" / f"{codes[0]}.html").read_text("utf-8")
    assert "Problem 1: 1.5 of 8 (+1.5 by hand)" in page


def test_anonymous_pages(built: Path, mark: Mark, tmp_path: Path) -> None:
    mark(long(tmp_path, [("s1", "1.v_B", "1")]), options=["--anonymous"])
    pages = list((tmp_path / "marks" / "feedback").iterdir())
    assert len(pages) == 1
    assert "Ann Lee" not in pages[0].read_text("utf-8")
