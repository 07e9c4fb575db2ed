"""The file for Moodle, read back as Moodle reads it: answers, figures, categories, text from outside."""

from __future__ import annotations

import base64
import re
import xml.etree.ElementTree as ET
from decimal import Decimal
from pathlib import Path

import html5lib
import pytest

from tests.outputs.formats.cloze_reader import read_cloze, read_texts, split_category
from tests.outputs.formats.platform_exams import HOSTILE, built, content, hostile_family, key_rows
from variantgen.cli import main
from variantgen.errors import VariantgenError
from variantgen.exam.roster import Student
from variantgen.outputs.formats.moodle import check_xml
from variantgen.outputs.platforms.cloze import weights
from variantgen.outputs.platforms.numbers import number

TWO = '[[problem]]\nfamily = "four_bar"\npoints = 10\n[[problem]]\nfamilies = ["spool", "rolling_wheel"]\n'
MOODLE = 'formats = ["moodle"]\n'
NO_SOLUTIONS = '[solutions]\ndepth = "none"\n'
KNOWN = (
    "alpha angle approx backslash beta cdot circ ddot displaystyle dot eta frac gamma left mathop mathopen mu nolimits "
    "omega operatorname overrightarrow parallel perp phi pi psi right sqrt tau text theta times to varepsilon varphi "
    "vec xi xrightarrow"
)
CLASS = [Student("17", "Иванов Иван", "М-21"), Student("4", "Öztürk Ann", "М-22"), Student("99", "De la Cruz", "М-21")]


def quiz(out: Path) -> ET.Element:
    first, _ = (out / "moodle.xml").read_bytes().split(b"\n", 1)
    assert first == b'<?xml version="1.0" encoding="UTF-8"?>'
    return ET.parse(out / "moodle.xml").getroot()


def by_category(root: ET.Element) -> dict[tuple[str, ...], list[ET.Element]]:
    """The questions of each category, with the names that lead to it."""
    found: dict[tuple[str, ...], list[ET.Element]] = {}
    here: list[ET.Element] = []
    for question in root:
        assert question.tag == "question"
        if question.get("type") == "category":
            path = split_category(output(question, "category"))
            assert path[:2] == ["$course$", "top"]
            here = found.setdefault(tuple(path[2:]), [])
        else:
            assert question.get("type") == "cloze"
            here.append(question)
    return found


def output(question: ET.Element, name: str) -> str:
    return question.findtext(f"{name}/text") or ""


def clozes(root: ET.Element) -> list[ET.Element]:
    return [question for question in root if question.get("type") == "cloze"]


def place(question: ET.Element) -> tuple[str, str]:
    """The code of the sheet and the number of the problem."""
    _, number, code = (question.findtext("idnumber") or "").split("-", 2)
    return code, number


@pytest.mark.parametrize("language", ["ru", "en"])
def test_answers_tolerances_and_marks_are_those_of_the_key(language: str, tmp_path: Path) -> None:
    out = built(tmp_path, MOODLE + NO_SOLUTIONS + TWO, 12, language=language)
    key = key_rows(out)
    questions = clozes(quiz(out))
    assert sorted(map(place, questions)) == sorted(key)
    for question in questions:
        rows = key[place(question)]
        parts = read_cloze(output(question, "questiontext"))
        assert [part.right for part in parts] == [((float(r["value"]), float(r["tolerance"])),) for r in rows]
        shares = [part.weight for part in parts]
        assert sum(shares) == (10 if place(question)[1] == "1" else len(rows))
        assert max(shares) - min(shares) <= 1
    assert not re.search(
        r"NUMERICAL:[^}]*[,+eE]", (out / "moodle.xml").read_text("utf-8").replace("NUMERICAL:=", "NUMERICAL:")
    )


LISTING = '[[problem]]\nfamily = "four_bar"\nask = ["v_B", "omega_AB"]\nmethod = "coordinates"\n'


@pytest.mark.parametrize("language", ["ru", "en"])
def test_moodle_keeps_every_blank_and_every_line(language: str, tmp_path: Path) -> None:
    hostile_family(tmp_path)
    body = MOODLE + TWO + LISTING + '[[problem]]\nfamily = "strange"\n'
    out = built(tmp_path, body, 1, language=language, title=HOSTILE)
    raw = (out / "moodle.xml").read_bytes()
    meant = [element.text or "" for element in quiz(out).iter("text")]
    assert read_texts(raw) == meant
    assert sum(len(text) > 1000 for text in meant) >= 8
    assert b"&gt; &lt;" not in raw
    listings = [
        "".join(code.itertext())
        for text in meant
        for code in html5lib.parseFragment(text, namespaceHTMLElements=False).iter("code")
    ]
    assert listings
    assert all(listing.count("\n") > 5 for listing in listings)


def test_moodle_would_lose_blanks_between_entities() -> None:
    """What the reading above is about: the blank between two tags, where these are written with entities."""
    assert read_texts(b"<q><text>&lt;b&gt; &lt;i&gt; x</text></q>") == ["<b><i> x"]
    assert read_texts(b"<q><text><![CDATA[<b> <i> x ]]]]><![CDATA[> y]]></text></q>") == ["<b> <i> x ]]> y"]


@pytest.mark.parametrize(
    ("language", "note"),
    [
        ("en", "Enter numbers with a decimal point and without units."),
        ("ru", "Вводите числа с десятичной точкой, без единиц измерения."),
    ],
)
def test_students_are_asked_for_a_decimal_point(language: str, note: str, tmp_path: Path) -> None:
    questions = clozes(quiz(built(tmp_path, MOODLE + NO_SOLUTIONS + TWO, 2, language=language)))
    assert all(note in output(question, "questiontext") for question in questions)


def test_an_angle_at_180_degrees_may_have_either_sign(tmp_path: Path) -> None:
    body = '[[problem]]\nfamily = "slider_crank"\nform = ["central"]\nask = ["v_B.angle"]\n'
    out = built(tmp_path, MOODLE + NO_SOLUTIONS + body, 24)
    key, both = key_rows(out), 0
    for question in clozes(quiz(out)):
        (part,) = read_cloze(output(question, "questiontext"))
        (row,) = key[place(question)]
        assert part.right[0] == (float(row["value"]), float(row["tolerance"]))
        if abs(part.right[0][0]) == 180:
            both += 1
            assert part.right[1] == (-part.right[0][0], part.right[0][1])
            assert all(part.accepts(angle) for angle in (-180, 180, -179.9, 179.9, 180.1))
            assert not any(part.accepts(angle) for angle in (-178, 0, 178, 182))
        else:
            assert len(part.right) == 1
    assert both > 2


def test_a_direction_along_an_axis_is_a_short_number(tmp_path: Path) -> None:
    body = '[[problem]]\nfamily = "slider_crank"\nform = ["central"]\nask = ["a_B.angle"]\n'
    out = built(tmp_path, MOODLE + NO_SOLUTIONS + body, 24)
    written = re.findall(r"NUMERICAL:=([^:]*):", (out / "moodle.xml").read_text("utf-8"))
    assert set(written) <= {"0", "90", "-90", "180", "-180"}
    assert "0" in written
    assert {row["value"] for rows in key_rows(out).values() for row in rows} == {f"{number}.0" for number in written}


@pytest.mark.parametrize("form", ["svg", "png"])
def test_every_text_has_its_figures_with_words(form: str, tmp_path: Path) -> None:
    body = f'[moodle]\nfigures = "{form}"\n[[problem]]\nfamily = "four_bar"\n'
    (question,) = clozes(quiz(built(tmp_path, MOODLE + body, 1)))
    for name, least in (("questiontext", 1), ("generalfeedback", 3)):
        element = question.find(name)
        assert element is not None
        page = html5lib.parseFragment(output(question, name), namespaceHTMLElements=False)
        shown = page.findall(".//img")
        assert len(shown) >= least
        assert len(shown[0].get("alt", "")) > 30
        assert all(100 < int(image.get("width", "0")) < 1000 for image in shown)
        files = {f"@@PLUGINFILE@@/{file.get('name')}": file for file in element.findall("file")}
        assert {image.get("src") for image in shown} == set(files)
        for file in files.values():
            assert (file.get("path"), file.get("encoding")) == ("/", "base64")
            data = base64.b64decode(file.text or "", validate=True)
            if form == "png":
                assert data.startswith(b"\x89PNG\r\n\x1a\n")
            else:
                assert ET.fromstring(data).tag == "{http://www.w3.org/2000/svg}svg"


def test_feedback_has_the_solution_as_mathjax_knows_it(tmp_path: Path) -> None:
    body = "".join(f'[[problem]]\nfamily = "{name}"\n' for name in ("four_bar", "planetary_train", "scotch_yoke"))
    out = built(tmp_path, MOODLE + body, 2, language="ru")
    for question in clozes(quiz(out)):
        page = html5lib.parseFragment(output(question, "generalfeedback"), namespaceHTMLElements=False)
        text = "".join(page.itertext())
        assert "Ответ" in text
        assert ("План решения" in text) == bool(re.search(r"9\. [А-Я]", text))  # of nine steps and more
        formulas = re.findall(r"\\\((.*?)\\\)", text)
        assert len(formulas) > 20
        assert not set(re.findall(r"\\([A-Za-z]+)", " ".join(formulas))) - set(KNOWN.split())
        for formula in formulas:
            assert formula.count("{") == formula.count("}")
            assert len(re.findall(r"\\left\b", formula)) == len(re.findall(r"\\right\b", formula))


def test_without_solutions_there_is_no_feedback(tmp_path: Path) -> None:
    for question in clozes(quiz(built(tmp_path, MOODLE + NO_SOLUTIONS + TWO))):
        assert output(question, "generalfeedback") == ""
        assert question.findall("generalfeedback/file") == []


def test_a_bank_has_a_category_for_each_family_and_no_names(tmp_path: Path) -> None:
    out = built(tmp_path, MOODLE + NO_SOLUTIONS + TWO, title="Test 1", students=CLASS)
    found = by_category(quiz(out))
    assert {names[0] for names in found} == {"Test 1"}
    assert ("Test 1", "1. Four-bar linkage") in found
    assert len(found["Test 1", "1. Four-bar linkage"]) == 3
    assert sum(len(own) for names, own in found.items() if names[1].startswith("2. ")) == 3
    for own in found.values():
        numbers = [question.findtext("idnumber") for question in own]
        assert len(set(numbers)) == len(numbers)
        assert all(number and len(number) <= 100 for number in numbers)
    raw = (out / "moodle.xml").read_text("utf-8")
    assert not any(word in raw for student in CLASS for word in (student.name, student.name.split()[-1], student.group))


def test_a_category_for_each_student(tmp_path: Path) -> None:
    body = '[moodle]\ncategories = "students"\n'
    found = by_category(quiz(built(tmp_path, MOODLE + NO_SOLUTIONS + body + TWO, students=CLASS)))
    assert [names[:2] for names in found] == [("T", student.group) for student in CLASS]
    for names, student in zip(found, CLASS, strict=True):
        name, code = names[2].split(" · ")
        assert name == student.name
        assert [place(question) for question in found[names]] == [(code, "1"), (code, "2")]


@pytest.mark.parametrize("categories", ["families", "students"])
def test_text_from_outside_is_text(categories: str, tmp_path: Path) -> None:
    hostile_family(tmp_path)
    body = f'[moodle]\ncategories = "{categories}"\n[[problem]]\nfamily = "strange"\npoints = 7\n'
    students = [Student("1", HOSTILE, HOSTILE), Student("2", "x\ue000" * 200, "/")]
    out = built(tmp_path, MOODLE + body, title=HOSTILE, students=students)
    key = key_rows(out)
    shown = HOSTILE.replace("<", "‹").replace(">", "›")
    found = by_category(quiz(out))
    assert {names[0] for names in found} == {shown}
    if categories == "students":
        assert [names[1] for names in found] == [shown, "/"]
    for question in (question for own in found.values() for question in own):
        text = output(question, "questiontext")
        parts = read_cloze(text)
        assert [part.right[0][0] for part in parts] == [float(row["value"]) for row in key[place(question)]]
        assert sum(part.weight for part in parts) == 7
        page = html5lib.parseFragment(text, namespaceHTMLElements=False)
        assert page.find(".//script") is None
        assert HOSTILE in "".join(page.itertext())
        assert output(question, "name").startswith(f"1. {shown} · ")
        for name in (output(question, "name"), *(name for names in found for name in names)):
            assert len(name) <= 255 and "<" not in name


def test_the_same_bytes_for_any_number_of_processes(tmp_path: Path) -> None:
    body = MOODLE + NO_SOLUTIONS + TWO
    one, two = (content(built(tmp_path / str(jobs), body, 10, jobs=jobs)) for jobs in (1, 2))
    assert one == two
    assert one.keys() == {"moodle.xml", "key.csv", "manifest.json"}


def test_mistakes_in_options_are_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam = tmp_path / "exam.toml"
    exam.write_text(
        f'title = "T"\nlanguage = "en"\n{MOODLE}[moodle]\nfigures = "gif"\ncategories = "student"\nfigure = 1\n{TWO}',
        "utf-8",
    )
    assert main(["build", str(exam), "--variants", "1", "--out", str(tmp_path / "out")]) == 2
    told_ = capsys.readouterr().err
    for words in (
        'moodle.figures: expected one of "svg", "png" (got gif)',
        'moodle.categories: expected one of "families", "students" (got student)',
        "did you mean students?",
        "moodle.figure: unknown key",
    ):
        assert words in told_


def test_a_file_that_is_no_xml_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "moodle.xml"
    path.write_text("<quiz>" + "<question/>" * 3 + "</quiz>")
    check_xml(path)
    for broken in ("<quiz>", "<quiz>&nbsp;</quiz>", "<quiz>\x01</quiz>", "<quiz></quiz></quiz>"):
        path.write_text(broken)
        with pytest.raises(VariantgenError, match=r"moodle\.xml would not be XML"):
            check_xml(path)


def test_weights_keep_the_points() -> None:
    assert weights(10, 4) == (3, 3, 2, 2)
    assert weights(6, 3) == (2, 2, 2)
    assert weights(3, 3) == weights(2, 3) == weights(None, 3) == (1, 1, 1)


def test_numbers_are_plain() -> None:
    numbers = ["1E+2", "1e-7", "-0.0", "12.500", "-3", "100"]
    assert [number(Decimal(text)) for text in numbers] == ["100", "0.0000001", "0", "12.5", "-3", "100"]
