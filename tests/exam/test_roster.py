"""A wrong class list gets a message that names file, row or column and remedy; nothing is written."""

from __future__ import annotations

import csv
import io
import json
import resource
import subprocess
import sys
from pathlib import Path

import openpyxl
import pytest

from variantgen.cli import main
from variantgen.exam.roster import Student, read_roster

EXAM = 'title = "Quiz"\nlanguage = "en"\n[[problem]]\nfamily = "spool"\n'
PNG = b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR"
TWO = [Student("1", "Ann", "A"), Student("2", "Bob", "B")]


def refused(roster: Path, folder: Path, capsys: pytest.CaptureFixture[str]) -> str:
    """Build with this roster; the message, after checking exit code 2, no traceback and nothing written."""
    work = folder / "work"
    work.mkdir()
    exam = work / "exam.toml"
    exam.write_text(EXAM, encoding="utf-8")
    code = main(["build", str(exam), "--roster", str(roster), "--out", str(work / "out")])
    message = capsys.readouterr().err
    assert code == 2, message
    assert "Traceback" not in message
    assert str(roster) in message
    assert [path.name for path in work.iterdir()] == ["exam.toml"]
    return message


def write(folder: Path, content: bytes | str, name: str = "class.csv") -> Path:
    path = folder / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def workbook(folder: Path, rows: list[list[object]]) -> Path:
    book = openpyxl.Workbook()
    assert book.active is not None
    for row in rows:
        book.active.append(row)
    path = folder / "class.xlsx"
    book.save(path)
    return path


def test_missing_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "No such file" in refused(tmp_path / "none.csv", tmp_path, capsys)


def test_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "folder.csv"
    folder.mkdir()
    assert "directory" in refused(folder, tmp_path, capsys)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", ["empty", "id, name, group"]),
        (b"\n \n;;\n", ["empty"]),
        (b"id,name,group\n", ["header", "no students"]),
        (PNG, ["not a text file", "CSV"]),
        (b"\x00" * 100, ["not a text file"]),
        (bytes(range(256)) * 4, ["not a text file"]),
        (bytes(range(0x80, 0x100)) * 4, ["neither UTF-8 nor cp1251"]),
        (b"\xff\xfe\x00", ["UTF-8"]),
        (b"PK\x03\x04 rubbish", ["XLSX", "save it again"]),
        ("id,nmae\n1,Ann\n", ["unknown column", "nmae", "did you mean", "name"]),
        ("id,mark\n1,5\n", ["no column for the name", "unknown column", "mark"]),
        ("id,group\n1,A\n", ["no column for the name"]),
        ("1,Ann,A\n2,Bob,B\n", ["unknown column", "header"]),
        ("id,name,Full_Name\n1,Ann,Ann\n", ["second column for the name", "keep one"]),
        ("id,name,ID\n1,Ann,1\n", ["second column for the id"]),
        ("id,name\n7,Ann\n8,Bob\n7,Cyd\n", ["row 4", "7", "row 2", "twice"]),
        ("id,name\n,Ann\n", ["row 2", "id is empty", "fill it in"]),
        ("id,name\n1,\n", ["row 2", "name is empty"]),
        ("id,name\n1,Ann,Lee\n", ["row 2", "more cells than the header", "quote"]),
        ("id,name\n1,A\x07nn\n", ["row 2", "name holds a control character", "U+0007"]),
        ('id,name\n1,"Ann\nLee"\n', ["control character", "name"]),
        ('id,name\n1,"Ann\n', ["not a proper CSV"]),
        ("id,name\n1," + "x" * 20_001 + "\n", ["row 2", "20001 characters", "at most 20000"]),
    ],
)
def test_wrong_content(
    content: bytes | str, said: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    message = refused(write(tmp_path, content), tmp_path, capsys)
    assert all(part in message for part in said), message


def test_every_mistake_is_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    message = refused(write(tmp_path, "id,name\n1,\n,Bob\n3,C\x01\n3,Dan\n5,Eve,x\n"), tmp_path, capsys)
    assert all(f"row {number}" in message for number in (2, 3, 4, 5, 6)), message


@pytest.mark.parametrize("part", [0.1, 0.5, 0.9, 0.99])
def test_truncated_workbook(part: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    whole = workbook(tmp_path, [["id", "name"], [1, "Ann"]]).read_bytes()
    message = refused(write(tmp_path, whole[: int(len(whole) * part)], "cut.xlsx"), tmp_path, capsys)
    assert "XLSX" in message
    assert "save it again" in message


@pytest.mark.parametrize(
    ("place", "value"), [(2000, 0xFF), (3000, 0x00), (4000, 0x41)], ids=["early", "middle", "late"]
)
def test_damaged_workbook_is_read_or_refused(
    place: int, value: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    content = bytearray(workbook(tmp_path, [["id", "name"]] + [[i, f"N{i}"] for i in range(50)]).read_bytes())
    content[place : place + 40] = bytes([value]) * 40
    exam = write(tmp_path, EXAM, "exam.toml")
    roster = write(tmp_path, bytes(content), "bad.xlsx")
    code = main(["build", str(exam), "--roster", str(roster), "--out", str(tmp_path / "none" / "out")])
    message = capsys.readouterr().err
    assert code == 2
    assert "Traceback" not in message


@pytest.mark.parametrize("device", ["/dev/zero"])
def test_endless_file_is_refused(device: str, tmp_path: Path) -> None:
    # Where there is no such device the file cannot be read, which is refused as well.
    exam = write(tmp_path, EXAM, "exam.toml")
    command = [sys.executable, "-m", "variantgen", "build", str(exam), "--roster", device, "--out", "out"]
    done = subprocess.run(
        command,
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=30,
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30)),
    )
    assert "Traceback" not in done.stderr
    assert done.returncode == 2, done.stderr


@pytest.mark.parametrize("delimiter", [",", ";", "\t"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_delimiters_encodings_and_line_ends(delimiter: str, encoding: str, end: str, tmp_path: Path) -> None:
    text = end.join(delimiter.join(row) for row in [("id", "name", "group"), ("1", "Ann", "A"), ("2", "Bob", "B")])
    assert read_roster(write(tmp_path, (text + end).encode(encoding))) == TWO


def test_cp1251(tmp_path: Path) -> None:
    path = write(tmp_path, "зачётка;ФИО;группа\n1;Пётр Ёлкин;К-1\n".encode("cp1251"))
    assert read_roster(path) == [Student("1", "Пётр Ёлкин", "К-1")]


@pytest.mark.parametrize(
    "header", ["Группа;№ зачётной книжки;Фамилия Имя Отчество", "класс;Номер зачётной книжки;Ф.И.О."]
)
def test_russian_headings_in_any_order(header: str, tmp_path: Path) -> None:
    path = write(tmp_path, f"\n{header}\nA;1;Ann\nB;2;Bob\n")
    assert read_roster(path) == TWO


def test_quoted_cells_keep_the_delimiter(tmp_path: Path) -> None:
    out = io.StringIO()
    csv.writer(out).writerows([["name", "id"], ['Lee, Ann "A"', "1;2"]])
    assert read_roster(write(tmp_path, out.getvalue())) == [Student("1;2", 'Lee, Ann "A"')]


def test_workbook_with_whole_numbers(tmp_path: Path) -> None:
    path = workbook(tmp_path, [["ФИО", "id", "group"], [None, None, None], ["Ann", 1, "A"], ["Bob", 2.0, "B"]])
    assert read_roster(path) == TWO


def test_workbook_rows_are_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = workbook(tmp_path, [["id", "name"], [5, "Ann"], ["5", "Bob"], [None, "Cyd"]])
    message = refused(path, tmp_path, capsys)
    assert all(part in message for part in ("row 3", "row 2", "row 4", "id is empty"))


def test_blanks_around_an_id_do_not_make_it_another(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "twice" in refused(write(tmp_path, "id,name\n1,Ann\n 1 ,Bob\n"), tmp_path, capsys)


def test_good_roster_builds(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam = write(tmp_path, EXAM, "exam.toml")
    roster = write(tmp_path, "name,id\nAnn,1\nBob,2\n")
    out = tmp_path / "out"
    assert main(["build", str(exam), "--roster", str(roster), "--out", str(out)]) == 0, capsys.readouterr().err
    students = json.loads((out / "manifest.json").read_text("utf-8"))["students"]
    assert [(s["id"], s["name"]) for s in students] == [("1", "Ann"), ("2", "Bob")]
