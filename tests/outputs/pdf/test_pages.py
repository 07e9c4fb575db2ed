"""How much paper an exam takes."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any, cast

import pypdfium2
import pytest

from variantgen.cli import main
from variantgen.outputs.typst.heights import Heights
from variantgen.outputs.typst.sheet_pages import SIZES, Filling

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


SOLVED = (
    ("en", ("four_bar", "planetary_train", "disc_on_arc_with_rod", "movable_pulley")),
    ("ru", ("three_rod_plate", "ladder", "quick_return_shaper", "gear_pair_with_crank")),
    ("en", ("guided_plate", "cam_disc", "wheel_with_rod", "plate_acceleration_centre")),
    ("ru", ("two_loop_mechanism", "point_on_rotating_disc", "spool", "sleeve_on_crank")),
)


@pytest.mark.parametrize(("language", "families"), SOLVED)
def test_no_page_of_solutions_is_less_than_half_full_but_the_last(
    language: str, families: tuple[str, ...], tmp_path: Path
) -> None:
    """Down to where there is ink, above the line of the foot."""
    exam, out = tmp_path / "exam.toml", tmp_path / "out"
    problems = "".join(f'[[problem]]\nfamily = "{family}"\n' for family in families)
    exam.write_text(f'title = "Solved"\nlanguage = "{language}"\n[solutions]\ndepth = "full"\n{problems}', "utf-8")
    assert main(["build", str(exam), "--variants", "1", "--seed", "41", "--out", str(out)]) == 0
    document = pypdfium2.PdfDocument(out / "solutions.pdf")
    try:
        filled = [ink_depth(page) for page in document]
    finally:
        document.close()
    assert len(filled) > 2
    assert [share for share in filled[:-1] if share < 0.5] == []


def ink_depth(page: pypdfium2.PdfPage) -> float:
    """How much of the height between the margins (14 mm and 16 mm) lies above the lowest ink."""
    grey = page.render(scale=0.5, grayscale=True).to_numpy().reshape(-1, round(page.get_width() * 0.5))
    body = grey[round(len(grey) * 14 / 297) : round(len(grey) * 281 / 297)]
    dark = (body < 200).any(axis=1).nonzero()[0]
    return float((dark[-1] + 1) / len(body)) if dark.size else 0.0


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


# Data that just fill their lines: where the lines are miscounted, a sheet of this class takes a page more.
def test_every_student_has_as_many_pages(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam, out = tmp_path / "exam.toml", tmp_path / "out"
    families = ("hydraulic_hoist", "disc_on_arc_with_rod", "gear_pair_with_crank", "sliding_block_on_rotating_rod")
    problems = "".join(f'[[problem]]\nfamily = "{family}"\n' for family in families)
    exam.write_text(f'title = "Plane motion of a rigid body"\nlanguage = "ru"\nseed = 503\n{problems}', "utf-8")
    assert main(["build", str(exam), "--variants", "26", "--no-solutions", "--out", str(out)]) == 0
    assert "sheets.pdf: 2 pages for each student" in capsys.readouterr().err
    assert json.loads((out / "manifest.json").read_text("utf-8"))["pages"] == {"sheets": {"2": 26}}


def problem(width: float, height: float) -> dict[str, Any]:
    """A problem with a figure of so many units, and one answer."""
    return {
        "number": "1",
        "points": "",
        "text": "",
        "asked": [],
        "letters": [],
        "signs": [],
        "given": [],
        "headings": ["v"],
        "figure": {"w": width, "h": height},
    }


class Short:
    """Statements that are lower than any figure."""

    line, given_width = 4.5, 10.0

    def of(self, request: object) -> float:
        """A height."""
        return 1.0

    def width(self, markup: object) -> float:
        """A width."""
        return 1.0


@pytest.mark.parametrize(("height", "unit", "pages"), [(100, 0.8, 1), (120, 0.68, 1), (135, 0.62, 1), (150, 0.8, 2)])
def test_figures_are_smaller_only_where_that_saves_a_page(height: int, unit: float, pages: int) -> None:
    """Two figures beside their tables and 2 × 4.5 mm (3.5 mm) of room between fit a page of 180 mm if they are lower
    than 85.5 mm (86.5 mm): 106 units of 0.8 mm, 125 of 0.68 mm, 139 of 0.62 mm.
    """
    filling = Filling(
        {"problems": [problem(50, height)] * 2, "notes": []}, [180.0, 180.0], cast(Heights, Short()), False
    )
    for size in SIZES:
        if filling.may_gain:
            filling.take(size)
    found = filling.pages()
    assert len(found) == pages
    assert {own["unit"] for page in found for own in page["problems"]} == {unit}
