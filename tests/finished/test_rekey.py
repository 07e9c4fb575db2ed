"""``rekey``: another tolerance for sheets that are printed already."""

from __future__ import annotations

import csv
import io
import json
import shutil
from pathlib import Path
from typing import Any

import openpyxl
import pytest

from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.exam.exam import Exam
from variantgen.exam.sections.tolerance import Tolerance
from variantgen.finished import rekey as module
from variantgen.finished.rekey import marking

EXAM = """title = "T"
language = "en"
formats = ["pdf", "html", "xlsx", "moodle", "prairielearn"]
tolerance = {tolerance}
[[problem]]
family = "four_bar"
form = "crank"
ask = ["v_B", "omega_AB", "epsilon_AB"]
points = 6
[[problem]]
families = ["spool", "rolling_wheel"]
"""
STUDENTS = 8
KEYS = {
    "key.csv", "key.pdf", "manifest.json", "html/key.html", "key.xlsx", "grading.xlsx", "moodle.xml",
}  # fmt: skip


def build(folder: Path, tolerance: str, name: str = "out", *options: str) -> Path:
    exam, out = folder / "exam.toml", folder / name
    exam.write_text(EXAM.format(tolerance=tolerance), "utf-8")
    assert main(["build", str(exam), "--variants", str(STUDENTS), "--seed", "5", "--out", str(out), *options]) == 0
    return out


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build(tmp_path_factory.mktemp("printed"), "0.02")


@pytest.fixture(scope="module")
def wider(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same exam built with the other tolerance from the beginning."""
    return build(tmp_path_factory.mktemp("other"), "0.05")


@pytest.fixture
def out(built: Path, tmp_path: Path) -> Path:
    shutil.copytree(built, tmp_path / "out")
    return tmp_path / "out"


def content(folder: Path) -> dict[str, bytes]:
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def manifest(folder: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((folder / "manifest.json").read_text("utf-8"))
    return found


def without_tolerances(folder: Path) -> list[Any]:
    students = manifest(folder)["students"]
    for answer in (a for s in students for p in s["problems"] for a in p["answers"]):
        for name in ("tolerance", "relative_tolerance", "unnoticed"):
            answer.pop(name, None)
    return list(students)


def test_only_what_shows_tolerances_is_made_again(out: Path, built: Path) -> None:
    assert main(["rekey", str(out), "--tolerance", "0.05"]) == 0
    before, after = content(built), content(out)
    assert before.keys() == after.keys()
    other = {name for name in before if before[name] != after[name]}
    platform = {name for name in other if name.startswith("prairielearn/") and name.endswith("variants.json")}
    assert other == KEYS | platform
    assert platform
    assert without_tolerances(out) == without_tolerances(built)
    now, then = manifest(out), manifest(built)
    assert now["exam"]["tolerance"] == 0.05
    assert {**now["exam"], "tolerance": 0.02} == then["exam"]
    for part in ("made_with", "redrawn", "solutions", "seed", "formats"):
        assert now[part] == then[part]


def test_the_key_is_that_of_a_build_with_this_tolerance(out: Path, wider: Path) -> None:
    assert main(["rekey", str(out), "--tolerance", "0.05"]) == 0
    assert (out / "key.csv").read_bytes() == (wider / "key.csv").read_bytes()
    assert manifest(out)["students"] == manifest(wider)["students"]
    assert page_texts(out / "key.pdf") == page_texts(wider / "key.pdf")
    rows = csv.DictReader(io.StringIO((out / "key.csv").read_text("utf-8-sig")))
    for row in rows:
        assert float(row["tolerance"]) == pytest.approx(0.05 * abs(float(row["value"])), rel=0.006)


def test_there_and_back_changes_nothing(out: Path, built: Path) -> None:
    assert main(["rekey", str(out), "--tolerance", "0.05"]) == 0
    assert main(["rekey", str(out), "--floor", "0.02"]) == 0
    assert content(out) == content(built)


def test_remake_and_verify_go_on_working(out: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rekey", str(out), "--tolerance", "0.05"]) == 0
    assert main(["verify", str(out)]) == 0
    assert "no file changed" in capsys.readouterr().err
    for options in ([], ["--solutions"]):
        again = tmp_path / "again.pdf"
        assert main(["remake", str(out), "--student", "7", "--out", str(again), *options]) == 0
        assert "the same as" in capsys.readouterr().err


def test_what_somebody_has_edited_is_kept(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, value in (("grading.xlsx", 12.5), ("key.xlsx", 3.25)):
        book = openpyxl.load_workbook(out / name)
        book.worksheets[0]["Z40"] = value
        book.save(out / name)
    (out / "notes.txt").write_text("mine", "utf-8")
    (out / "solutions.pdf").write_bytes(b"another one")
    typed = (out / "grading.xlsx").read_bytes()
    assert main(["rekey", str(out), "--tolerance", "0.05"]) == 0
    said = capsys.readouterr().err
    assert "changed since they were made, and kept in" in said
    assert str(out / "edited" / "1") in said
    assert (out / "edited/1/grading.xlsx").read_bytes() == typed
    assert openpyxl.load_workbook(out / "edited/1/key.xlsx").worksheets[0]["Z40"].value == 3.25
    assert (out / "grading.xlsx").read_bytes() != typed
    # What is not made again stays where it is.
    assert (out / "notes.txt").read_text("utf-8") == "mine"
    assert (out / "solutions.pdf").read_bytes() == b"another one"
    assert main(["rekey", str(out), "--tolerance", "0.03"]) == 0
    assert (out / "edited/1/grading.xlsx").read_bytes() == typed
    assert not (out / "edited/2").exists()
    assert main(["verify", str(out)]) == 1
    assert "solutions.pdf: the file has been changed since the build" in capsys.readouterr().err


def test_all_or_nothing(out: Path, built: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (out / "key.xlsx").write_bytes(b"edited")
    before = content(out)

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    for name in ("write_manifest", "manifest_lines", "_put_together"):
        with monkeypatch.context() as patch:
            patch.setattr(module, name, full)
            assert main(["rekey", str(out), "--tolerance", "0.05"]) == 2
        assert content(out) == before
        assert [path.name for path in out.parent.iterdir()] == ["out"]
    assert built.exists()


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ([], "--tolerance: expected another tolerance or ceiling"),
        (["--tolerance", "0"], "--tolerance: expected a number between 0 and 0.2 (got 0)"),
        (["--tolerance", "5"], "--tolerance: expected a number between 0 and 0.2 (got 5)"),
        (["--tolerance", "nan"], "expected a number between 0 and 0.2"),
        (
            ["--tolerance", "0.05", "--ceiling", "0.04"],
            "--ceiling: expected a number between the tolerance, 0.05, and 0.2 (got 0.04)",
        ),
    ],
)
def test_numbers_that_cannot_be(options: list[str], said: str, built: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = content(built)
    assert main(["rekey", str(built), *options]) == 2
    output = " ".join(capsys.readouterr().err.split())
    assert said in output
    assert content(built) == before


def test_a_ceiling_that_a_printed_sheet_exceeds_is_refused(
    out: Path, built: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["rekey", str(out), "--tolerance", "0.004", "--ceiling", "0.005"]) == 2
    said = " ".join(capsys.readouterr().err.split())
    assert "answers need more" in said
    assert "cannot be drawn again" in said
    assert content(out) == content(built)
    assert main(["rekey", str(out), "--tolerance", "0.004", "--ceiling", "0.05"]) == 0
    assert manifest(out)["exam"]["tolerance_ceiling"] == 0.05


def test_other_answers_are_no_ground_for_a_key(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = manifest(out)
    del text["students_hash"]  # which earlier versions have not recorded
    text["students"][3]["problems"][0]["answers"][0]["value"] += 1.0
    (out / "manifest.json").write_text(json.dumps(text), "utf-8")
    before = content(out)
    assert main(["rekey", str(out), "--tolerance", "0.05"]) == 2
    said = capsys.readouterr().err
    assert "student 4, problem 1" in said
    assert "other answers" in said
    assert content(out) == before


def test_a_missing_package_is_told_first(
    out: Path, built: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("variantgen.outputs.formats.xlsx.find_spec", lambda name: None)
    assert main(["rekey", str(out), "--tolerance", "0.05"]) == 3
    assert "XlsxWriter" in capsys.readouterr().err
    assert content(out) == content(built)


def test_the_ceiling_of_the_build_is_kept_where_it_can_be() -> None:
    old = Exam("T", "", "en", (), tolerance=Tolerance(0.01, 0.02, False))
    assert marking(old, {None: 0.015}).tolerance == Tolerance(0.015, 0.02, False)
    assert marking(old, {None: 0.05}).tolerance == Tolerance(0.05, None, False)
    assert marking(old, {}, 0.1).tolerance == Tolerance(0.01, 0.1, False)
    with pytest.raises(InputError):
        marking(old, {})


def test_a_problem_can_have_its_own(out: Path, built: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rekey", str(out), "--tolerance", "2=0.07"]) == 0
    own = {
        p["problem"]: {a["relative_tolerance"] for a in p["answers"]} for p in manifest(out)["students"][0]["problems"]
    }
    assert own[2] == {0.07}
    assert 0.07 not in own[1]
    # It stays when the others get another one, and is what  remake  and  verify  know.
    assert main(["rekey", str(out), "--tolerance", "0.05"]) == 0
    assert manifest(out)["students"][0]["problems"][1]["answers"][0]["relative_tolerance"] == 0.07
    assert manifest(out)["exam"]["problem_tolerances"] == {"2": 0.07}
    assert main(["verify", str(out)]) == 0
    capsys.readouterr()
    for wrong, said in (("5=0.02", "no such problem"), ("2=x", "expected a number"), ("a=0.02", "expected a number")):
        assert main(["rekey", str(out), "--tolerance", wrong]) == 2
        assert said in capsys.readouterr().err


def test_files_of_groups(tmp_path: Path) -> None:
    text = """title = "T"
language = "ru"
formats = ["pdf", "html", "latex", "xlsx"]
tolerance = {tolerance}
pdf = {{ files = "groups" }}
html = {{ files = "groups" }}
latex = {{ files = "groups", compile = false }}
xlsx = {{ files = "groups" }}
solutions = {{ depth = "none" }}
[[problem]]
family = "spool"
"""
    roster = tmp_path / "class.csv"
    roster.write_text("id;name;group\n" + "\n".join(f"{i};N{i};M-{i % 2}" for i in range(6)), "utf-8")
    for name, tolerance in (("one", "0.02"), ("other", "0.06")):
        exam = tmp_path / f"{name}.toml"
        exam.write_text(text.format(tolerance=tolerance), "utf-8")
        assert main(["build", str(exam), "--roster", str(roster), "--out", str(tmp_path / name), "--seed", "5"]) == 0
    one, other = tmp_path / "one", tmp_path / "other"
    sheets = {name: held for name, held in content(one).items() if "sheets" in name}
    assert main(["rekey", str(one), "--tolerance", "0.06"]) == 0
    now, wanted = content(one), content(other)
    assert now.keys() == wanted.keys()
    assert {name: now[name] for name in sheets} == sheets
    keys = [name for name in now if "key" in name or "grading" in name]
    assert len(keys) >= 9
    for name in keys:
        if name.endswith(".pdf"):
            assert page_texts(one / name) == page_texts(other / name), name
        elif not name.endswith(".xlsx"):
            assert now[name] == wanted[name], name


@pytest.mark.parametrize("command", ["rekey", "mark"])
def test_no_key_and_no_marks_by_answers_that_somebody_has_edited(
    command: str, out: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    answers, marks = tmp_path / "answers.csv", tmp_path / "marks"
    answers.write_text("code,problem,answer,value\n", "utf-8")
    record = manifest(out)
    record["students"][2]["problems"][0]["answers"][0]["value"] *= -1
    (out / "manifest.json").write_text(json.dumps(record), "utf-8")
    before = content(out)
    options = ["--tolerance", "0.05"] if command == "rekey" else [str(answers), "--out", str(marks)]
    assert main([command, str(out), *options]) == 2
    assert "the students have been changed since the build" in capsys.readouterr().err
    assert content(out) == before
    assert not marks.exists()
