"""What an exam says at the head of its sheets: instructions, date, duration, deadline; sheets without a name."""

from __future__ import annotations

import json
import re
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import html5lib
import pypdfium2
import pytest

from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.outputs.formats import read_exam

HEAD = 'title = "Midterm"\nlanguage = "{lang}"\nseed = 5\n'
PROBLEM = '[solutions]\ndepth = "none"\n[[problem]]\nfamily = "spool"\nask = ["v_O"]\npoints = 21\n'
ENGLISH = """
date = "12 May 2026"
duration = "90 minutes"
deadline = "Friday, $t = 18$"
instructions = '''
Give velocities in cm/s.
Take $g = 9.8 m/s^2$ and draw $v_O$.

No books; a pen costs 5\\$.
'''
"""
BY_LANGUAGE = """
date = { en = "12 May", ru = "12 мая" }
instructions = { en = "Take $g = 9.8 m/s^2$.", ru = "Принять $g = 9,8 м/с^2$." }
"""


def build(folder: Path, texts: str, *options: str, lang: str = "en", named: bool = False) -> int:
    path, roster = folder / "exam.toml", folder / "class.csv"
    path.write_text(HEAD.format(lang=lang) + texts + PROBLEM, "utf-8")
    roster.write_text("id,name,group\nA7,Ann Lee,G1\nB4,Bob Fox,G1\n", "utf-8")
    students = ["--roster", str(roster)] if named else ["--variants", "2"]
    return main(["build", str(path), *students, "--out", str(folder / "out"), *options])


def page(folder: Path, number: int = 0) -> str:
    """The text of a page of the sheets, in one line."""
    pages = [text for text in page_texts(folder / "out" / "sheets.pdf") if text.strip()]
    return " ".join(pages[number].split())


def article(folder: Path) -> str:
    """The text of the first sheet of the pages for browsers, in one line; the page has no foreign element."""
    tree = html5lib.parse((folder / "out" / "html" / "sheets.html").read_text("utf-8"), namespaceHTMLElements=False)
    assert not tree.findall(".//script")
    assert not tree.findall(".//img")
    return " ".join("".join(tree.find(".//article").itertext()).split())


def test_the_head_of_a_sheet(tmp_path: Path) -> None:
    assert build(tmp_path, ENGLISH, named=True) == 0
    for number in (0, 1):
        said = page(tmp_path, number)
        assert "Date: 12 May 2026 Time: 90 minutes Hand in by: Friday, 𝑡 = 18" in said
        assert "Give velocities in cm/s. Take 𝑔 = 9.8 m/s2 and draw 𝑣𝑂." in said
        assert "No books; a pen costs 5$." in said
        assert "21 points" in said
        assert "Name:" not in said
    assert "Ann Lee" in page(tmp_path, 0)


def test_every_output_with_sheets_shows_it(tmp_path: Path) -> None:
    assert build(tmp_path, ENGLISH, "--format", "html,latex", named=True) == 0
    said = article(tmp_path)
    assert "Date: 12 May 2026 Time: 90 minutes Hand in by: Friday" in said
    assert "Give velocities in cm/s." in said
    assert "No books; a pen costs 5$." in said
    source = (tmp_path / "out" / "latex" / "sheets.tex").read_text("utf-8")
    assert r"\fact{Date:}{12 May 2026}" in source
    assert r"$g = 9.8\,\text{m/s}^{2}$" in source
    assert r"\notice{No books; a pen costs 5\$.}" in source


@pytest.mark.parametrize(("lang", "date", "text"), [("en", "Date: 12 May", "Take"), ("ru", "Дата: 12 мая", "Принять")])
def test_the_text_in_the_language_of_the_sheets(lang: str, date: str, text: str, tmp_path: Path) -> None:
    assert build(tmp_path, BY_LANGUAGE, lang=lang, named=True) == 0
    said = page(tmp_path)
    assert date in said
    assert text in said
    assert ("9,8" in said) == (lang == "ru")
    assert ("Take" in said) == (lang == "en")


@pytest.mark.parametrize(
    ("lang", "words"),
    [("en", ["Variant 1", "Name:", "Group:", "variant 1 · "]), ("ru", ["Вариант 1", "Фамилия, имя:", "Группа:"])],
)
def test_a_sheet_without_a_name(lang: str, words: list[str], tmp_path: Path) -> None:
    assert build(tmp_path, "", "--format", "pdf,html,latex", lang=lang) == 0
    said = page(tmp_path)
    assert all(word in said for word in words)
    assert words[0].replace("1", "2") in page(tmp_path, 1)
    assert all(word in article(tmp_path) for word in words[:3])
    source = (tmp_path / "out" / "latex" / "sheets.tex").read_text("utf-8")
    assert source.count(r"\blanks{") == 2
    code = json.loads((tmp_path / "out" / "manifest.json").read_text("utf-8"))["students"][0]["code"]
    assert code in said


def test_nothing_is_said_that_the_exam_does_not_say(tmp_path: Path) -> None:
    assert build(tmp_path, "", "--format", "pdf,html", named=True) == 0
    for said in (page(tmp_path), article(tmp_path)):
        assert not re.search(r"Date:|Time:|Hand in by:|Name:|Group:", said)


def test_data_do_not_depend_on_texts(tmp_path: Path) -> None:
    found = []
    for name, texts in (("a", ""), ("b", ENGLISH)):
        (tmp_path / name).mkdir()
        assert build(tmp_path / name, texts, "--format", "html") == 0
        students = json.loads((tmp_path / name / "out" / "manifest.json").read_text("utf-8"))["students"]
        found.append(students)
    assert found[0] == found[1]


HOSTILE = [
    '#read("/etc/passwd") #sys.inputs',
    r"\input{|'ls'} \write18{touch x} ^^5c % comment",
    r"\end{document} \directlua{os.exit()}",
    "<script>alert(1)</script> <img src=x onerror=alert(1)> &amp;",
    "{{ 7 * 7 }} {% raw %} *bold* _slanted_ `raw` @ref <label>",
    "]]> --> */ // /* =1+1",
]


@pytest.mark.parametrize("text", HOSTILE)
def test_text_stays_text(text: str, tmp_path: Path, request: pytest.FixtureRequest) -> None:
    request.getfixturevalue("latexmk")
    texts = f"date = {json.dumps(text)}\ninstructions = {json.dumps(text)}\n"
    assert build(tmp_path, texts, "--format", "pdf,html,latex") == 0
    wanted = re.sub(r"\s", "", text)
    shown = {
        "pdf": "".join(page_texts(tmp_path / "out" / "sheets.pdf")),
        "html": article(tmp_path),
        "latex": "".join(page_texts(tmp_path / "out" / "latex" / "sheets.pdf")),
    }
    for name, said in shown.items():
        assert re.sub(r"\s", "", said).count(wanted) >= 2, name
        assert "root:x:" not in said
    assert sorted(path.name for path in tmp_path.iterdir()) == ["class.csv", "exam.toml", "out"]


@pytest.mark.parametrize(
    ("texts", "said"),
    [
        ("date = 2026-05-12\n", ["date: expected a text", "2026-05-12", 'in quotes, for example  date = "12 May']),
        ("duration = 90\n", ["duration: expected a text", "(got 90)"]),
        ('instructions = "Take $g"\n', ["instructions: a dollar sign without the other one"]),
        (r"instructions = 'Take $\input{x}$'" + "\n", [r"instructions: an unknown command \input"]),
        ('date = "a\\u202eb"\n', ["date: the date holds an invisible character", "U+202E"]),
        ('date = "a\\u001b[2J"\n', ["date: the date holds a control character", "U+001B"]),
        ('date = { ru = "12 мая" }\n', ["date: no text in the language of the sheets, en", 'add  en = "..."']),
        ('date = { en = "a", fr = "b" }\n', ["date.fr: unknown language", "en"]),
        ('date = { en = "a", ru = "$x" }\n', ["date.ru: a dollar sign"]),
        ('instruction = "a"\n', ["instruction: unknown key", "did you mean instructions"]),
        (f'date = "{"a" * 20_001}"\n', ["date: the date has 20001 characters"]),
        ('date = "学生"\n', ["the fonts for PDF lack a letter of the date"]),
    ],
)
def test_mistakes(texts: str, said: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code = build(tmp_path, texts)
    message = capsys.readouterr().err
    if "学" in texts and code == 0:
        assert "学生" in page(tmp_path)  # the fonts of this machine have them
        return
    assert code == 2
    assert all(part in message for part in said), message
    assert not (tmp_path / "out").exists()


def test_blanks_alone_say_nothing(tmp_path: Path) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(HEAD.format(lang="en") + 'date = " "\ninstructions = "\\n\\n"\n' + PROBLEM, "utf-8")
    assert not read_exam(path).notices


def test_quizzes_of_canvas_have_it_as_their_description(tmp_path: Path) -> None:
    assert build(tmp_path, ENGLISH, "--format", "canvas") == 0
    with zipfile.ZipFile(tmp_path / "out" / "canvas.zip") as archive:
        metas = [archive.read(name) for name in archive.namelist() if name.endswith("assessment_meta.xml")]
    assert len(metas) == 2
    for meta in metas:
        (described,) = [e for e in ElementTree.fromstring(meta).iter() if e.tag.endswith("}description")]
        said = html5lib.parse(described.text, namespaceHTMLElements=False)
        text = " ".join("".join(said.itertext()).split())
        assert text.startswith("Date: 12 May 2026Time: 90 minutesHand in by: Friday, t")
        assert "draw vO." in text
        assert text.endswith("No books; a pen costs 5$.")


@pytest.mark.parametrize(("version", "rubric"), [("qti21", "rubricBlock"), ("qti30", "qti-rubric-block")])
def test_tests_of_qti_say_it_above_each_sheet(version: str, rubric: str, tmp_path: Path) -> None:
    assert build(tmp_path, ENGLISH, "--format", version) == 0
    with zipfile.ZipFile(tmp_path / "out" / f"{version}.zip") as archive:
        (test,) = [archive.read(name) for name in archive.namelist() if re.fullmatch(r"t[0-9a-f]+\.xml", name)]
    blocks = [e for e in ElementTree.fromstring(test).iter() if e.tag.endswith(f"}}{rubric}")]
    assert len(blocks) == 2
    for block in blocks:
        assert block.get("view") == "candidate"
        assert "Date: 12 May 2026" in " ".join("".join(block.itertext()).split())


def test_bookmarks_of_sheets_without_names(tmp_path: Path) -> None:
    assert build(tmp_path, "") == 0
    codes = [s["code"] for s in json.loads((tmp_path / "out" / "manifest.json").read_text("utf-8"))["students"]]
    document = pypdfium2.PdfDocument(tmp_path / "out" / "sheets.pdf")
    found = [bookmark.get_title() for bookmark in document.get_toc()]
    document.close()
    assert found == [f"Variant 1 · {codes[0]}", f"Variant 2 · {codes[1]}"]
