"""key.xlsx says what key.csv says; grading.xlsx marks right, computed by another program, also after sorting."""

from __future__ import annotations

import csv
import json
import os
import re
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path
from typing import Any

import openpyxl
import pytest
from openpyxl.worksheet.worksheet import Worksheet

from tests.outputs.formats.workbooks import Grading
from variantgen.cli import main
from variantgen.outputs.formats import options, read_exam, xlsx
from variantgen.outputs.spreadsheet import key_book, workbook_writer
from variantgen.resources import catalog_dir

ROSTER = "id;name;group\n007;Иванов Иван;М-21\n1E5;Öztürk Ann;М-22\n99;De la Cruz, Ana;М-21\n3;Ng;\n"
EXAM = """
title = "Quiz & more"
language = "{language}"
seed = 4
formats = ["xlsx"]
[[problem]]
families = ["four_bar", "falling_rod"]
points = 12
[[problem]]
family = "four_bar"
ask = ["omega_AB", "v_B.angle", "omega_AB.sense"]
[[problem]]
family = "slider_crank"
points = 10
"""
KEY, FORM = "key.xlsx", "grading.xlsx"


def build(folder: Path, exam: str, roster: str = ROSTER, *arguments: str) -> Path:
    (folder / "exam.toml").write_text(exam, "utf-8")
    (folder / "class.csv").write_text(roster, "utf-8")
    out = folder / "out"
    code = main(
        ["build", str(folder / "exam.toml"), "--roster", str(folder / "class.csv"), "--out", str(out), *arguments]
    )
    assert code == 0
    return out


@pytest.fixture(scope="module", params=["en", "ru"])
def built(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build(tmp_path_factory.mktemp(request.param), EXAM.format(language=request.param))


@pytest.fixture(scope="module")
def english(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The exam in English, for what needs time."""
    return build(tmp_path_factory.mktemp("english"), EXAM.format(language="en"))


@dataclass(frozen=True)
class Right:
    """An answer as key.csv has it."""

    code: str
    who: tuple[str, str, str]
    problem: int
    quantity: str
    value: Decimal
    tolerance: Decimal
    unnoticed: str

    @property
    def ends(self) -> tuple[Decimal, Decimal]:
        return self.value - self.tolerance, self.value + self.tolerance


def answers(out: Path) -> list[Right]:
    with (out / "key.csv").open(encoding="utf-8-sig", newline="") as file:
        return [
            Right(
                row["code"],
                (row["id"], row["name"], row["group"]),
                int(row["problem"]),
                row["quantity"],
                Decimal(row["value"]),
                Decimal(row["tolerance"]),
                row["unnoticed"],
            )
            for row in csv.DictReader(file)
        ]


def table(sheet: Worksheet, first: int) -> Iterator[list[Any]]:
    for row in sheet.iter_rows(min_row=first):
        yield [cell.value for cell in row]


# The key.


def test_the_key_has_every_answer_with_its_bounds(built: Path) -> None:
    sheet = openpyxl.load_workbook(built / KEY).worksheets[0]
    heads, *rows = table(sheet, 1)
    assert heads[:5] in (["Variant", "Id", "Name", "Group", "Problem"], ["Вариант", "Номер", "ФИО", "Группа", "Задача"])
    known = answers(built)
    assert len(rows) == len(known) == sheet.max_row - 1
    for row, right in zip(rows, known, strict=True):
        assert row[0] == right.code
        assert tuple(text or "" for text in row[1:4]) == right.who
        assert row[4] == right.problem
        assert row[7] == float(right.value)
        assert tuple(row[8:10]) == tuple(map(float, right.ends))


def test_a_direction_near_180_degrees_has_two_intervals(tmp_path: Path) -> None:
    exam = 'title = "T"\nlanguage = "en"\nformats = ["xlsx"]\n'
    exam += "tolerance = { floor = 0.1, ceiling = 0.2, mistakes = false }\n"
    exam += '[[problem]]\nfamily = "four_bar"\nask = ["v_B.angle"]\n'
    out = build(tmp_path, exam, "id,name\n" + "".join(f"{i},N{i}\n" for i in range(50)))
    heads = [cell.value for cell in openpyxl.load_workbook(out / KEY).worksheets[1][2]]
    value_column = heads.index("value")
    for sheet, first, value in zip(
        openpyxl.load_workbook(out / KEY).worksheets[:2], (2, 3), (7, value_column), strict=True
    ):
        rows = list(table(sheet, first))
        twice = 0
        for row, right in zip(rows, answers(out), strict=True):
            low, high = right.ends
            assert row[value : value + 3] == [float(x) for x in (right.value, low, high)]
            others = [float(x) for x in row[value + 3 : value + 5] if isinstance(x, float)]
            if low < -180 or high > 180:
                turn = 360 if low < -180 else -360
                assert others == [float(low + turn), float(high + turn)]
                twice += 1
            else:
                assert others == []
        assert twice > 0


def test_each_problem_has_sheets_with_a_row_for_each_student(built: Path) -> None:
    known = {(right.code, right.problem): [] for right in answers(built)}
    for right in answers(built):
        known[right.code, right.problem].append(float(right.value))
    workbook = openpyxl.load_workbook(built / KEY)
    found = {}
    for sheet in workbook.worksheets[1:-1]:
        number = int(sheet.title.split(".")[0])
        heads = [cell.value for cell in sheet[2]]
        values = [i for i, head in enumerate(heads) if head in ("value", "значение")]
        for row in table(sheet, 3):
            found[row[0], number] = [row[i] for i in values]
    assert found == known
    assert sorted({sheet.title.split(".")[0] for sheet in workbook.worksheets[1:-1]}) == ["1", "2", "3"]


def test_the_last_sheet_tells_the_work_of_everyone(built: Path) -> None:
    """As the manifest has it; above the columns of a problem stand its fewest and most calculations."""
    sheet = openpyxl.load_workbook(built / KEY).worksheets[-1]
    assert sheet.title in ("Work", "Трудоёмкость")
    recorded = {}
    for student in json.loads((built / "manifest.json").read_text("utf-8"))["students"]:
        works = [problem["work"] for problem in student["problems"]]
        sizes = [(work["operations"] + work["functions"], work["negatives"], work["obtuse"]) for work in works]
        recorded[student["code"]] = [*(number for own in sizes for number in own), sum(size for size, _, _ in sizes)]
    assert {row[0]: row[4:] for row in table(sheet, 3)} == recorded
    last = [row[6] for row in recorded.values()]
    assert sheet["K1"].value.split(": ")[1].split("–") == [str(n) for n in sorted({min(last), max(last)})]


def test_without_fair_variants_there_is_no_sheet_of_work(tmp_path: Path) -> None:
    exam = "title = 'T'\nlanguage = 'en'\nfair = false\nformats = ['xlsx']\n[[problem]]\nfamily = 'spool'\n"
    assert "Work" not in openpyxl.load_workbook(build(tmp_path, exam) / KEY).sheetnames


def shown_digits(value: float, form: str) -> int:
    decimals = len(form.split(";", maxsplit=1)[0].removesuffix('"*"').partition(".")[2])
    return len(f"{abs(value):.{decimals}f}".replace(".", "").lstrip("0"))


def test_numbers_show_four_digits_and_keep_their_value(built: Path) -> None:
    workbook = openpyxl.load_workbook(built / KEY)
    shown = []
    for sheet, first in zip(workbook.worksheets, [2] + [3] * 10, strict=False):
        for row in sheet.iter_rows(min_row=first):
            for cell in row[4:]:
                if isinstance(cell.value, float) and abs(cell.value) != 1:
                    shown.append(shown_digits(cell.value, cell.number_format))
    assert sum(digits >= 4 for digits in shown) > 0.85 * len(shown)
    assert max(shown) <= 8
    senses = [c for sheet in workbook.worksheets for row in sheet.iter_rows() for c in row if "+0" in c.number_format]
    assert senses
    assert {cell.value for cell in senses} <= {1, -1}


def test_what_an_answer_does_not_show_is_marked_and_told(tmp_path: Path) -> None:
    for language, word in (("en", "forgotten"), ("ru", "не учт")):
        folder = tmp_path / language
        folder.mkdir()
        exam = f'title = "T"\nlanguage = "{language}"\nformats = ["xlsx"]\n[[problem]]\nfamily = "slider_crank"\n'
        out = build(folder, exam, "id,name\n" + "".join(f"{i},N{i}\n" for i in range(20)))
        sheet, *others = openpyxl.load_workbook(out / KEY).worksheets
        output = ""
        for row, right in zip(sheet.iter_rows(min_row=2), answers(out), strict=True):
            assert row[7].number_format.endswith('"*"') == bool(right.unnoticed)
            said = row[-1].value or ""
            assert len(said.split("; ")) == len(right.unnoticed.split("; "))
            assert bool(said) == bool(right.unnoticed)
            output += said
        assert word in output
        if language == "ru":
            assert not re.search(r"[a-z]{4}", output), output
        stars = [c for other in others for row in other.iter_rows() for c in row if c.number_format.endswith('"*"')]
        assert len(stars) == sum(bool(right.unnoticed) for right in answers(out))


def test_sheets_are_set_up_to_be_read_and_printed(built: Path) -> None:
    for sheet in openpyxl.load_workbook(built / KEY).worksheets:
        header = 1 if sheet.title in ("Key", "Ответы") else 2
        assert sheet.freeze_panes == f"D{header + 1}"
        assert sheet.auto_filter.ref.startswith(f"A{header}:")
        assert sheet.print_title_rows.endswith(f"$1:${header}")
        assert sheet.page_setup.orientation == "landscape"
        assert (sheet.page_setup.fitToWidth or 1, sheet.page_setup.fitToHeight) == (1, 0)
        assert sheet.oddFooter.left.text.endswith(": Quiz && more")
    form = openpyxl.load_workbook(built / FORM).worksheets[0]
    assert form.freeze_panes == "D7"
    assert form.auto_filter.ref.startswith("A6:")
    assert form.print_title_cols.endswith("$A:$C")


# The form for marking.


def expected(right: Right, typed: Decimal) -> bool:
    """Whether an answer is right, in decimal numbers."""
    off = abs(typed - right.value)
    if right.quantity.endswith(".angle"):
        off = abs((off + 180) % 360 - 180)
    return off <= right.tolerance


# Ways to be right or wrong; each row of the form is filled in another way.
WAYS = [
    lambda r: r.value,
    lambda r: r.ends[0],
    lambda r: r.ends[1],
    lambda r: r.ends[0] - Decimal("1e-6"),
    lambda r: r.ends[1] + Decimal("1e-6"),
    lambda r: -r.value,
    lambda r: r.value + 360,
    lambda r: r.ends[0] - 360,
    lambda r: r.ends[1] + 720,
    lambda r: r.ends[1] + 360 + Decimal("1e-6"),
    lambda r: Decimal("9e11"),
]


def test_marks_of_right_and_wrong_answers(tmp_path: Path) -> None:
    exam = "title = 'T'\nlanguage = 'ru'\nformats = ['xlsx']\n"
    exam += "[[problem]]\nfamily = 'four_bar'\nask = ['omega_AB', 'v_B.angle', 'omega_AB.sense']\n"
    roster = "id,name\n" + "".join(f"{i},N{i}\n" for i in range(2 * len(WAYS)))
    out = build(tmp_path, exam, roster)
    grading, known = Grading(out / FORM), answers(out)
    columns = []
    for row in grading.rows:
        number = row % len(WAYS)
        for right, typed, points in owned(grading, row, known):
            text = f"{WAYS[number](right):f}"  # with either decimal mark, by rows
            grading.sheet.cell(row, typed).value = text.replace(".", ",") if row % 2 else text
            assert grading.sheet.cell(row, typed).number_format == "@"  # 2.95 is no date here
            columns.append((number, right, row, points))
    found = grading.computed()
    seen = set()
    for number, right, row, points in columns:
        good = expected(right, WAYS[number](right))
        assert (found(row, points) > 0) == good, (right, WAYS[number](right))
        seen.add((number, right.quantity.endswith(".angle"), good))
    assert {(6, True, True), (7, True, True), (8, True, True), (9, True, False), (5, False, False)} <= seen
    assert {good for number, _, good in seen if number in (3, 4, 10)} == {False}
    assert {good for number, _, good in seen if number in (0, 1, 2)} == {True}


def owned(grading: Grading, row: int, known: list[Right]) -> Iterator[tuple[Right, int, int]]:
    """The answers of the student in a row, with the columns where they are typed and marked."""
    for number, problem in enumerate(grading.problems(), start=1):
        own = [right for right in known if right.code == grading.code(row) and right.problem == number]
        yield from zip(own, problem.typed, problem.points, strict=False)


def test_points_sums_and_percent(english: Path) -> None:
    grading, known = Grading(english / FORM), answers(english)
    sheet, problems = grading.sheet, grading.problems()
    own = {row: list(owned(grading, row, known)) for row in grading.rows}
    assert {sum(right.problem == 1 for right, *_ in cells) for cells in own.values()} == {4, 6}
    for row, cells in own.items():
        for right, typed, _ in cells:
            sheet.cell(row, typed).value = float(right.value)
    found = grading.computed()
    assert found.row(4, grading.sums()) == [12, 3, 10]
    for row in grading.rows:
        assert found.row(row, grading.sums()) == [12, 3, 10]
        assert found(row, 5) == 25
        assert found(row, 6) == 1
    # The first answer wrong, the second no number, the third left out; half a point given by hand; other points.
    last = problems[2]
    for row in grading.rows:
        for column, value in zip(last.typed, (1e9, "about 3", None), strict=False):
            sheet.cell(row, column).value = value
        grading.correct(grading.code(row), 3, 0.5)
    assert [cell.value for cell in grading.points_of_answers()] == [2] * 6 + [1] * 3 + [2.5] * 4
    grading.points_of_answers()[-1].value = 7
    found = grading.computed("changed")
    for row in grading.rows:
        assert found.row(row, last.points) == [0, "?", "", 7]
        assert (found(row, last.correction), found(row, problems[0].correction)) == (0.5, "")
        assert found(row, 9) == 7.5
        assert found(row, 5) == 22.5
        assert found(row, 6) == pytest.approx(22.5 / (12 + 3 + 14.5))


def test_an_empty_form_is_blank(english: Path) -> None:
    grading = Grading(english / FORM)
    found = grading.computed()
    points = [column for problem in grading.problems() for column in problem.points]
    for row in grading.rows:
        assert {found(row, column) for column in (5, 6, *grading.sums())} == {""}
        assert {found.cells.get(cell.coordinate, "") for cell in grading.sheet[row] if cell.column in points} == {""}
    # What programs show that do not compute: points of problems, nothing else.
    shown = openpyxl.load_workbook(english / FORM, data_only=True).worksheets[0]
    assert [shown.cell(4, column).value for column in (5, *grading.sums())] == [25, 12, 3, 10]
    assert all(shown.cell(row, column).value is None for row in grading.rows for column in (5, 6, *points))


def test_sorted_rows_keep_their_points(english: Path) -> None:
    grading, known = Grading(english / FORM), answers(english)
    for row in grading.rows:
        for right, typed, _ in owned(grading, row, known):
            wrong = (row + typed) % 3 == 0
            grading.sheet.cell(row, typed).value = float(right.value) * (1.5 if wrong else 1)

    def results(name: str) -> dict[str, list[str]]:
        found = grading.computed(name)
        columns = range(2, grading.sheet.max_column)  # but for the place among the answers, which stays
        return {
            grading.code(row): [str(found.cells.get(grading.sheet.cell(row, column).coordinate)) for column in columns]
            for row in grading.rows
        }

    for number, row in enumerate(grading.rows):
        grading.correct(grading.code(row), 2, number + 0.25)
    before = results("before")
    column = grading.problems()[1].correction
    assert [before[grading.code(row)][column - 2] for row in grading.rows] == ["0.25", "1.25", "2.25", "3.25"]
    assert len({tuple(cells[3:]) for cells in before.values()}) == len(before)
    grading.permute(dict(zip(grading.rows, reversed(grading.rows), strict=True)))
    first, second = ([cell.value for cell in grading.corrections[row]] for row in (3, 4))
    for row, values in ((3, second), (4, first)):  # that worksheet may be sorted too
        for k, value in enumerate(values, start=1):
            grading.corrections.cell(row, k).value = value
    after = results("after")
    assert list(after) == [*reversed(before)]
    assert after == before


def test_only_what_is_to_be_filled_in_is_open(built: Path) -> None:
    grading = Grading(built / FORM)
    assert all(sheet.protection.sheet and not sheet.protection.password for sheet in grading.book.worksheets)
    asked = {}
    for right in answers(built):
        asked[right.code, right.problem] = asked.get((right.code, right.problem), 0) + 1
    open_cells = set()
    for number, problem in enumerate(grading.problems(), start=1):
        for row in grading.rows:
            count = asked[grading.code(row), number]
            open_cells |= {(row, column) for column in problem.typed[:count]}
            for column in (*problem.typed[count:], *problem.points[count:]):
                cell = grading.sheet.cell(row, column)
                assert (cell.value, cell.fill.fgColor.rgb) == (None, "FFD0D3D8")
    # Answers are text; points are numbers, of each student in each of three problems and of each answer in row 3.
    corrections = {(row, column) for row in range(3, 7) for column in (5, 6, 7)}
    points = {(3, 5 + 3 * number) for number in range(13)}
    for sheet, cells, kind in (
        (grading.sheet, open_cells, "custom"),
        (grading.corrections, corrections, "decimal"),
        (grading.answers, points, "decimal"),
    ):
        assert {(c.row, c.column) for row in sheet.iter_rows() for c in row if not c.protection.locked} == cells
        checks = sheet.data_validations.dataValidation
        assert {(c.type, c.operator or "between", c.showErrorMessage) for c in checks} == {(kind, "between", True)}
        for check in checks:
            assert check.formula1.startswith("ISNUMBER(VALUE(" if kind == "custom" else "-1000")
            assert check.formula2 == (None if kind == "custom" else "1000")  # less than any date of today
        areas = [area for check in checks for area in check.sqref.ranges]
        for row, column in cells:
            assert any(a.min_row <= row <= a.max_row and a.min_col <= column <= a.max_col for a in areas)


def test_the_answers_of_the_form_are_those_of_the_key(built: Path) -> None:
    sheet = openpyxl.load_workbook(built / FORM).worksheets[-1]
    known = answers(built)
    for row in table(sheet, 5):
        numbers = [cell for cell in row[4:] if cell is not None]
        own = [right for right in known if right.code == row[0]]
        assert numbers == [float(x) for right in own for x in (right.value, *right.ends)]
    assert sheet.max_row == 4 + 4


# Text from outside.

HOSTILE = [
    '=HYPERLINK("http://x","y")',
    "=cmd|' /C calc'!A0",
    "+1",
    "-1+1",
    "@SUM(A1)",
    "＝1+1",
    "<r><t>bold</t></r>",
    "<r></r>",
    "</t></is></c><c r=\"A1\"><f>1</f></c>",
    "_x0041_ _x000D_",
    "{=1}",
    "http://example.org",
    "  spaced  out  ",
    "x" * 5000,
]  # fmt: skip


@pytest.mark.parametrize("students", [1000, 2])
def test_text_is_text(students: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workbook_writer, "_MANY_STUDENTS", students)
    rows = [[f"{text}", text, text] for text in HOSTILE]
    with (tmp_path / "roster.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([["id", "name", "group"], *rows])
    roster = (tmp_path / "roster.csv").read_text("utf-8")
    title = "=1+1 &L&D [x]:*?/\\"
    exam = f"title = '{title}'\nlanguage = 'en'\nsort = 'roster'\nformats = ['xlsx']\n[[problem]]\nfamily = 'spool'\n"
    out = build(tmp_path, exam, roster)
    for name in (KEY, FORM):
        workbook = openpyxl.load_workbook(out / name)
        assert workbook.properties.title.endswith(title)
        sheet = workbook.worksheets[-1]
        first = 3 if name == KEY else 5
        for row, text in zip(sheet.iter_rows(min_row=first), HOSTILE, strict=True):
            for cell in row[1:4]:
                assert cell.data_type in ("s", "inlineStr")
                assert cell.hyperlink is None
                assert unescaped(cell.value, students == 2) == text.strip()
        with zipfile.ZipFile(out / name) as archive:
            for part in archive.namelist():
                content = archive.read(part).decode()
                formulas = re.findall(r"<f>(.*?)</f>", content)
                assert "<hyperlink" not in content
                assert all(re.match(r"(IF|MATCH|ROUND|MID)\(|'Answers'!\$[A-Z]+\$3$", formula) for formula in formulas)
                assert not any("calc" in formula or "HYPER" in formula or formula == "1" for formula in formulas)
                assert bool(formulas) == (name == FORM and part == "xl/worksheets/sheet1.xml")
                assert ("<is>" in content) == (students == 2 and part.startswith("xl/worksheets/"))


def unescaped(text: str, inline: bool) -> str:
    """Text with what the format writes as numbers (ECMA-376, ST_Xstring), so far as openpyxl leaves it."""
    pattern = "_x([0-9A-F]{4})_" if inline else "_x(FFFF)_"
    return re.sub(pattern, lambda match: chr(int(match[1], 16)), text)


TITLE = "title = { en = '=[a]:*?/\\b <c> & \"d\" and much more than fits there' }"


def test_titles_of_sheets(tmp_path: Path) -> None:
    family = tmp_path / "families" / "mine"
    family.mkdir(parents=True)
    for path in (catalog_dir() / "spool").iterdir():
        text = path.read_text("utf-8")
        if path.name == "family.toml":
            text = re.sub(r"(?m)^title = .*", lambda _: TITLE, text)
        (family / path.name).write_text(text, "utf-8")
    problem = "[[problem]]\nfamilies = ['mine', 'spool']\n"
    exam = f"title = 'T'\nlanguage = 'en'\nformats = ['xlsx']\n{problem}{problem}"
    out = build(
        tmp_path, exam, ROSTER + "".join(f"n{i};N;\n" for i in range(12)), "--families", str(tmp_path / "families")
    )
    names = openpyxl.load_workbook(out / KEY).sheetnames
    assert len(names) == len({name.casefold() for name in names}) == 6
    assert all(len(name) <= 31 and not set(name) & set("[]:*?/\\") for name in names)
    assert names[0] == "Key"
    assert any(name.startswith("1. =") for name in names)
    assert openpyxl.load_workbook(out / FORM).sheetnames == ["Marking", "Corrections", "Answers"]


@pytest.mark.parametrize(
    ("text", "taken", "title"),
    [
        ("1. Four-bar linkage", (), "1. Four-bar linkage"),
        ("1. " + "x" * 40, (), "1. " + "x" * 27 + "…"),
        ("1. " + "\U0001f600" * 40, (), "1. " + "\U0001f600" * 13 + "…"),
        ("'a'", (), "a"),
        ("a/b", ("a b",), "a b (2)"),
        ("X" * 31, ("x" * 31,), "X" * 26 + "… (2)"),
    ],
)
def test_title_of_a_sheet(text: str, taken: tuple[str, ...], title: str) -> None:
    found = workbook_writer.sheet_title(text, taken)
    assert found == title
    assert len(found.encode("utf-16-le")) <= 62


# Files.


def cells(path: Path) -> list[list[list[tuple[Any, str]]]]:
    workbook = openpyxl.load_workbook(path)
    return [[[(c.value, c.number_format) for c in row] for row in s.iter_rows()] for s in workbook.worksheets]


def test_large_classes_have_the_same_cells(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    outs = []
    for name, many in (("small", 4), ("large", 3)):
        monkeypatch.setattr(workbook_writer, "_MANY_STUDENTS", many)
        (tmp_path / name).mkdir()
        outs.append(build(tmp_path / name, EXAM.format(language="ru")))
        for path in (KEY, FORM):
            with zipfile.ZipFile(outs[-1] / path) as archive:
                assert ("xl/sharedStrings.xml" in archive.namelist()) == (name == "small")
    for path in (KEY, FORM):
        assert cells(outs[0] / path) == cells(outs[1] / path)
    assert {path.name for path in outs[1].iterdir()} == {KEY, FORM, "key.csv", "manifest.json"}


def test_a_key_of_too_many_rows_goes_on_another_sheet(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(key_book, "MOST_ROWS", 20)
    out = build(tmp_path, EXAM.format(language="en"))
    workbook = openpyxl.load_workbook(out / KEY)
    pages = [sheet for sheet in workbook.worksheets if sheet.title.startswith("Key")]
    assert [sheet.title for sheet in pages] == ["Key", "Key 2", "Key 3"][: len(pages)]
    rows = [row for sheet in pages for row in table(sheet, 2)]
    assert [row[7] for row in rows] == [float(right.value) for right in answers(out)]
    assert max(sheet.max_row for sheet in pages) == 21


def test_the_same_bytes_every_time(tmp_path: Path) -> None:
    (tmp_path / "exam.toml").write_text(EXAM.format(language="ru"), "utf-8")
    (tmp_path / "class.csv").write_text(ROSTER, "utf-8")
    found = []
    for name, environment in (
        ("one", {"PYTHONHASHSEED": "1", "TZ": "Asia/Tokyo", "LC_ALL": "C"}),
        ("two", {"PYTHONHASHSEED": "2", "TZ": "America/Los_Angeles"}),
    ):
        command = [sys.executable, "-m", "variantgen", "build", "exam.toml", "--roster", "class.csv", "--out", name]
        subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, env={**os.environ, **environment})
        found.append({path: (tmp_path / name / path).read_bytes() for path in (KEY, FORM, "key.csv")})
    assert found[0] == found[1]


# Options and tools.


def test_protection_can_be_left_out(tmp_path: Path) -> None:
    out = build(tmp_path, EXAM.format(language="en") + "[xlsx]\nprotect = false\n")
    assert not any(sheet.protection.sheet for sheet in openpyxl.load_workbook(out / FORM).worksheets)


@pytest.mark.parametrize(
    ("line", "said"), [("protected = true", "did you mean protect"), ('protect = "yes"', "expected true or false")]
)
def test_wrong_options(line: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(EXAM.format(language="en") + f"[xlsx]\n{line}\n", "utf-8")
    assert main(["build", str(path), "--variants", "1", "--out", str(tmp_path / "out")]) == 2
    message = capsys.readouterr().err
    assert "xlsx.protect" in message
    assert said in message
    assert not (tmp_path / "out").exists()


def test_without_the_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(xlsx, "find_spec", lambda name: None)
    (tmp_path / "exam.toml").write_text(EXAM.format(language="en"), "utf-8")
    assert options(read_exam(tmp_path / "exam.toml"), "xlsx") == xlsx.XlsxOptions(protect=True)
    assert main(["build", str(tmp_path / "exam.toml"), "--variants", "1", "--out", str(tmp_path / "out")]) == 3
    assert 'pip install ".[xlsx]"' in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
