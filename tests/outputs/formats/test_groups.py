"""Files for each group: who is in them, in every output that makes them; the sheets are those of the class."""

from __future__ import annotations

import json
import re
from pathlib import Path

import openpyxl
import pikepdf
import pytest

from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.outputs.files.file_names import file_names

EXAM = (
    'title = "T"\nlanguage = "ru"\nsort = "{}"\nformats = ["pdf", "html", "latex", "xlsx"]\n{}'
    '[[problem]]\nfamilies = ["spool", "rolling_wheel"]\n'
)
GROUPS = "".join(f'{name}.files = "groups"\n' for name in ("html", "pdf", "latex", "xlsx")) + "latex.compile = false\n"
STEMS = {"М-2": "М-2", "М-10": "М-10", "К/1": "К-1", "": "no-group", "con": "con-2"}
CODE = re.compile(r"\b[2-9A-Z]{3}-[2-9A-Z]{3}\b")


def built(folder: Path, sort: str, text: str) -> Path:
    """An exam of 53 students in five groups, which begin anywhere in the parts of a build."""
    exam, roster = folder / "exam.toml", folder / "class.csv"
    exam.write_text(EXAM.format(sort, text), "utf-8")
    groups = list(STEMS)
    rows = (f"s{i};N{i * 37 % 53};{groups[(i * i + i // 7) % 5]}" for i in range(53))
    roster.write_text("id;name;group\n" + "\n".join(rows), "utf-8")
    assert main(["build", str(exam), "--roster", str(roster), "--out", str(folder / "out")]) == 0
    return folder / "out"


@pytest.fixture(scope="module", params=["name", "roster"])
def out(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp(request.param), request.param, GROUPS)


def members(out: Path) -> dict[str, list[str]]:
    """The codes of each group by the manifest, in its order."""
    found: dict[str, list[str]] = {}
    for student in json.loads((out / "manifest.json").read_text("utf-8"))["students"]:
        found.setdefault(student["group"], []).append(student["code"])
    assert found.keys() <= STEMS.keys()
    return {STEMS[group]: codes for group, codes in found.items()}


def in_turn(text: str, known: set[str]) -> list[str]:
    return list(dict.fromkeys(code for code in CODE.findall(text) if code in known))


def test_every_file_has_its_group(out: Path) -> None:
    own = members(out)
    known = {code for codes in own.values() for code in codes}
    assert len(own) > 3
    assert len(known) == 53
    for kind in ("sheets", "key", "solutions"):
        assert {path.stem for path in (out / kind).glob("*.pdf")} == own.keys()
        assert {path.stem for path in (out / "html" / kind).iterdir()} == own.keys()
        assert {path.name for path in (out / "latex" / kind).iterdir()} == {f"{stem}.tex" for stem in own}
        for stem, codes in own.items():
            assert in_turn("\n".join(page_texts(out / kind / f"{stem}.pdf")), known) == codes
            assert in_turn((out / "html" / kind / f"{stem}.html").read_text("utf-8"), known) == codes
            assert in_turn((out / "latex" / kind / f"{stem}.tex").read_text("utf-8"), known) == codes


def test_a_key_has_both_halves_of_its_group_and_one_heading(out: Path) -> None:
    for stem, codes in members(out).items():
        text = "\n".join(page_texts(out / "key" / f"{stem}.pdf"))
        assert all(text.count(code) == 2 for code in codes)  # by student, and in the table of a problem
        assert text.count("По студентам") == 1
        source = (out / "latex" / "key" / f"{stem}.tex").read_text("utf-8")
        assert source.count(r"\keysection{") == 2


def test_names_of_files() -> None:
    assert file_names(["К/1", "к 1", "К-1", "", "..", "NUL", "a" * 500]) == [
        "К-1", "к-1-2", "К-1-3", "-", "--2", "NUL-2", "a" * 80,
    ]  # fmt: skip


def test_workbooks(out: Path) -> None:
    for stem, codes in members(out).items():
        form = openpyxl.load_workbook(out / "grading" / f"{stem}.xlsx").worksheets[0]
        assert [row[0].value for row in form.iter_rows(min_row=7)] == codes
        key = openpyxl.load_workbook(out / "key" / f"{stem}.xlsx").worksheets[0]
        assert list(dict.fromkeys(row[0].value for row in key.iter_rows(min_row=2))) == codes


def test_bookmarks_are_the_students(out: Path) -> None:
    names: dict[str, list[str]] = {}
    for student in json.loads((out / "manifest.json").read_text("utf-8"))["students"]:
        names.setdefault(STEMS[student["group"]], []).append(student["name"])
    for stem, own in names.items():
        with pikepdf.open(out / "sheets" / f"{stem}.pdf") as pdf, pdf.open_outline() as outline:
            assert [str(item.title) for item in outline.root] == own


def test_an_index_of_pages(out: Path) -> None:
    text = (out / "html" / "index.html").read_text("utf-8")
    links = re.findall(r'href="([^"]+)"', text)
    assert sorted(links) == sorted(f"{k}/{s}.html" for k in ("sheets", "key", "solutions") for s in members(out))
    assert all((out / "html" / link).is_file() for link in links)


@pytest.mark.parametrize("options", [(), ("--solutions",)])
@pytest.mark.parametrize("place", [0, 20, 52])
def test_remake(
    place: int, options: tuple[str, ...], out: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    student = json.loads((out / "manifest.json").read_text("utf-8"))["students"][place]
    capsys.readouterr()
    again = tmp_path / "again.pdf"
    assert main(["remake", str(out), "--student", student["code"], "--out", str(again), *options]) == 0
    assert f"of {STEMS[student['group']]}.pdf" in capsys.readouterr().err
    assert page_texts(again)
    assert all(student["code"] in page for page in page_texts(again))


def test_the_sheets_are_those_of_the_class(out: Path, tmp_path: Path) -> None:
    sort = out.parent.name.rstrip("0123456789")
    joined = built(tmp_path, sort, "latex.compile = false\n")
    first, second = (json.loads((x / "manifest.json").read_text("utf-8"))["students"] for x in (joined, out))
    assert first == second
    assert main(["verify", str(out)]) == 0
