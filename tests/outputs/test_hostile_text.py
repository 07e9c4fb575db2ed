"""Text from outside is data: every output shows it as it stands or refuses it; it runs nowhere and writes nowhere.

One corpus goes through name, group, id, title and course, and through every output.
"""

from __future__ import annotations

import csv
import io
import json
import re
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import html5lib
import openpyxl
import pytest

from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.outputs.formats import FORMATS

FILES = ["key.csv", "key.pdf", "manifest.json", "sheets.pdf", "solutions.pdf"]
LITERAL = [
    '#read("/etc/passwd")',
    '#sys.inputs #import "common.typ": * ',
    r"$x$ \ # * _ < > & { } ' @ [ ]",
    r"\input{|'ls'} \write18{touch x} \catcode`\^^41 ^^5c",
    r"\end{document} \directlua{os.exit()} % comment",
    "]]> --> */ // /* comment",
    "]]>",
    '=HYPERLINK("x")',
    "=cmd|' /C calc'!A0",
    "../../x",
    r"..\..\x C:\con aux.pdf",
    "; touch x; $(touch x) `touch x` | x",
    "*bold* _slanted_ `raw` ~ <label> @ref",
    "{{ 7 * 7 }} {% raw %} ${HOME} %s %d \\u0041",
    "{1:NUMERICAL:=5:0} {#1} ~%100%",
    "<script>alert(1)</script> <img src=x onerror=alert(1)>",
    '"><svg onload="x"> &amp; &#65; &lt;',
    "?` !` ,, << >> '' -- --- \"= \"a",
    "<r><t>bold</t></r> _x0041_",
    "Ёлкин-Ђорђевић Ñandú Łódź",
    "x" * 5000,
    "name " * 2000,
]
# Not in the fonts of every paper.
STRANGE = [
    "שלום עולם",
    "محمد عبد الله",
    "\N{PILE OF POO}\N{FAMILY}\U0001f468\u200d\U0001f469\u200d\U0001f467",
    "Z\u0351\u0310a\u0327\u0301l\u0322go " + "\u0301" * 50,
    "学生姓名",
    "ไทย",
]
REFUSED = [
    "\u202eevil\u202c", "a\u200bb", "a\ufeffb", "a\u2028b", "\u2066isolate\u2069", "\ue000", "\uffff", "\U0010ffff",
    "a\tb", "a\x00b", "a\x07b", "a\x1bb", "a\x85b", "soft\u00adhyphen",
]  # fmt: skip
PAPER = ("pdf", "latex")
WEB = sorted(set(FORMATS) - set(PAPER))
NAMED = ("pdf", "latex", "html", "moodle", "qti21", "qti30", "xlsx")  # have the names of students, if wanted

HEAD = """
title = {title}
sort = "roster"
course = {title}
language = "en"
formats = {formats}
[moodle]
categories = "students"
[qti21]
tests = "students"
names = true
[qti30]
tests = "students"
names = true
[[problem]]
family = "spool"
ask = ["v_O"]
"""


def build(folder: Path, title: str, names: list[str], outputs: list[str]) -> int:
    """Build an exam in ``folder/work``, each student having a name as id and group too; the exit code.

    Nothing but the output may appear below ``folder``.
    """
    work = folder / "work"
    work.mkdir()
    # Control characters are escaped in TOML; others may stand there.
    quoted = json.dumps(title, ensure_ascii=False).replace("\x85", "\\u0085")
    (work / "exam.toml").write_text(HEAD.format(title=quoted, formats=json.dumps(outputs)), encoding="utf-8")
    out = io.StringIO(newline="")
    csv.writer(out).writerows([("id", "name", "group"), *((f"I{n}", f"N{n}", f"G{n}") for n in names)])
    (work / "class.csv").write_text(out.getvalue(), encoding="utf-8", newline="")
    code = main(["build", str(work / "exam.toml"), "--roster", str(work / "class.csv"), "--out", str(work / "out")])
    assert sorted(path.name for path in folder.iterdir()) == ["work"]
    assert sorted(path.name for path in work.iterdir()) == ["class.csv", "exam.toml", *["out"] * (code == 0)]
    return code


def shown(out: Path, name: str) -> str:
    """Everything that an output shows, without blanks (lines may be broken anywhere)."""
    return squeezed("".join(_shown(out, name)))


def _shown(out: Path, name: str) -> list[str]:
    match name:
        case "pdf":
            return [text for path in sorted(out.glob("*.pdf")) for text in page_texts(path)]
        case "latex":
            return [text for path in sorted((out / "latex").glob("*.pdf")) for text in page_texts(path)]
        case "html":
            return [_page(path.read_text("utf-8")) for path in sorted((out / "html").rglob("*.html"))]
        case "moodle":
            tree = ElementTree.parse(out / "moodle.xml")
            texts = [element.text or "" for element in tree.iter()]
            return [_page(text) if "<" in text else text for text in texts]
        case "prairielearn":
            found = [json.loads(path.read_text("utf-8")) for path in (out / "prairielearn").rglob("info.json")]
            return [text for info in found for text in (info["title"], info["topic"])]
        case "xlsx":
            books = [openpyxl.load_workbook(out / f"{name}.xlsx") for name in ("key", "grading")]
            cells = (cell for book in books for sheet in book for row in sheet.iter_rows() for cell in row)
            return [str(cell.value) for cell in cells if cell.data_type == "s"]
        case _:
            with zipfile.ZipFile(out / f"{name}.zip") as archive:
                trees = [ElementTree.fromstring(archive.read(n)) for n in archive.namelist() if n.endswith(".xml")]
            elements = [element for tree in trees for element in tree.iter()]
            return [text for element in elements for text in (element.text or "", *element.attrib.values())]


def _page(html: str) -> str:
    """The text of a page, which has no element that a name could have brought."""
    tree = html5lib.parse(html, namespaceHTMLElements=False)
    assert not tree.findall(".//script")
    assert not [element for element in tree.iter() for key in element.attrib if str(key).startswith("on")]
    return "".join(tree.itertext())


def squeezed(text: str) -> str:
    return re.sub(r"\s+", "", text)


@pytest.fixture(scope="module")
def literal(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Every output for students with all strange names of Latin and Cyrillic letters."""
    folder = tmp_path_factory.mktemp("literal")
    assert build(folder, f"T1 {LITERAL[3]} {LITERAL[15]}", LITERAL, list(FORMATS)) == 0
    return folder / "work" / "out"


@pytest.mark.parametrize("name", list(FORMATS))
def test_text_appears_as_it_stands(name: str, literal: Path, request: pytest.FixtureRequest) -> None:
    if name == "latex":
        request.getfixturevalue("latexmk")
    seen = shown(literal, name)
    assert any(one in seen for one in written(f"T1 {LITERAL[3]} {LITERAL[15]}"))
    assert "root:x:" not in seen
    if name in NAMED:
        for text in LITERAL:
            # Long words are hyphenated, long names cut in titles: their beginning is enough.
            assert any(one[:60] in seen for one in written(f"N{text}")), text
            assert len(text) > 1000 or any(one in seen for one in written(f"N{text}")), text


def written(text: str) -> set[str]:
    """Ways to write a text: where names hold no brackets, or slashes part them, others stand for these."""
    text = squeezed(text)
    bent = text.replace("<", "‹").replace(">", "›")
    return {text, bent, bent.replace("/", "//")}


def test_files_for_programs_have_the_text_itself(literal: Path) -> None:
    students = json.loads((literal / "manifest.json").read_text("utf-8"))["students"]
    wanted = [tuple(f"{mark}{text}".strip() for mark in "ING") for text in LITERAL]
    assert [(s["id"], s["name"], s["group"]) for s in students] == wanted
    with (literal / "key.csv").open(encoding="utf-8-sig", newline="") as file:
        assert list(dict.fromkeys((row["id"], row["name"], row["group"]) for row in csv.DictReader(file))) == wanted


def test_names_lead_to_no_other_files(literal: Path) -> None:
    """What an output is called depends on codes and on families, not on names."""
    for path in literal.rglob("*"):
        assert re.fullmatch(r"[A-Za-z0-9_.-]+", path.name), path
        assert path.resolve().is_relative_to(literal.resolve())
        assert not path.is_symlink()
    for path in literal.glob("*.zip"):
        with zipfile.ZipFile(path) as archive:
            for name in archive.namelist():
                assert re.fullmatch(r"([a-z]+/)?[A-Za-z0-9_.-]+(/[A-Za-z0-9_.-]+)?", name), name
                assert ".." not in name


@pytest.mark.parametrize("text", LITERAL[:20])
def test_titles(text: str, tmp_path: Path) -> None:
    assert build(tmp_path, f"T1 {text}", ["x"], ["pdf", "html", "moodle"]) == 0
    for name in ("pdf", "html"):
        assert squeezed(f"T1 {text}") in shown(tmp_path / "work" / "out", name)


@pytest.mark.parametrize("text", STRANGE)
def test_strange_letters_are_shown_in_browsers_and_tables(text: str, tmp_path: Path) -> None:
    assert build(tmp_path, text, [text, "Bob"], WEB) == 0
    out = tmp_path / "work" / "out"
    for name in ("html", "xlsx"):
        assert squeezed(f"N{text}") in shown(out, name)
    student = json.loads((out / "manifest.json").read_text("utf-8"))["students"][0]
    assert (student["id"], student["name"], student["group"]) == (f"I{text}", f"N{text}", f"G{text}")


@pytest.mark.parametrize("name", PAPER)
@pytest.mark.parametrize("text", STRANGE)
def test_strange_letters_are_printed_or_refused(
    text: str, name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], request: pytest.FixtureRequest
) -> None:
    if name == "latex":
        request.getfixturevalue("latexmk")
    code = build(tmp_path, "T", ["Bob", text], [name])
    said = capsys.readouterr().err
    if code:
        assert code == 2
        assert f"student I{text}" in said
        assert "U+" in said
    else:
        bare = [letter for letter in squeezed(text) if ord(letter) not in range(0x300, 0x370)]
        assert set(bare) <= set(shown(tmp_path / "work" / "out", name))


@pytest.mark.parametrize("text", REFUSED)
def test_what_cannot_be_seen_is_refused(text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert build(tmp_path, "T", ["Bob", text], WEB) == 2
    said = capsys.readouterr().err
    assert "row 3" in said or "not a text file" in said


@pytest.mark.parametrize("text", REFUSED)
def test_a_title_that_cannot_be_seen_is_refused(text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert build(tmp_path, text, ["Bob"], ["xlsx"]) == 2
    said = capsys.readouterr().err
    assert "exam.toml" in said
    assert "title" in said or "not valid TOML" in said


@pytest.mark.parametrize("start", ["=1+1", "+1", "-1", "@SUM(A1)", "=cmd|' /C calc'!A0", "＝1+1"])
def test_no_cell_of_the_key_is_a_formula(start: str, tmp_path: Path) -> None:
    work = tmp_path / "work"
    work.mkdir()
    (work / "exam.toml").write_text(HEAD.format(title='"T"', formats='["xlsx"]'), "utf-8")
    (work / "class.csv").write_text(f'id,name,group\n"{start}","{start}","{start}"\n2,Bob,B\n', "utf-8")
    arguments = ["build", str(work / "exam.toml"), "--roster", str(work / "class.csv"), "--out", str(work / "out")]
    assert main(arguments) == 0
    with (work / "out" / "key.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    for column in ("id", "name", "group"):
        assert rows[0][column] == "'" + start
        assert rows[-1][column] in {"2", "Bob", "B"}
    assert json.loads((work / "out" / "manifest.json").read_text("utf-8"))["students"][0]["id"] == start


@pytest.mark.parametrize("name", ["-dash", "with space", "ünï·код", "#hash$x", "a'b\"c", "[x]"])
def test_strange_output_folder(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / name
    for options in ([], ["--force"]):
        assert main(["build", "sample_en", "--variants", "1", "--out", str(out), *options]) == 0
        assert [path.name for path in tmp_path.iterdir()] == [name]
        assert sorted(path.name for path in out.iterdir()) == FILES
    assert str(out) in capsys.readouterr().err
