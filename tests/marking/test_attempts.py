"""Attempts on learning platforms: the program's own questions, and reports as Moodle and Canvas write them."""

from __future__ import annotations

import csv
import re
import zipfile
from html import unescape
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.marking.test_marks import EXAM, STUDENTS, key, order, rows
from variantgen.cli import main
from variantgen.marking.attempts import parts

NAMES = {"s1": ("Ann", "Lee"), "s2": ("Bob", "Ray"), "s3": ("Cy", "Young")}


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("platforms")
    text = EXAM.replace('formats = ["xlsx"]', 'formats = ["moodle", "canvas"]')
    (folder / "exam.toml").write_text(text, "utf-8")
    (folder / "class.csv").write_text(STUDENTS, "utf-8")
    words = ["build", str(folder / "exam.toml"), "--roster", str(folder / "class.csv"), "--out", str(folder / "out")]
    assert main(words) == 0
    return folder / "out"


def text_of(html: str) -> str:
    """HTML as a report shows it."""
    return " ".join(unescape(re.sub(r"<[^>]*>", " ", html)).split())


def codes(exam: Path) -> dict[str, str]:
    return {row["id"]: row["code"] for row in rows(exam / "key.csv")}


def marked(exam: Path, table: Path, out: Path) -> dict[tuple[str, str], str]:
    assert main(["mark", str(exam), str(table), "--out", str(out)]) == 0
    return {(row["id"], f"{row['problem']}.{row['quantity']}"): row["verdict"] for row in rows(out / "marks.csv")}


def moodle_questions(exam: Path) -> dict[tuple[str, int], str]:
    """The texts of questions as Moodle shows them in a report, by the code of the sheet and the problem."""
    found = {}
    for question in ElementTree.parse(exam / "moodle.xml").getroot().iter("question"):
        if question.get("type") == "cloze":
            name = question.findtext("name/text") or ""
            text = re.sub(r"\{[^}]*\}", "_____", question.findtext("questiontext/text") or "")
            found[name.split(" · ")[1], int(name.split(".")[0])] = text_of(text)
    return found


def moodle_report(exam: Path, path: Path, asked: dict[str, str], texts: bool = True) -> Path:
    """A report of responses: every student answers the questions of a sheet rightly, with a decimal comma."""
    right, own, questions = key(exam), codes(exam), moodle_questions(exam)
    head = ["Last name", "First name", "ID number", "State", "Grade/9.00"]
    for number in (1, 2):
        head += [f"Question {number}"] * texts + [f"Response {number}"]
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(head)
        for who, whose in asked.items():
            first, last = NAMES[who]
            cells = [last, first, "" if who == "s2" else who, "Finished", "7.00"]
            for number in (1, 2):
                answers = [v for (i, name), v in right.items() if i == whose and name.startswith(f"{number}.")]
                response = "; ".join(f"part {k}: {v:.6g}".replace(".", ",") for k, v in enumerate(answers, start=1))
                cells += [questions[own[whose], number]] * texts + [response]
            writer.writerow(cells)
        writer.writerow(["Overall average", "", "", "", "7.00", *["-"] * (4 if texts else 2)])
    return path


def test_moodle(exam: Path, tmp_path: Path) -> None:
    """One student has the own questions and no id, one those of another sheet; the third did nothing."""
    first, second, third = order(exam)
    report = moodle_report(exam, tmp_path / "responses.csv", {first: third, second: second})
    verdicts = marked(exam, report, tmp_path / "marks")
    assert {who for (who, _), verdict in verdicts.items() if verdict == "right"} == {first, second}
    assert {verdict for (who, _), verdict in verdicts.items() if who == third} == {"blank"}
    assert sum(verdict == "right" for verdict in verdicts.values()) == 10
    assert rows(tmp_path / "marks" / "not_matched.csv") == []
    right = key(exam)
    found = {row["id"]: row for row in rows(tmp_path / "marks" / "marks.csv") if row["quantity"] == "v_B"}
    assert float(found[first]["key"]) == pytest.approx(right[third, "1.v_B"])


def test_a_name_beside_the_id(exam: Path, tmp_path: Path) -> None:
    """The id of one student and the name of another are told and not marked; a name nobody has is told and marked."""
    report = moodle_report(exam, tmp_path / "responses.csv", {"s1": "s1", "s3": "s3"})
    lines = report.read_text("utf-8").replace("Lee,Ann", "Ray,Bob").replace("Young,Cy", "Young,Cyril")
    report.write_text(lines, "utf-8")
    verdicts = marked(exam, report, tmp_path / "marks")
    assert {who for (who, _), verdict in verdicts.items() if verdict == "right"} == {"s3"}
    left = rows(tmp_path / "marks" / "not_matched.csv")
    assert {row["why"] for row in left} == {
        "the class list has no such name: marked by the id alone",
        "the words of this row name different students",
    }


def test_moodle_without_the_texts_of_questions(exam: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    report = moodle_report(exam, tmp_path / "responses.csv", {"s1": "s1"}, texts=False)
    assert main(["mark", str(exam), str(report), "--out", str(tmp_path / "marks")]) == 2
    assert "question text" in capsys.readouterr().err
    assert not (tmp_path / "marks").exists()


def test_canvas(exam: Path, tmp_path: Path) -> None:
    """The report of the quiz of one student: a column with the text of each question, one with its points."""
    right, first = key(exam), order(exam)[0]
    with zipfile.ZipFile(exam / "canvas.zip") as package:
        name = next(n for n in package.namelist() if codes(exam)[first] in n and b"<presentation>" in package.read(n))
        quiz = ElementTree.fromstring(package.read(name))
    texts = [text_of(text.text or "") for text in quiz.iterfind(".//{*}presentation//{*}mattext")]
    answers = [value for (who, _), value in right.items() if who == first]
    assert len(texts) == len(answers) == 5
    with (tmp_path / "analysis.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        columns = [cell for k, text in enumerate(texts) for cell in (f"{100 + k}: {text}", "2.0")]
        writer.writerow(
            [
                "name",
                "id",
                "sis_id",
                "section",
                "section_id",
                "section_sis_id",
                "submitted",
                *columns,
                "n correct",
                "score",
            ]
        )
        cells = [cell for value in answers for cell in (f"{value:.6g}", "2.0")]
        writer.writerow(
            [" ".join(NAMES[first]), "4711", first, "A", "9", "", "2026-01-01 10:00:00 UTC", *cells, "5", "9.0"]
        )
    verdicts = marked(exam, tmp_path / "analysis.csv", tmp_path / "marks")
    assert [verdict for (who, _), verdict in verdicts.items() if who == first] == ["right"] * 5


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("part 1: 47,5; part 2: -0.54", ["47,5", "-0.54"]),
        ("часть 1: ; часть 2: 3; часть 3:", ["", "3", ""]),
        ("part 1: 5", ["5"]),
        ("-", []),
        ("part 2: 5", []),
    ],
)
def test_parts_of_a_response(text: str, found: list[str]) -> None:
    assert parts(text) == found
