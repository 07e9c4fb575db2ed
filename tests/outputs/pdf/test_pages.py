"""How much paper an exam takes."""

from __future__ import annotations

import re
from pathlib import Path

import pypdfium2
import pytest

from variantgen.cli import main

# Statements and figures of these are among the largest: with figures of full size they take three pages and a blank.
FAMILIES = ("four_bar", "spool", "guided_plate", "movable_pulley", "slider_crank_with_second_rod")
STUDENTS = 108


def test_five_problems_for_a_class_take_a_leaf_each(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam, out = tmp_path / "exam.toml", tmp_path / "out"
    problems = "".join(f'[[problem]]\nfamily = "{family}"\n' for family in FAMILIES)
    exam.write_text(f'title = "Plane motion of a rigid body"\nlanguage = "en"\n{problems}', "utf-8")
    assert main(["build", str(exam), "--variants", str(STUDENTS), "--no-solutions", "--out", str(out)]) == 0
    assert "sheets.pdf: 2 pages for each student" in capsys.readouterr().err
    document = pypdfium2.PdfDocument(out / "sheets.pdf")
    try:
        texts = [page.get_textpage().get_text_bounded() for page in document]
    finally:
        document.close()
    assert len(texts) == 2 * STUDENTS
    for first, second in zip(texts[::2], texts[1::2], strict=True):
        assert [f"Problem {number}" in first + second for number in range(1, 6)] == [True] * 5
        assert "Problem 1 " in first
        assert "Problem 5 " in second


@pytest.mark.parametrize("name", ["sample_en", "sample_ru"])
def test_solutions_of_five_problems_take_seven_pages(name: str, tmp_path: Path) -> None:
    out = tmp_path / "out"
    for seed in ("2026", "31"):
        assert main(["build", name, "--variants", "1", "--seed", seed, "--out", str(out), "--force"]) == 0
        document = pypdfium2.PdfDocument(out / "solutions.pdf")
        try:
            assert len(document) <= 7
        finally:
            document.close()


# High and low in turn: in this order two do not fit on the first page, and one by one they take a page more.
TURNS = (
    "movable_pulley",
    "slider_crank",
    "movable_pulley",
    "slider_crank",
    "guided_plate",
    "guided_plate",
    "slider_crank",
)


@pytest.mark.parametrize("reorder", [False, True])
def test_order_of_problems(reorder: bool, tmp_path: Path) -> None:
    exam, out = tmp_path / "exam.toml", tmp_path / "out"
    head = f'title = "Order"\nlanguage = "en"\n[page]\nreorder = {str(reorder).lower()}\n'
    exam.write_text(head + "".join(f'[[problem]]\nfamily = "{family}"\n' for family in TURNS), "utf-8")
    assert main(["build", str(exam), "--variants", "8", "--no-solutions", "--out", str(out)]) == 0
    document = pypdfium2.PdfDocument(out / "sheets.pdf")
    try:
        text = "".join(page.get_textpage().get_text_bounded() for page in document)
    finally:
        document.close()
    numbers = [int(number) for number in re.findall(r"Problem (\d) ", text)]
    assert sorted(numbers) == sorted([*range(1, 8)] * 8)
    assert (numbers == [*range(1, 8)] * 8) != reorder
