"""Worked solutions in the output folder: for whom, in which language and notation, in which files."""

from __future__ import annotations

import json
import unicodedata
from pathlib import Path
from typing import Any

import pytest

from tests.pdf_text import page_texts
from variantgen.cli import main
from variantgen.figure.views import view_names
from variantgen.resources import languages
from variantgen.wording.solution.phrases import load_phrases

HEAD = 'title = "Quiz"\nlanguage = "en"\nseed = "s"\n'
PROBLEM = '[[problem]]\nfamily = "four_bar"\nform = "crank"\nask = ["v_B", "epsilon_AB"]\n'
EPSILON, ALPHA = "ε", "α"


def build(folder: Path, exam: str, *options: str, students: int = 2) -> Path:
    path, out = folder / "exam.toml", folder / "out"
    path.write_text(exam, "utf-8")
    assert main(["build", str(path), "--variants", str(students), "--out", str(out), *options]) == 0
    return out


def record(out: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((out / "manifest.json").read_text("utf-8"))
    return found


def text(path: Path) -> str:
    """The text of a document; mathematical letters as plain ones."""
    return unicodedata.normalize("NFKC", "".join(page_texts(path))).replace("ϵ", EPSILON)


def four_digits(value: float) -> str:
    return f"{float(f'{value:.3e}'):.6f}".rstrip("0").rstrip(".").replace("-", "\N{MINUS SIGN}")


def test_every_student_has_pages_with_the_answers_of_the_key(tmp_path: Path) -> None:
    out = build(tmp_path, HEAD + PROBLEM, students=3)
    pages = page_texts(out / "solutions.pdf")
    for student in record(out)["students"]:
        first = next(i for i, page in enumerate(pages) if student["code"] in page)
        assert first % 2 == 0, "students start on odd pages"
        own = unicodedata.normalize("NFKC", "".join(page for page in pages if student["code"] in page))
        answer = own.split("Answer:")[1].split("Check")[0]
        for found in student["problems"][0]["answers"]:
            assert four_digits(found["value"]) in answer


def test_a_solution_shows_problem_figures_and_check(tmp_path: Path) -> None:
    said = text(build(tmp_path, HEAD + PROBLEM, students=1) / "solutions.pdf")
    for words in (
        "Problem 1. Four-bar linkage",
        "Directions:",
        "Given:",
        "Determine:",
        "1. Geometry",
        "Answer:",
        "Check",
    ):
        assert words in said, words
    assert said.count("Fig. 1. Given position") == said.count("Fig. 2. Velocities") == said.count("Fig. 3. Acc") == 1
    assert "(Fig. 2)" in said


@pytest.mark.parametrize(
    ("table", "has", "lacks"),
    [
        ('[solutions]\ndepth = "answers"\n', ["Answer:"], ["1. Geometry", "Check", "Fig. 2"]),
        ('[solutions]\ndepth = "short"\n', ["Answer:", "1. Geometry", "Fig. 2"], ["Directions:"]),
        ('[solutions]\nlanguage = "ru"\n', ["Ответ:", "1. Геометрия", "Рис. 1. Заданное", "см/с"], ["Answer"]),
    ],
)
def test_depth_and_language(table: str, has: list[str], lacks: list[str], tmp_path: Path) -> None:
    out = build(tmp_path, HEAD + table + PROBLEM, students=1)
    said = text(out / "solutions.pdf")
    assert [words for words in has if words not in said] == []
    assert [words for words in lacks if words in said] == []
    assert "Problem 1" in text(out / "sheets.pdf"), "the sheets keep the language of the exam"


def test_one_file_for_each_student_on_wish(tmp_path: Path) -> None:
    out = build(tmp_path, HEAD + '[solutions]\nfiles = "students"\n' + PROBLEM, students=2)
    codes = [student["code"] for student in record(out)["students"]]
    assert sorted(path.name for path in (out / "solutions").iterdir()) == sorted(f"{code}.pdf" for code in codes)
    joined = text(out / "solutions.pdf")
    for code in codes:
        said = text(out / "solutions" / f"{code}.pdf")
        assert code in said
        assert not any(other in said for other in codes if other != code)
        assert said in joined
    (tmp_path / "exam.toml").write_text(HEAD + PROBLEM, "utf-8")
    assert main(["build", str(tmp_path / "exam.toml"), "--variants", "1", "--out", str(out), "--force"]) == 0
    assert not (out / "solutions").exists()


@pytest.mark.parametrize(
    ("exam", "options"), [(HEAD + '[solutions]\ndepth = "none"\n', ()), (HEAD, ("--no-solutions",))]
)
def test_no_solutions(exam: str, options: tuple[str, ...], tmp_path: Path) -> None:
    out = build(tmp_path, exam + PROBLEM, *options)
    assert sorted(path.name for path in out.iterdir()) == ["key.csv", "key.pdf", "manifest.json", "sheets.pdf"]
    assert record(out)["solutions"] is None


def test_the_letter_of_angular_acceleration_is_the_same_in_all_documents(tmp_path: Path) -> None:
    names = ("sheets", "key", "solutions")
    table, russian = '[notation]\nangular_acceleration = "{}"\n', HEAD.replace('"en"', '"ru"')
    cases = {
        "usual": (HEAD, ALPHA, EPSILON, "alpha"),
        "other": (HEAD + table.format("epsilon"), EPSILON, ALPHA, "epsilon"),
        "russian": (russian, EPSILON, ALPHA, "epsilon"),
        "russian alpha": (russian + table.format("alpha"), ALPHA, EPSILON, "alpha"),
    }
    for folder, (head, has, lacks, recorded) in cases.items():
        (tmp_path / folder).mkdir()
        out = build(tmp_path / folder, head + PROBLEM, students=1)
        for name in names:
            said = text(out / f"{name}.pdf")
            assert has in said
            assert lacks not in said
        assert record(out)["notation"] == {"angular_acceleration": recorded, "components": "normal"}


def test_the_manifest_records_methods_and_depth(tmp_path: Path) -> None:
    table = '[solutions]\ndepth = "short"\n'
    out = build(tmp_path, HEAD + table + PROBLEM + 'method = "velocity_pole"\n', students=1)
    found = record(out)
    assert found["solutions"] == {"depth": "short", "language": "en", "files": "joined"}
    assert found["students"][0]["problems"][0]["methods"] == ["velocity_pole"]


def test_a_method_that_does_not_apply_stops_the_build(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "exam.toml"
    path.write_text(HEAD + PROBLEM + 'method = "relative_motion"\n', "utf-8")
    assert main(["build", str(path), "--variants", "1", "--out", str(tmp_path / "out")]) == 2
    message = capsys.readouterr().err
    assert f"{path}: problem[1].method: the method does not apply" in message
    assert "velocity_centre" in message
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("language", languages())
def test_every_kind_of_figure_has_a_caption(language: str) -> None:
    captions = [load_phrases(language).sentence(f"figures.{name}") for name in view_names()]
    assert all(captions)
    assert len(set(captions)) == len(captions)
