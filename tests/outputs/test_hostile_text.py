"""Text from outside is data: it appears on paper as it stands, runs nowhere and writes nowhere."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from tests.pdf_text import page_texts
from variantgen.cli import main

FILES = ["key.csv", "key.pdf", "manifest.json", "sheets.pdf", "solutions.pdf"]
LITERAL = [
    '#read("/etc/passwd")',
    '#sys.inputs #import "common.typ": * ',
    r"$x$ \ # * _ < > & { } ' @ [ ]",
    "]]> --> */ // /* comment",
    "]]>",
    '=HYPERLINK("x")',
    "../../x",
    "*bold* _slanted_ `raw` ~ <label> @ref",
    "{{ 7 * 7 }} {% raw %} ${HOME} %s %d \\u0041",
    "Ёлкин-Ђорђевић Ñandú Łódź",
]
STRANGE = [
    "שלום עולם",
    "محمد عبد الله",
    "\N{PILE OF POO}\N{FAMILY}\U0001f468\u200d\U0001f469\u200d\U0001f467",
    "Z\u0351\u0310a\u0327\u0301l\u0322go " + "\u0301" * 50,
    "x" * 5000,
    "name " * 1000,
    "学生姓名",
    "\u202eevil\u202c \u200b\ufeff\u2028\u00a0",
    "\ue0000\ue001\uffff\U0010ffff",
    "a/b\\c:d|e?f",
]


def build(folder: Path, title: str, course: str, rows: list[tuple[str, str, str]]) -> Path:
    """Build an exam in ``folder/work``; nothing else may appear below ``folder``."""
    work = folder / "work"
    work.mkdir()
    quoted = [json.dumps(text, ensure_ascii=True) for text in (title, course)]
    if any("\\ud8" in text or "\\udb" in text for text in quoted):
        quoted = [json.dumps(text, ensure_ascii=False) for text in (title, course)]
    head = f'title = {quoted[0]}\ncourse = {quoted[1]}\nlanguage = "en"\n'
    (work / "exam.toml").write_text(head + '[[problem]]\nfamily = "spool"\n', encoding="utf-8")
    out = io.StringIO(newline="")
    csv.writer(out).writerows([("id", "name", "group"), *rows])
    (work / "class.csv").write_text(out.getvalue(), encoding="utf-8", newline="")
    code = main(["build", str(work / "exam.toml"), "--roster", str(work / "class.csv"), "--out", str(work / "out")])
    assert code == 0
    assert sorted(path.name for path in folder.iterdir()) == ["work"]
    assert sorted(path.name for path in work.iterdir()) == ["class.csv", "exam.toml", "out"]
    assert sorted(path.name for path in (work / "out").iterdir()) == FILES
    return work / "out"


def printed(pdf: Path) -> str:
    """The text of a PDF without blanks (lines may be broken anywhere) and with straight quotes."""
    return squeezed("".join(page_texts(pdf)))


def squeezed(text: str) -> str:
    return "".join(text.split())


def key_rows(out: Path) -> list[dict[str, str]]:
    with (out / "key.csv").open(encoding="utf-8-sig", newline="") as file:
        return list(csv.DictReader(file))


@pytest.mark.parametrize("text", LITERAL)
def test_text_appears_as_it_stands(text: str, tmp_path: Path) -> None:
    out = build(tmp_path, f"T1 {text}", f"C2 {text}", [(f"I3 {text}", f"N4 {text}", f"G5 {text}")])
    sheets, key, solutions = (printed(out / f"{name}.pdf") for name in ("sheets", "key", "solutions"))
    for mark in ("T1", "C2", "N4", "G5"):
        assert squeezed(f"{mark} {text}") in sheets
        assert squeezed(f"{mark} {text}") in solutions
    assert squeezed(f"N4 {text}") in key
    assert "root:x:" not in sheets + key + solutions
    (row,) = {(row["id"], row["name"], row["group"]) for row in key_rows(out)}
    assert row == tuple(f"{mark} {text}".strip() for mark in ("I3", "N4", "G5"))


@pytest.mark.parametrize("text", STRANGE)
def test_strange_text_builds(text: str, tmp_path: Path) -> None:
    out = build(tmp_path, text, text, [(text, text, text), ("2", "Bob", "")])
    student = json.loads((out / "manifest.json").read_text("utf-8"))["students"][0]
    assert (student["id"], student["name"], student["group"]) == (text.strip(),) * 3


@pytest.mark.parametrize("start", ["=1+1", "+1", "-1", "@SUM(A1)", "=cmd|' /C calc'!A0", "＝1+1"])
def test_no_cell_of_the_key_is_a_formula(start: str, tmp_path: Path) -> None:
    out = build(tmp_path, start, start, [(start, start, start), ("2", "Bob", "B")])
    rows = key_rows(out)
    for column in ("id", "name", "group"):
        assert rows[0][column] in {"'" + start, start}
        assert not rows[0][column].startswith(("=", "+", "-", "@"))
        assert rows[-1][column] in {"2", "Bob", "B"}
    assert json.loads((out / "manifest.json").read_text("utf-8"))["students"][0]["id"] == start


@pytest.mark.parametrize("name", ["-dash", "with space", "ünï·код", "#hash$x", "a'b\"c", "[x]"])
def test_strange_output_folder(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / name
    for options in ([], ["--force"]):
        assert main(["build", "sample_en", "--variants", "1", "--out", str(out), *options]) == 0
        assert [path.name for path in tmp_path.iterdir()] == [name]
        assert sorted(path.name for path in out.iterdir()) == FILES
    assert str(out) in capsys.readouterr().err
