"""key.csv is safe to open: no text from outside becomes a formula, whichever sign parts the cells."""

from __future__ import annotations

import csv
import io
import json
import shutil
from collections.abc import Iterable
from pathlib import Path

import pytest
from msgspec.structs import replace

from benchmarks.sheets import drawn_sheets
from variantgen.builder import build
from variantgen.exam.roster import Student
from variantgen.exam.samples import samples_dir
from variantgen.exam.sheets import Sheet
from variantgen.outputs.files.records import key_rows
from variantgen.outputs.formats import read_exam
from variantgen.resources import catalog_dir

FORMULA_STARTS = tuple("=+-@＝＋－＠")
BLANKS = " \t\r\n\u00a0\u3000\u200b\u2060\ufeff"


@pytest.fixture(scope="module")
def sheet() -> Sheet:
    exam = read_exam(samples_dir() / "sample_ru.toml")
    return drawn_sheets(replace(replace(exam, tasks=exam.tasks[:1]), seed="1"), [Student("1", "N")])[0]


@pytest.mark.parametrize(
    "lead", ["", " ", "   ", "\u00a0", "\u3000", "\ufeff", "\u200b ", "\t", "x;", "x; ", "x\t", ";;"]
)
@pytest.mark.parametrize("start", ["=1+1", "=cmd|' /C calc'!A0", "+1", "-1", "@SUM(A1)", "＝1", "＋1", "－1", "＠A"])
def test_no_cell_begins_like_a_formula(lead: str, start: str, sheet: Sheet) -> None:
    text = lead + start
    found = key_rows([replace(sheet, student=Student(text, text, text))])
    (*_, row) = csv.reader(io.StringIO(found))
    assert [cell.replace("'", "") for cell in row[:3]] == [text.replace("'", "")] * 3
    for delimiter in ",;\t":
        for cells in csv.reader(io.StringIO(found), delimiter=delimiter):
            # The numbers of the program itself may be negative.
            assert not any(cell.strip(BLANKS).startswith(FORMULA_STARTS) and not is_number(cell) for cell in cells), (
                cells
            )


@pytest.mark.parametrize("name", ["=1+cmd|x", "@SUM(1)", "\t-1", "x;=1"])
def test_the_name_of_a_family_is_no_formula(name: str, tmp_path: Path) -> None:
    exam = tmp_path / "exam.toml"
    shutil.copytree(catalog_dir() / "spool", tmp_path / name)
    exam.write_text(f"title = 'T'\nlanguage = 'en'\n[[problem]]\nfamily = {json.dumps(name)}\n", "utf-8")
    out = tmp_path / "out"
    build(read_exam(exam), [Student("1", "N")], out)
    raw = (out / "key.csv").read_bytes()
    for delimiter in ",;\t":
        for cells in csv.reader(io.StringIO(raw.decode("utf-8-sig")), delimiter=delimiter):
            assert not any(cell.strip(BLANKS).startswith(FORMULA_STARTS) and not is_number(cell) for cell in cells)
    assert name.strip() in [row["family"].replace("'", "").strip() for row in reader(raw)]


def test_the_key_has_one_kind_of_line_ends(tmp_path: Path) -> None:
    """As Ruby's CSV reads it: the first line end is that of the file, and no other may follow."""
    build(read_exam(samples_dir() / "sample_en.toml"), [Student(str(n), f"N{n}") for n in range(18)], tmp_path / "out")
    raw = (tmp_path / "out" / "key.csv").read_bytes()
    assert raw.startswith(b"\xef\xbb\xbfid,name,group,")
    lines = raw.split(b"\r\n")
    assert lines.pop() == b""
    assert not any(b"\n" in line or b"\r" in line for line in lines)
    assert len(lines) == 1 + len(list(reader(raw)))
    manifest = (tmp_path / "out" / "manifest.json").read_bytes()
    assert b"\r" not in manifest
    assert [sheet["id"] for sheet in json.loads(manifest)["students"]] == [str(n) for n in range(18)]


def reader(raw: bytes) -> Iterable[dict[str, str]]:
    return csv.DictReader(io.StringIO(raw.decode("utf-8-sig"), newline=""))


def is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return text not in ("+1", "-1") or not text


@pytest.mark.parametrize("text", ["Smith-Jones", "a = b", "O'Neil", "007", "1E5", "Иванов; Петров", "x@y.org", "−5"])
def test_other_text_stays(text: str, sheet: Sheet) -> None:
    (*_, row) = csv.reader(io.StringIO(key_rows([replace(sheet, student=Student(text, text, text))])))
    assert row[:3] == [text] * 3
