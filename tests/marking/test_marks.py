"""The way from an exam to marks: built, handed in, marked; expected numbers are worked out here."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable, Sequence
from math import asin, cos, radians, sin
from pathlib import Path
from typing import Any

import openpyxl
import pytest

from variantgen.cli import main
from variantgen.marking.diagnosis.follow_through import FollowThrough

EXAM = """title = "Quiz"
language = "en"
formats = ["xlsx"]
seed = 4
[solutions]
depth = "none"
[[problem]]
family = "slider_crank"
form = "central"
points = 8
[[problem]]
family = "spool"
ask = ["v_O"]
"""
STUDENTS = "id,name,group\ns1,Ann Lee,A\ns2,Bob Ray,A\ns3,Cy Young,B\n"
Row = dict[str, str]
Mark = Callable[..., tuple[int, list[Row], list[Row], list[Row]]]


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("exam")
    (folder / "exam.toml").write_text(EXAM, "utf-8")
    (folder / "class.csv").write_text(STUDENTS, "utf-8")
    words = ["build", str(folder / "exam.toml"), "--roster", str(folder / "class.csv"), "--out", str(folder / "out")]
    assert main(words) == 0
    return folder / "out"


@pytest.fixture
def mark(built: Path, tmp_path: Path) -> Mark:
    def run(*files: Path, options: Sequence[str] = ()) -> tuple[int, list[Row], list[Row], list[Row]]:
        out = tmp_path / "marks"
        code = main(["mark", str(built), *map(str, files), "--out", str(out), "--force", *options])
        tables = [rows(out / name) if out.exists() else [] for name in ("marks.csv", "totals.csv", "not_matched.csv")]
        return code, tables[0], tables[1], tables[2]

    return run


def rows(path: Path) -> list[Row]:
    return list(csv.DictReader(path.read_text("utf-8-sig").splitlines()))


def key(built: Path) -> dict[tuple[str, str], float]:
    """The answers of the class by student and ``problem.quantity``."""
    return {(row["id"], f"{row['problem']}.{row['quantity']}"): float(row["value"]) for row in rows(built / "key.csv")}


def long(folder: Path, answers: Sequence[tuple[str, str, str]], name: str = "long.csv") -> Path:
    """A long table of (student, ``problem.quantity``, text)."""
    path = folder / name
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["student", "problem", "quantity", "answer"])
        writer.writerows([who, *asked.split(".", 1), text] for who, asked, text in answers)
    return path


def parameters(built: Path, place: int) -> dict[str, Any]:
    """Printed data of the slider-crank of a student, numbers as numbers."""
    problem = json.loads((built / "manifest.json").read_text("utf-8"))["students"][place]["problems"][0]
    return {
        name: float(item["value"]) if "unit" in item else item["value"] for name, item in problem["parameters"].items()
    }


def acceleration(data: dict[str, Any], normal: bool = True, rod: float = 1.0) -> float:
    """|a_B| in cm/s^2 of the central slider-crank, with or without the normal acceleration of the crank.

    ``rod`` is a factor by which omega_AB is wrong.

    Components along the rod: a_B cos psi = a_A along AB + omega_AB^2 AB, with sin psi = OA sin phi / AB.
    """
    r, l_ab, phi = data["OA"], data["AB"], radians(data["phi"])
    w = data["omega_OA"] * (1.0 if data["sense"] == "counter_clockwise" else -1.0)
    e = data["epsilon_OA"]  # counter-clockwise
    psi = asin(r * sin(phi) / l_ab)
    w_ab = -rod * r * w * cos(phi) / (l_ab * cos(psi))
    ax = -r * e * sin(phi) - (r * w**2 * cos(phi) if normal else 0.0)
    ay = r * e * cos(phi) - (r * w**2 * sin(phi) if normal else 0.0)
    return abs((ax * cos(psi) - ay * sin(psi) - w_ab**2 * l_ab) / cos(psi))


def test_the_formula_of_this_test_gives_the_key(built: Path) -> None:
    right = key(built)
    for place, student in enumerate(order(built)):
        assert acceleration(parameters(built, place)) == pytest.approx(right[student, "1.a_B"], rel=1e-6)


def order(built: Path) -> list[str]:
    return [s["id"] for s in json.loads((built / "manifest.json").read_text("utf-8"))["students"]]


def test_verdicts_and_causes(built: Path, mark: Mark, tmp_path: Path) -> None:
    right = key(built)
    first = order(built)[0]
    wrong = acceleration(parameters(built, 0), normal=False)
    handed_in = [
        (first, "1.v_B", f"{right[first, '1.v_B'] / 100:.4g} m/s"),
        (first, "1.omega_AB", f"{-right[first, '1.omega_AB']:.4g}".replace(".", ",")),
        (first, "1.a_B", f"{wrong:.4g}"),
        (first, "1.epsilon_AB", "see page 2"),
        (first, "2.v_O", f"{10 * right[first, '2.v_O']:.4g}"),
    ]
    code, marks, totals, left = mark(long(tmp_path, handed_in))
    assert code == 0
    assert [(row["where"], row["text"]) for row in left] == [("long.csv, row 5", "1.epsilon_AB: see page 2")]
    own = {f"{row['problem']}.{row['quantity']}": row for row in marks if row["id"] == first}
    assert {name: row["verdict"] for name, row in own.items()} == {
        "1.v_B": "right",
        "1.omega_AB": "wrong",
        "1.a_B": "wrong",
        "1.epsilon_AB": "unreadable",
        "2.v_O": "wrong",
    }
    assert own["1.omega_AB"]["cause"] == "sign"
    assert own["1.a_B"]["cause"] == "mistake: normal acceleration of OA forgotten"
    assert own["2.v_O"]["cause"] == "power_of_ten"
    assert float(own["1.v_B"]["value"]) == pytest.approx(right[first, "1.v_B"], rel=1e-3)
    assert (own["1.v_B"]["points"], own["1.v_B"]["of"]) == ("2", "2")  # a quarter of 8
    total = next(row for row in totals if row["id"] == first)
    assert (total["1"], total["2"], total["points"], total["of"], total["answers"]) == ("2", "0", "2", "9", "5")
    others = [row for row in marks if row["id"] != first]
    assert {row["verdict"] for row in others} == {"blank"}


@pytest.mark.parametrize(
    ("factor", "verdict", "points"),
    [(1.3, "follow_through", "2"), (0.6, "follow_through", "2"), (-1.3, "wrong", "0"), (20.0, "wrong", "0")],
)
def test_follow_through(factor: float, verdict: str, points: str, built: Path, mark: Mark, tmp_path: Path) -> None:
    """The acceleration by the student's own omega_AB; not by one with the other sense, or of another order."""
    right = key(built)
    first = order(built)[0]
    handed_in = [
        (first, "1.omega_AB", f"{factor * right[first, '1.omega_AB']:.6g}"),
        (first, "1.a_B", f"{acceleration(parameters(built, 0), rod=factor):.5g}"),
    ]
    _, marks, _, _ = mark(long(tmp_path, handed_in))
    own = {row["quantity"]: row for row in marks if row["id"] == first and row["problem"] == "1"}
    assert own["omega_AB"]["verdict"] == "wrong"
    assert (own["a_B"]["verdict"], own["a_B"]["points"]) == (verdict, points)
    if verdict == "follow_through":
        assert own["a_B"]["cause"] == "from: omega_AB"


def test_a_number_that_follows_by_no_theorem_is_wrong(built: Path, mark: Mark, tmp_path: Path) -> None:
    right = key(built)
    first = order(built)[0]
    handed_in = [
        (first, "1.omega_AB", f"{1.3 * right[first, '1.omega_AB']:.6g}"),
        (first, "1.a_B", f"{1.11 * acceleration(parameters(built, 0), rod=1.3):.5g}"),
    ]
    _, marks, _, _ = mark(long(tmp_path, handed_in))
    own = {row["quantity"]: row["verdict"] for row in marks if row["id"] == first and row["problem"] == "1"}
    assert own["a_B"] == "wrong"


def test_shares_struck_rounding_and_grades(built: Path, mark: Mark, tmp_path: Path) -> None:
    right = key(built)
    first = order(built)[0]
    handed_in = [
        (first, "1.v_B", f"{right[first, '1.v_B']:.4g}"),
        (first, "1.omega_AB", f"{-right[first, '1.omega_AB']:.4g}"),
    ]
    policy = tmp_path / "policy.toml"
    policy.write_text(
        'points = { 1 = 10 }\nshares = { sign = 0.5 }\nstruck = ["1.a_B"]\nbonus = ["2"]\n'
        "rounding = { total = 0.5 }\ngrades = { pass = 40, fail = 0 }\n",
        "utf-8",
    )
    table = long(tmp_path, handed_in)
    code, _, totals, _ = mark(table, options=["--policy", str(policy)])
    assert code == 0
    total = next(row for row in totals if row["id"] == first)
    # Three answers count, a third of 10 each: one right, one by half: 5; the bonus problem is not among the most.
    assert (total["points"], total["of"], total["grade"]) == ("5", "10", "pass")
    _, _, without, _ = mark(table)
    assert next(row for row in without if row["id"] == first)["points"] == "2"


def test_wide_tables_and_several_files_add_up(built: Path, mark: Mark, tmp_path: Path) -> None:
    right = key(built)
    first, second = order(built)[:2]
    name = {"s1": "Ann Lee", "s2": "Bob Ray", "s3": "Cy Young"}[first]
    wide = tmp_path / "wide.csv"
    wide.write_text(
        f'Name;1.v_B, cm/s;2.v_O;remark\n{name};"{right[first, "1.v_B"]:.4f}";{right[first, "2.v_O"]:.4f};late\n',
        "utf-8",
    )
    again = long(
        tmp_path, [(first, "1.v_B", "1"), (first, "1.a_B", f"{right[first, '1.a_B']:.4g}"), (second, "1.v_B", "-")]
    )
    code, marks, _, left = mark(wide, again)
    assert code == 0
    own = {f"{row['problem']}.{row['quantity']}": row["verdict"] for row in marks if row["id"] == first}
    assert own == {
        "1.v_B": "right", "1.omega_AB": "blank", "1.a_B": "right", "1.epsilon_AB": "blank", "2.v_O": "right",
    }  # fmt: skip
    told = {row["why"].split(":")[0]: row["text"] for row in left}
    assert "columns that are not used" in told
    assert any("another answer in wide.csv, row 2" in why for why in told)


def test_the_filled_form_for_marking(built: Path, mark: Mark, tmp_path: Path) -> None:
    right = key(built)
    book = openpyxl.load_workbook(built / "grading.xlsx")
    sheet = book.worksheets[0]
    head = next(row for row in sheet.iter_rows() if row[0].value == "Variant")
    columns = {cell.value: cell.column for cell in head if cell.value}
    for row in range(head[0].row + 1, sheet.max_row + 1):
        student = sheet.cell(row, 2).value
        sheet.cell(row, columns["v_B, cm/s"], right[student, "1.v_B"])
        sheet.cell(row, columns["a_B, cm/s²"], f"{right[student, '1.a_B']:.2f}".replace(".", ","))
    book.save(tmp_path / "filled.xlsx")
    code, marks, _, left = mark(tmp_path / "filled.xlsx")
    assert code == 0
    assert not left
    verdicts = {(row["id"], row["quantity"]): row["verdict"] for row in marks}
    for student in ("s1", "s2", "s3"):
        assert verdicts[student, "v_B"] == verdicts[student, "a_B"] == "right"
        assert verdicts[student, "omega_AB"] == "blank"
    points = next(column for head, column in columns.items() if head.startswith("v_B") and head.endswith("points"))
    sheet.cell(head[0].row + 1, points, 1)
    book.save(tmp_path / "over.xlsx")
    _, _, _, left = mark(tmp_path / "over.xlsx")
    assert [(row["text"], row["why"]) for row in left] == [("1: 1", "points typed over their formula are not read")]


def test_a_neighbours_variant(built: Path, mark: Mark, tmp_path: Path) -> None:
    right = key(built)
    first, second, _ = order(built)
    answers = [(first, f"1.{name}", f"{right[second, f'1.{name}']:.4g}") for name in ("v_B", "omega_AB", "a_B")]
    _, marks, _, _ = mark(long(tmp_path, answers))
    codes = {row["id"]: row["code"] for row in marks}
    causes = {row["cause"] for row in marks if row["id"] == first and row["verdict"] == "wrong"}
    assert causes == {f"neighbour: {codes[second]}"}


@pytest.fixture
def all_follow(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every wrong answer but the first of a sheet follows from the first."""
    granted = lambda _, students: [{place: [0] for place in wrong if place} for *_, wrong in students]  # noqa: E731
    monkeypatch.setattr(FollowThrough, "granted_to", granted)


@pytest.mark.usefixtures("all_follow")
@pytest.mark.parametrize("copied", [2, 3])
def test_a_neighbours_answers_follow_from_nothing(copied: int, built: Path, mark: Mark, tmp_path: Path) -> None:
    """Though each follows from the first: three are too many for chance, and of two the suspicion stays."""
    right = key(built)
    first, second, _ = order(built)
    names = ("v_B", "omega_AB", "a_B")[:copied]
    _, marks, _, _ = mark(long(tmp_path, [(first, f"1.{name}", f"{right[second, f'1.{name}']:.4g}") for name in names]))
    own = [row for row in marks if row["id"] == first and row["quantity"] in names and row["problem"] == "1"]
    assert [row["verdict"] for row in own] == (["wrong"] * 3 if copied == 3 else ["wrong", "follow_through"])
    assert all(row["cause"].startswith("neighbour: ") for row in own)


@pytest.mark.usefixtures("all_follow")
@pytest.mark.parametrize("altered", ["epsilon_AB", "a_B"])
def test_one_altered_answer_hides_no_neighbour(altered: str, built: Path, mark: Mark, tmp_path: Path) -> None:
    """Three of four are enough, and the fourth neither follows from them nor is the neighbour's; two of three not."""
    right = key(built)
    first, second, _ = order(built)
    asked = ("v_B", "omega_AB", "a_B", "epsilon_AB")
    names = asked if altered == "epsilon_AB" else asked[:3]
    values = {name: right[second, f"1.{name}"] * (1.37 if name == altered else 1.0) for name in names}
    _, marks, _, _ = mark(long(tmp_path, [(first, f"1.{name}", f"{value:.4g}") for name, value in values.items()]))
    own = [row for row in marks if row["id"] == first and row["quantity"] in names and row["problem"] == "1"]
    suspected = {row["quantity"] for row in own if row["cause"].startswith("neighbour: ")}
    assert suspected == ({"v_B", "omega_AB", "a_B"} if altered == "epsilon_AB" else set())
    assert (own[-1]["verdict"] == "wrong") == (altered == "epsilon_AB")


def test_anonymous(mark: Mark, tmp_path: Path, built: Path) -> None:
    _, marks, totals, _ = mark(long(tmp_path, [(order(built)[0], "1.v_B", "1")]), options=["--anonymous"])
    assert all(not row["id"] and not row["name"] and not row["group"] and row["code"] for row in (*marks, *totals))


@pytest.mark.parametrize(
    ("who", "asked", "said"),
    [
        ("nobody", "1.v_B", "no such student"),
        ("variantgen:1:00000000:CU6-ML5", "1.v_B", "of another exam"),
        ("s1", "7.v_B", "no such problem"),
        ("s1", "1.v_Z", "asks this student"),
    ],
)
def test_what_cannot_be_matched_is_told(who: str, asked: str, said: str, mark: Mark, tmp_path: Path) -> None:
    code, marks, _, left = mark(long(tmp_path, [(who, asked, "3")]))
    assert code == 0
    assert {row["verdict"] for row in marks} == {"blank"}
    assert len(left) == 1
    assert said in left[0]["why"]
    assert left[0]["where"] == "long.csv, row 2"


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "the table is empty"),
        (b"a,b\n1,2\n", "no table of answers"),
        (b"\x00\x01\x02", "is not a text file"),
        (b"PK\x03\x04broken", "is not a readable XLSX workbook"),
    ],
)
def test_files_that_are_no_tables(
    content: bytes, said: str, mark: Mark, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "bad.csv"
    path.write_bytes(content)
    assert mark(path)[0] == 2
    assert not (tmp_path / "marks").exists()
    err = capsys.readouterr().err
    assert said in err
    assert "bad.csv" in err


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("shares = { signs = 0.5 }", "did you mean sign"),
        ("points = { 9 = 3 }", "the problems are 1, 2"),
        ('struck = ["1.v_Z"]', "asks for no such quantity"),
        ("shares = { sign = 2 }", "expected a number from 0 to 1"),
        ("tolerence = 2", "did you mean tolerance"),
        ("tolerance = nan", "expected a finite number"),
        ("tolerance = 0", "expected a number above 0, at most 10"),
        ("shares = { sign = nan }", "expected a finite number"),
        ("points = { 1 = inf }", "expected a finite number"),
        ("rounding = { problem = 1000 }", "the step is larger than the points of every problem"),
        ("rounding = { total = 9.5 }", "the step is larger than the points of the exam"),
    ],
)
def test_wrong_policies(
    text: str, said: str, mark: Mark, tmp_path: Path, built: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    policy = tmp_path / "policy.toml"
    policy.write_text(text, "utf-8")
    answers = long(tmp_path, [("s1", "1.v_B", "3")])
    assert mark(answers, options=["--policy", str(policy)])[0] == 2
    assert said in capsys.readouterr().err


def test_a_dash_leaves_room_for_the_answer_of_another_file(built: Path, mark: Mark, tmp_path: Path) -> None:
    right, first = key(built), order(built)[0]
    dash = long(tmp_path, [(first, "1.v_B", "-")], "dash.csv")
    _, marks, _, left = mark(dash, long(tmp_path, [(first, "1.v_B", f"{right[first, '1.v_B']:.4g}")]))
    assert (left, [row["quantity"] for row in marks if row["verdict"] == "right"]) == ([], ["v_B"])


def test_a_row_with_unquoted_commas_is_not_read(built: Path, mark: Mark, tmp_path: Path) -> None:
    path = tmp_path / "commas.csv"
    path.write_text("student,problem,quantity,answer\ns1,1,v_B,47,49\n", "utf-8")
    _, marks, _, left = mark(path)
    assert {row["verdict"] for row in marks} == {"blank"}
    assert "more cells than the head" in left[0]["why"]


@pytest.mark.parametrize("quantity", ["#0", "#-1", "#abc", "9" * 5000])
def test_strange_names_of_quantities_are_told(quantity: str, mark: Mark, tmp_path: Path) -> None:
    code, marks, _, left = mark(long(tmp_path, [("s1", f"1.{quantity}", "3")]))
    assert (code, len(left)) == (0, 1)
    assert {row["verdict"] for row in marks} == {"blank"}


def test_a_part_of_a_name_names_nobody(mark: Mark, tmp_path: Path) -> None:
    _, marks, _, left = mark(long(tmp_path, [("Ann", "1.v_B", "3"), ("ann lee", "1.a_B", "3")]))
    assert [row["text"] for row in left] == ["Ann"]
    assert {row["id"] for row in marks if row["verdict"] != "blank"} == {"s1"}


def test_namesakes_are_told_apart_by_their_ids(tmp_path: Path) -> None:
    (tmp_path / "exam.toml").write_text(EXAM, "utf-8")
    (tmp_path / "class.csv").write_text("id,name\n007,Ann Lee\n008,Ann Lee\n", "utf-8")
    out = tmp_path / "out"
    assert main(["build", str(tmp_path / "exam.toml"), "--roster", str(tmp_path / "class.csv"), "--out", str(out)]) == 0
    table = tmp_path / "wide.csv"
    table.write_text("id,name,1.v_B\n007,Ann Lee,1\n008,Ann Lee,2\n,Ann Lee,3\n", "utf-8")
    assert main(["mark", str(out), str(table), "--out", str(tmp_path / "marks")]) == 0
    marks = rows(tmp_path / "marks" / "marks.csv")
    assert {row["id"]: row["answer"] for row in marks if row["answer"]} == {"007": "1", "008": "2"}
    assert [row["why"] for row in rows(tmp_path / "marks" / "not_matched.csv")] == ["2 students have this name or code"]


def test_words_that_name_a_student_are_left_out(mark: Mark, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    _, _, _, left = mark(long(tmp_path, [("Secret Person", "1.v_B", "3")]), options=["--anonymous", "--json"])
    assert left[0]["why"] == "the exam has no such student"
    assert "Secret" not in "".join(capsys.readouterr()) + str(left)


def test_points_never_exceed_what_there_is(built: Path, mark: Mark, tmp_path: Path) -> None:
    right = key(built)
    first = order(built)[0]
    policy = tmp_path / "policy.toml"
    policy.write_text("points = { 1 = 6 }\nrounding = { problem = 4 }\n", "utf-8")
    answers = [
        (first, f"1.{name}", f"{right[first, f'1.{name}']:.6g}") for name in ("v_B", "omega_AB", "a_B", "epsilon_AB")
    ]
    _, _, totals, _ = mark(long(tmp_path, answers), options=["--policy", str(policy)])
    assert next(row for row in totals if row["id"] == first)["1"] == "6"  # 8 is the nearest multiple of 4
