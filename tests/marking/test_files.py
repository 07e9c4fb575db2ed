"""What a marking hands on: gradebook files as their importers read them, the workbook, what changed."""

from __future__ import annotations

import contextlib
import csv
import re
from datetime import datetime
from pathlib import Path

import openpyxl
import pytest

from tests.marking.test_marks import Mark, built, key, long, mark, order, rows
from variantgen.cli import main

__all__ = ["built", "mark"]


def canvas(path: Path) -> dict[str, tuple[str, float | None]]:
    """What Canvas makes of a gradebook file: by SIS id the section and the score of the one assignment."""
    table = list(csv.reader(path.read_text("utf-8").splitlines()))
    head, most, *students = table
    assert "Student" in head[0]
    assert "ID" in head[1]
    assert (head[2], head[3], head[4]) == ("SIS User ID", "SIS Login ID", "Section")
    assert not re.search(r"\((\d+)\)$", head[5]), "an assignment that is there already"
    assert "Points Possible" in most[0]
    assert float(most[5]) == 9
    return {row[2]: (row[4], float(row[5]) if row[5].strip() else None) for row in students}


def moodle(path: Path) -> dict[str, float | None]:
    """What Moodle makes of a file of grades whose first column is mapped to the ID number, the last to a new item."""
    head, *students = csv.reader(path.read_text("utf-8").splitlines())
    assert (head[0], head[-1]) == ("ID number", "Quiz")
    grades = {row[0].strip(): None if row[-1].strip() == "-" else float(row[-1]) for row in students}
    assert all(grade is None or grade <= 100 for grade in grades.values()), "more than a new item holds"
    return grades


def test_gradebooks(built: Path, mark: Mark, tmp_path: Path) -> None:
    right = key(built)
    first, second, third = order(built)
    answers = [(first, "1.v_B", f"{right[first, '1.v_B']:.5g}"), (second, "1.v_B", "1")]
    mark(long(tmp_path, answers))
    out = tmp_path / "marks"
    section = {"s1": "A", "s2": "A", "s3": "B"}
    points = {first: 2.0, second: 0.0, third: None}
    assert moodle(out / "gradebook_moodle.csv") == points
    assert canvas(out / "gradebook_canvas.csv") == {who: (section[who], points[who]) for who in points}


def test_the_workbook(built: Path, mark: Mark, tmp_path: Path) -> None:
    right = key(built)
    first = order(built)[0]
    mark(long(tmp_path, [(first, "1.v_B", f"{right[first, '1.v_B']:.5g}"), (first, "2.v_O", "1e9")]))
    book = openpyxl.load_workbook(tmp_path / "marks" / "marks.xlsx")
    assert book.sheetnames == ["Sums", "A", "B", "Commonest causes", "Policy"]
    group = book["A" if first in ("s1", "s2") else "B"]
    head = [cell.value for cell in group[3]]
    own = next(row for row in group.iter_rows(min_row=4, values_only=True) if row[1] == first)
    found = dict(zip(head, own, strict=True))
    assert (found["1.v_B"], found["2.v_O"], found["1."], found["Points"], found["Most"]) == (2, 0, 2, 2, 9)
    assert found["1.a_B"] == "–"
    assert ("follow_through", 1) in [row[:2] for row in book["Policy"].iter_rows(values_only=True)]


def test_another_policy_says_whose_mark_changed(
    built: Path, mark: Mark, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A sign paid by half: two points of eight become one for the student who has it, and nobody else's change."""
    right = key(built)
    first, second, _ = order(built)
    table = long(
        tmp_path,
        [(first, "1.v_B", f"{-right[first, '1.v_B']:.5g}"), (second, "1.v_B", f"{right[second, '1.v_B']:.5g}")],
    )
    mark(table)
    policy = tmp_path / "policy.toml"
    policy.write_text("shares = { sign = 0.5 }\n", "utf-8")
    _, marks, _, _ = mark(table, options=["--policy", str(policy)])
    code = next(row["code"] for row in marks if row["id"] == first)
    assert f"{code}: 0 -> 1" in capsys.readouterr().err
    found = rows(tmp_path / "marks" / "changes.csv")
    assert [(row["id"], row["answer"], row["points before"], row["points"]) for row in found] == [
        (first, "", "0", "1"),
        (first, "1.v_B", "0", "1"),
    ]
    again = ["mark", str(built), str(table), "--out", str(tmp_path / "two"), "--against", str(tmp_path / "marks")]
    assert main(again) == 0
    assert [(row["points before"], row["points"]) for row in rows(tmp_path / "two" / "changes.csv")] == [("1", "0")] * 2


@pytest.mark.parametrize(
    ("marks", "totals"),
    [
        ("code,problem,quantity,verdict,points\nCODE,1\n", "code,grade,points\nCODE,,1\n"),
        ("code,problem,quantity,verdict,points\nCODE,1,v_B,right,2\n", "code,grade,points\nCODE\n"),
        ("code,problem,quantity,verdict,points\nXXX-XXX,1,v_B,right,2\n", "code,grade,points\nXXX-XXX,,2\n"),
    ],
)
def test_what_is_no_earlier_marking_of_the_exam(
    marks: str, totals: str, built: Path, mark: Mark, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code = rows(built / "key.csv")[0]["code"]
    (tmp_path / "marks.csv").write_text(marks.replace("CODE", code), "utf-8")
    (tmp_path / "totals.csv").write_text(totals.replace("CODE", code), "utf-8")
    assert mark(long(tmp_path, [("s1", "1.v_B", "3")]), options=["--against", str(tmp_path)])[0] == 2
    said = capsys.readouterr().err
    assert ("does not have" if "XXX" in marks else "is not the table of a marking") in said


def test_nothing_names_a_student_in_anonymous_marks(
    built: Path, mark: Mark, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """No id, name or group of the class stands in any file or message, nor a word that somebody typed for one."""
    first = order(built)[0]
    answers = long(tmp_path, [(first, "1.v_B", "1"), ("Zed Quux", "1.v_B", "2")], "of Ann.csv")
    shifted = tmp_path / "shifted.csv"
    shifted.write_text(f"student,1.v_B,2.v_O,of Zed\n{first},Ann Lee,Bob Ray\n", "utf-8")
    several = openpyxl.Workbook()
    several.active.title = "Zed"
    several.active.append(["student", "problem", "quantity", "answer"])
    several.active.append([first, "Zed Quux", "1", "v_B"])
    several.create_sheet("Cy").append(["s1", "Ann Lee", "A"])
    several.save(tmp_path / "Bob.xlsx")
    mark(answers)
    capsys.readouterr()
    mark(answers, shifted, tmp_path / "Bob.xlsx", options=["--anonymous", "--json"])
    out = tmp_path / "marks"
    texts = {path.name: path.read_text("utf-8") for path in out.rglob("*") if path.suffix in (".csv", ".html")}
    book = openpyxl.load_workbook(out / "marks.xlsx")
    texts["marks.xlsx"] = "\n".join(
        str(cell) for page in book for row in page.iter_rows(values_only=True) for cell in row
    )
    texts["messages"] = "".join(capsys.readouterr())
    assert len(texts) == 8, sorted(texts)
    for name, text in texts.items():
        assert not re.search(r"Ann|Bob|Cy|Zed|Quux|(?<!\w)s[123](?!\w)", text), name


def test_what_spreadsheets_do_to_a_form(built: Path, mark: Mark, tmp_path: Path) -> None:
    """A formula without a value and a number taken for a date are told; a correction adds to its problem."""
    right = key(built)
    book = openpyxl.load_workbook(built / "grading.xlsx")
    sheet = book.worksheets[0]
    head = next(row for row in sheet.iter_rows() if row[0].value == "Variant")
    columns = {cell.value: cell.column for cell in reversed(head) if cell.value}
    row = head[0].row + 1
    who = sheet.cell(row, 2).value
    sheet.cell(row, columns["v_B, cm/s"], right[who, "1.v_B"])
    sheet.cell(row, columns["a_B, cm/s²"], "=2*3")
    sheet.cell(row, columns["a_B, cm/s²"] + 1, datetime(1995, 2, 1, tzinfo=None))
    assert book.worksheets[1].cell(3, 2).value == who
    book.worksheets[1].cell(3, 5, 1.5)
    book.save(tmp_path / "filled.xlsx")
    code, marks, totals, left = mark(tmp_path / "filled.xlsx")
    assert code == 0
    assert [item["why"].split(":")[0] for item in left] == ["is a formula that was never computed", "is a date"]
    own = {item["quantity"]: item["verdict"] for item in marks if item["id"] == who and item["problem"] == "1"}
    assert own == {"v_B": "right", "omega_AB": "blank", "a_B": "unreadable", "epsilon_AB": "unreadable"}
    assert next(item["1"] for item in totals if item["id"] == who) == "3.5"


def test_the_heads_of_a_form_service(
    built: Path, mark: Mark, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    right, first = key(built), order(built)[0]
    name = {"s1": "Ann Lee", "s2": "Bob Ray", "s3": "Cy Young"}[first]
    table = tmp_path / "form.csv"
    table.write_text(f'Time;Your  name;Speed of B?\n12:00;{name};"{right[first, "1.v_B"]:.5g}"\n', "utf-8")
    columns = tmp_path / "columns.toml"
    columns.write_text('"Your name" = "name"\n"Speed of B?" = "1.v_B"\n', "utf-8")
    code, marks, _, _ = mark(table, options=["--columns", str(columns)])
    assert (code, [row["id"] for row in marks if row["verdict"] == "right"]) == (0, [first])
    for text, said in (
        ('"Your name" = "nam"', "expected a column"),
        ('"Name?" = "name"', "no table has such a column"),
    ):
        columns.write_text(text + "\n", "utf-8")
        assert mark(table, options=["--columns", str(columns)])[0] == 2
        assert said in capsys.readouterr().err


def test_the_unit_of_a_column(built: Path, mark: Mark, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A number has the unit of its head or of the column ``unit``, one with a unit of its own keeps it."""
    right = key(built)
    first, second, third = order(built)
    metres = {who: f"{right[who, '1.v_B'] / 100:.5g}" for who in (first, second, third)}
    wide = tmp_path / "wide.csv"
    wide.write_text(
        f"student;1.v_B (м/с)\n{first};{metres[first]}\n{second};{100 * float(metres[second])}\n"
        f"{third};{100 * float(metres[third])} cm/s\n",
        "utf-8",
    )
    _, marks, _, _ = mark(wide)
    verdicts = {row["id"]: row["verdict"] for row in marks if row["quantity"] == "v_B"}
    assert verdicts == {first: "right", second: "wrong", third: "right"}
    table = tmp_path / "long.csv"
    table.write_text(
        "student,problem,quantity,answer,unit,remark\n"
        f"{first},1,v_B,{metres[first]},m/s,late\n{second},1,v_B,{metres[second]},\n{third},1,v_B,1,furlong\n",
        "utf-8",
    )
    _, marks, _, left = mark(table)
    verdicts = {row["id"]: row["verdict"] for row in marks if row["quantity"] == "v_B"}
    assert verdicts == {first: "right", second: "wrong", third: "blank"}
    assert [(row["where"], row["text"], row["why"]) for row in left] == [
        ("long.csv, row 1", "remark", "columns that are not used"),
        ("long.csv, row 4", "furlong", "unknown unit"),
    ]
    wide.write_text(f'student,"1.v_B, knots"\n{first},1\n', "utf-8")
    assert mark(wide)[0] == 2
    assert "unknown unit (got knots)" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ("student,problem,quantity,answer,answer\ns1,1,v_B,3,4\n", "several columns hold the answer"),
        ("student,problem,quantity,value,unit,tolerance\ns1,1,v_B,3,cm/s,0.1\n", "is a key or a table of marks"),
    ],
)
def test_tables_whose_heads_are_refused(
    table: str, said: str, mark: Mark, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "table.csv").write_text(table, "utf-8")
    assert mark(tmp_path / "table.csv")[0] == 2
    assert said in capsys.readouterr().err


def test_keys_and_marks_are_no_answers(built: Path, mark: Mark, tmp_path: Path) -> None:
    mark(long(tmp_path, [("s1", "1.v_B", "3")]))
    (tmp_path / "again.csv").write_bytes((tmp_path / "marks" / "marks.csv").read_bytes())
    for table in (built / "key.csv", built / "key.xlsx", tmp_path / "again.csv"):
        assert table.is_file()
        assert mark(table)[0] == 2


def test_every_row_without_a_student_is_told(mark: Mark, tmp_path: Path) -> None:
    _, _, _, left = mark(long(tmp_path, [("", "1.v_B", "3"), ("", "1.v_B", "4"), ("s1", "1.v_B", "5")]))
    assert [row["where"] for row in left] == ["long.csv, row 2", "long.csv, row 3"]


def test_two_students_with_one_code(built: Path, mark: Mark, tmp_path: Path) -> None:
    """Another name beside a code is told and not marked; of two answers under one code the first stands."""
    right = key(built)
    (code,) = {row["code"] for row in rows(built / "key.csv") if row["id"] == "s1"}
    number = f"{right['s1', '1.v_B']:.4g}"
    table = f"code,name,1.v_B\n{code},Ann Lee,{number}\n{code},Bob Ray,9\n{code},,8\n"
    (tmp_path / "two.csv").write_text(table, "utf-8")
    _, marks, _, left = mark(tmp_path / "two.csv")
    assert [(row["id"], row["verdict"]) for row in marks if row["answer"]] == [("s1", "right")]
    assert [(row["where"], row["why"]) for row in left] == [
        ("two.csv, row 3", "the words of this row name different students"),
        ("two.csv, row 4", "the same student has another answer in two.csv, row 2, which stands"),
    ]


def test_what_breaks_off_leaves_the_marks_before(mark: Mark, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Marks are never written half: a marking that ends in the middle changes nothing and leaves nothing behind."""
    mark(long(tmp_path, [("s1", "1.v_B", "1")]))
    before = {path: path.read_bytes() for path in (tmp_path / "marks").rglob("*") if path.is_file()}

    def stopped(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("variantgen.marking.gradebooks.write_gradebooks", stopped)
    with contextlib.suppress(KeyboardInterrupt):
        mark(long(tmp_path, [("s1", "1.v_B", "2")], "other.csv"))
    assert {path: path.read_bytes() for path in (tmp_path / "marks").rglob("*") if path.is_file()} == before
    assert sorted(path.name for path in tmp_path.iterdir()) == ["long.csv", "marks", "other.csv"]


def test_columns_far_to_the_right(built: Path, mark: Mark, tmp_path: Path) -> None:
    right, first = key(built), order(built)[0]
    book = openpyxl.Workbook()
    book.active.append(["id", *(f"remark {i}" for i in range(300)), "1.v_B"])
    book.active.append([first, *[""] * 300, right[first, "1.v_B"]])
    book.save(tmp_path / "wide.xlsx")
    _, marks, _, _ = mark(tmp_path / "wide.xlsx")
    assert [row["quantity"] for row in marks if row["verdict"] == "right"] == ["v_B"]
