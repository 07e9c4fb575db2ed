"""A lost sheet is found by what is on the paper and in the head."""

from __future__ import annotations

from pathlib import Path

import pytest
from msgspec.structs import replace

from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.exam.manifest import Manifest, RecordedSheet, read_manifest
from variantgen.exam.roster import Student
from variantgen.finished.find import find

EXAM = 'title = "T"\nlanguage = "en"\n[solutions]\ndepth = "none"\n[[problem]]\nfamily = "spool"\n'
CLASS = [
    ("17", "Ёлкина Анна Львовна", "М-21", "CU6-ML5"),
    ("2", "Öztürk Ann", "М-22", "2G4-K2M"),
    ("10", "Lee Anna", "М-22", "7Q4-AAA"),
    ("9", "Lee Anna", "М-21", "7Q4-BBB"),
    ("x1", "O'Brien-Smith Bob", "", "7Q4-17A"),
    ("Cyd", "Wood Joe", "", "999-CYD"),
    ("y", "Cyd Jones", "", "999-CYE"),
]


@pytest.fixture
def record() -> Manifest:
    sheets = tuple(RecordedSheet(Student(*who[:3]), who[3], ()) for who in CLASS)
    return Manifest(Path("manifest.json"), {}, "", "", None, (), "", sheets, {}, "1a2b3c4d")


@pytest.mark.parametrize(
    ("text", "student"),
    [
        ("17", "17"),
        ("CU6-ML5", "17"),
        ("cu6ml5", "17"),
        (" CU6 ML5 ", "17"),
        ("VARIANTGEN:1:1A2B3C4D:CU6-ML5", "17"),
        ("variantgen:1:1a2b3c4d:2g4-k2m", "2"),
        ("Ёлкина Анна Львовна", "17"),
        ("елкина", "17"),
        ("анна ёлк", "17"),
        ("ELKINA", ""),
        ("ozturk", "2"),
        ("Öz", "2"),
        ("o'brien", "x1"),
        ("smith", "x1"),
        ("Cyd", "Cyd"),
        ("jones", "y"),
    ],
)
def test_who_is_meant(text: str, student: str, record: Manifest) -> None:
    if student:
        assert record.sheets[find(record, text)].student.id == student
    else:
        with pytest.raises(InputError, match="no such student"):
            find(record, text)


def test_several_are_listed_in_order(record: Manifest) -> None:
    with pytest.raises(InputError) as caught:
        find(record, "lee")
    lines = [line.strip() for line in str(caught.value).splitlines()]
    assert "2 students may be meant (got lee)" in lines[0]
    assert lines[2:] == ["7Q4-BBB  Lee Anna, М-21  (id 9)", "7Q4-AAA  Lee Anna, М-22  (id 10)"]


def test_a_long_list_is_cut(record: Manifest) -> None:
    many = tuple(RecordedSheet(Student(f"s{i}", f"Lee {i}"), f"AAA-{i}", ()) for i in range(100))
    with pytest.raises(InputError) as caught:
        find(replace(record, sheets=many), "lee")
    lines = str(caught.value).splitlines()
    assert "Lee 2" in lines[4]  # 0, 1, 2, ... and not 0, 1, 10
    assert "... and 80 more" in lines[-1]
    assert len(lines) == 23


def test_a_sheet_of_another_exam(record: Manifest) -> None:
    with pytest.raises(InputError, match="of another exam"):
        find(record, "VARIANTGEN:1:00000000:CU6-ML5")


@pytest.mark.parametrize(("text", "output"), [("18", "did you mean"), ("Lea Anna", "Lee Anna"), ("", "the code of")])
def test_nobody(text: str, output: str, record: Manifest) -> None:
    with pytest.raises(InputError) as caught:
        find(record, text)
    assert output in str(caught.value)


def test_remake_by_code_and_qr_code(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("exam.toml").write_text(EXAM, "utf-8")
    Path("class.csv").write_text("name,group\nAnn Lee,A\nBob Ray,A\nAnn Ray,B\n", "utf-8")
    assert main(["build", "exam.toml", "--roster", "class.csv", "--out", "out"]) == 0
    found = read_manifest(Path("out"))
    code = {sheet.student.name: sheet.code for sheet in found.sheets}
    for text in (code["Bob Ray"], f"VARIANTGEN:1:{found.exam_id.upper()}:{code['Bob Ray']}", "bob", "Bob Ray (A)"):
        assert main(["remake", "out", "--student", text]) == 0
        Path(f"{code['Bob Ray']}.pdf").unlink()
    assert main(["remake", "out", "--student", "ann"]) == 2
