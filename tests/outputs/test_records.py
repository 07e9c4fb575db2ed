"""key.csv is safe to open: no text from outside becomes a formula, whichever sign parts the cells."""

from __future__ import annotations

import csv
import io
from dataclasses import replace

import pytest

from variantgen.exam.assembly import assemble
from variantgen.exam.roster import Student
from variantgen.exam.samples import samples_dir
from variantgen.exam.sheets import Sheet
from variantgen.outputs.formats import read_exam
from variantgen.outputs.records import key_rows

FORMULA_STARTS = tuple("=+-@＝＋－＠")
BLANKS = " \t\r\n\u00a0\u3000\u200b\u2060\ufeff"


@pytest.fixture(scope="module")
def sheet() -> Sheet:
    exam = read_exam(samples_dir() / "sample_ru.toml")
    return assemble(replace(exam, tasks=exam.tasks[:1]), [Student("1", "N")], "1").sheets[0]


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
