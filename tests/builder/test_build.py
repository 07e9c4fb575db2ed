"""The main job from end to end: same bytes, complete folders, what a sheet and a key say."""

from __future__ import annotations

import csv
import io
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pikepdf
import pytest

from tests.pdf_text import page_texts
from tests.tools import NIGHTLY
from variantgen.cli import main
from variantgen.exam.samples import samples_dir
from variantgen.resources import catalog_dir

FILES = {"sheets.pdf", "key.pdf", "solutions.pdf", "key.csv", "manifest.json"}
ROSTER = "id;name;group\n17;Иванов Иван;М-21\n4;Öztürk Ann;М-22\n99;De la Cruz, Ana;М-21\n"


def content(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def built(tmp_path: Path, name: str, *arguments: str, **environment: str) -> dict[str, bytes]:
    """A build in a fresh process, as a user runs it."""
    out = tmp_path / name
    command = [sys.executable, "-m", "variantgen", "build", *arguments, "--out", str(out)]
    subprocess.run(command, check=True, capture_output=True, env={**os.environ, **environment})
    return content(out)


# Several parts of each document: of the key with 30 students, of the solutions with 7.
KEYS, SOLUTIONS = ("30", ("--no-solutions",)), ("7", ())
BUILDS = [("sample_en", *KEYS), ("sample_ru", *SOLUTIONS)]
BUILDS += [("sample_ru", *KEYS), ("sample_en", *SOLUTIONS)] if NIGHTLY else []


@pytest.mark.parametrize(("exam", "count", "options"), BUILDS)
def test_same_bytes_for_any_number_of_processes_and_any_hash_seed(
    exam: str, count: str, options: tuple[str, ...], tmp_path: Path
) -> None:
    choice = [exam, "--variants", count, *options]
    one = built(tmp_path, "one", *choice, "--jobs", "1", PYTHONHASHSEED="1", LC_ALL="C")
    two = built(tmp_path, "two", *choice, "--jobs", "2", PYTHONHASHSEED="2", TZ="Asia/Tokyo")
    assert one.keys() == FILES - ({"solutions.pdf"} if options else set())
    assert {name for name in one if one[name] != two[name]} == set()


@pytest.mark.parametrize("exam", ["sample_ru", "sample_en"])
def test_sample_roster(exam: str, tmp_path: Path) -> None:
    out = tmp_path / "exam"
    roster = str(samples_dir() / "roster.csv")
    assert main(["build", exam, "--roster", roster, "--no-solutions", "--out", str(out)]) == 0
    assert {path.name for path in out.iterdir()} == FILES - {"solutions.pdf"}
    record = json.loads((out / "manifest.json").read_text("utf-8"))
    assert record["schema"] == 2
    assert len(record["students"]) == 30
    assert len({student["code"] for student in record["students"]}) == 30
    for problem in zip(*(student["problems"] for student in record["students"]), strict=True):
        drawn = [json.dumps([p["family"], p["form"], p["parameters"]]) for p in problem]
        assert len(set(drawn)) == 30, "two students have the same variant"
        assert all(p["attempt"] >= 1 for p in problem)
        assert all(
            a["tolerance"] == pytest.approx(a["relative_tolerance"] * abs(a["value"]), rel=5e-3)
            and 0.02 <= a["relative_tolerance"] <= 0.03 + 1e-12
            for p in problem
            for a in p["answers"]
        )
    rows = list(csv.DictReader(io.StringIO((out / "key.csv").read_text("utf-8-sig"))))
    answers = [a for s in record["students"] for p in s["problems"] for a in p["answers"]]
    assert [float(row["value"]) for row in rows] == [a["value"] for a in answers]
    codes = [student["code"] for student in record["students"]]
    assert_odd_first_pages(page_texts(out / "sheets.pdf"), codes)


def assert_odd_first_pages(pages: list[str], codes: list[str]) -> None:
    """Every student's sheet is there, in their order, and begins on the front of a leaf."""
    first: dict[str, int] = {}
    for number, text in enumerate(pages, start=1):
        for code in codes:
            if code in text:
                first.setdefault(code, number)
    assert list(first) == codes
    assert all(number % 2 == 1 for number in first.values())


def small_exam(tmp_path: Path, extra: str = "") -> Path:
    path = tmp_path / "exam.toml"
    path.write_text(
        f'title = "T"\nlanguage = "en"\nseed = "s"\n{extra}\n[[problem]]\nfamily = "four_bar"\nask = ["v_B"]\n', "utf-8"
    )
    return path


def test_roster_order_does_not_matter_and_a_new_student_changes_nobody(tmp_path: Path) -> None:
    def record(lines: list[str], name: str) -> dict[str, object]:
        roster = tmp_path / f"{name}.csv"
        roster.write_text("\n".join(["id;name;group", *lines]), "utf-8")
        out = tmp_path / name
        assert main(["build", str(small_exam(tmp_path)), "--roster", str(roster), "--out", str(out)]) == 0
        return {s["id"]: s for s in json.loads((out / "manifest.json").read_text("utf-8"))["students"]}

    lines = ROSTER.splitlines()[1:]
    one = record(lines, "one")
    assert record(lines[::-1], "two") == one
    more = record(["5;New Student;", *lines], "three")
    assert {key: more[key] for key in one} == one


def test_without_duplex_there_are_no_empty_pages(tmp_path: Path) -> None:
    out = tmp_path / "exam"
    exam = small_exam(tmp_path, "[page]\nduplex = false")
    assert main(["build", str(exam), "--variants", "3", "--out", str(out)]) == 0
    with pikepdf.open(out / "sheets.pdf") as pdf:
        assert len(pdf.pages) == 3
        assert str(pdf.docinfo["/Title"]) == "T"
        assert str(pdf.Root["/Lang"]) == "en"


def test_names_and_groups_are_printed(tmp_path: Path) -> None:
    roster, out = tmp_path / "r.csv", tmp_path / "exam"
    roster.write_text(ROSTER, "utf-8")
    assert main(["build", str(small_exam(tmp_path)), "--roster", str(roster), "--out", str(out)]) == 0
    for name in ("sheets.pdf", "key.pdf", "solutions.pdf"):
        text = "".join(page_texts(out / name))
        for word in ("Иванов Иван", "Öztürk Ann", "De la Cruz, Ana", "М-22"):
            assert word in text, (name, word)


def test_force_replaces_the_folder_whole(tmp_path: Path) -> None:
    out = tmp_path / "exam"
    arguments = ["build", str(small_exam(tmp_path)), "--out", str(out), "--variants"]
    assert main([*arguments, "1"]) == 0
    before = content(out)
    assert main([*arguments, "2"]) == 2
    assert content(out) == before
    assert main([*arguments, "2", "--force"]) == 0
    assert content(out).keys() == FILES
    assert content(out) != before
    assert {path.name for path in tmp_path.iterdir()} == {"exam", "exam.toml"}


def test_force_does_not_touch_a_folder_with_anything_else(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "exam"
    out.mkdir()
    (out / "thesis.txt").write_text("mine")
    arguments = ["build", str(small_exam(tmp_path)), "--variants", "1", "--force", "--out"]
    assert main([*arguments, str(out)]) == 2
    assert "thesis.txt" in capsys.readouterr().err
    assert (out / "thesis.txt").read_text() == "mine"
    empty = tmp_path / "empty"
    empty.mkdir()
    monkeypatch.chdir(empty)
    assert main([*arguments, "."]) == 2
    assert "working folder" in capsys.readouterr().err


def test_a_replacement_cut_short_is_put_back(tmp_path: Path) -> None:
    # Killed between the two renamings: the earlier output stands beside under its hidden name.
    out = tmp_path / "exam"
    arguments = ["build", str(small_exam(tmp_path)), "--variants", "1", "--out", str(out)]
    assert main(arguments) == 0
    out.rename(tmp_path / ".exam.replaced")
    assert main(arguments) == 2
    assert content(out).keys() == FILES


def test_pools_give_each_student_one_of_the_families(tmp_path: Path) -> None:
    exam, out = tmp_path / "exam.toml", tmp_path / "out"
    exam.write_text('title = "T"\nlanguage = "en"\n[[problem]]\nfamilies = ["rolling_wheel", "spool"]\n', "utf-8")
    assert main(["build", str(exam), "--variants", "40", "--no-solutions", "--out", str(out)]) == 0
    record = json.loads((out / "manifest.json").read_text("utf-8"))
    families = [student["problems"][0]["family"] for student in record["students"]]
    assert 8 < families.count("spool") < 32


@pytest.mark.parametrize("language", ["en", "ru"])
def test_every_student_is_in_the_key_once(language: str, tmp_path: Path) -> None:
    # More students than an overview takes: once by student, once in the table of each problem.
    exam, out = tmp_path / "exam.toml", tmp_path / "exam"
    sample = (catalog_dir() / "exams" / f"sample_{language}.toml").read_text("utf-8")
    exam.write_text(f"fair = false\n{sample}", "utf-8")
    arguments = ["build", str(exam), "--variants", "70", "--no-solutions", "--format", "pdf,html"]
    assert main([*arguments, "--out", str(out)]) == 0
    record = json.loads((out / "manifest.json").read_text("utf-8"))
    keys = {"pdf": "".join(page_texts(out / "key.pdf")), "html": (out / "html" / "key.html").read_text("utf-8")}
    for student in record["students"]:
        for name, text in keys.items():
            found = len(re.findall(rf"(?<![A-Z0-9-]){student['code']}(?![A-Z0-9-])", text))
            assert found == 1 + len(student["problems"]), (name, student["code"])
