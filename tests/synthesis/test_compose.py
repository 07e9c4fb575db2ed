"""Composed families: accepted by check, the same each time, in exams; what cannot be made is told."""

from __future__ import annotations

from pathlib import Path

import pytest

from variantgen.check.family import check_family
from variantgen.cli.app import main
from variantgen.families.asking import read_ask
from variantgen.families.cases import load_cases
from variantgen.families.load import load_family
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.steps.step import Sentence
from variantgen.synthesis.levels import level
from variantgen.synthesis.recognition import structures_of
from variantgen.synthesis.structures import parse_code
from variantgen.variants.draw import draw


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("composed") / "one"
    assert main(["compose", "--structure", "RPR01-RRR23", "--seed", "7", "--out", str(folder)]) == 0
    return folder


def test_check_accepts_it_with_its_worked_case(made: Path) -> None:
    report = check_family(str(made), seeds=8)
    assert not report.failures
    assert report.cases == ["moved-1"]


def test_the_same_seed_gives_the_same_files(made: Path, tmp_path: Path) -> None:
    again = tmp_path / "again"
    assert main(["compose", "--structure", "RPR01-RRR23", "--seed", "7", "--out", str(again)]) == 0
    for path in made.iterdir():
        assert path.read_bytes() == (again / path.name).read_bytes()


def test_data_stay_few_and_the_last_dyad_is_asked(made: Path) -> None:
    family = load_family(made)
    form = next(iter(family.forms.values()))
    assert len([name for name, p in form.parameters.items() if p.given and p.unit]) <= 11  # ten, and epsilon_OA
    assert any(name.endswith(tuple(list(form.bodies)[-2:])) for name in form.ask)
    assert load_cases(family)[0].exact.keys() == set(form.ask)


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--groups", "RRR,XYZ"], "unknown dyad"),
        (["--links", "4"], "3, 5 or 7"),
        (["--structure", "RRR01", "--level", "hard"], "calculations"),
        (["--groups", "PRP,RPP", "--links", "5"], "no structure is like that"),
        (["--structure", "RRR"], "code of a structure"),
    ],
)
def test_what_cannot_be_made_is_told(
    options: list[str], told: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["compose", *options, "--out", str(tmp_path / "new")]) == 2
    assert told in capsys.readouterr().err
    assert not (tmp_path / "new").exists()


def test_levels() -> None:
    assert level(parse_code("RRR01")) == level(parse_code("RPR01")) == "easy"
    assert level(parse_code("RRR01-RRP20")) == "medium"
    assert level(parse_code("RRR01-RPR02")) == level(parse_code("RRR01-RRR23")) == "hard"
    assert level(parse_code("RRR01-RRR02-RRR04")) == "hard"


def test_an_exam_of_composed_problems_is_verified(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exam = tmp_path / "exam.toml"
    exam.write_text(
        'title = "Composed"\nlanguage = "en"\n[[problem]]\n'
        'compose = { groups = ["RRP"], links = 3, level = "easy", structures = 2 }\n'
    )
    assert main(["build", str(exam), "--variants", "2", "--out", str(tmp_path / "out")]) == 0
    assert main(["verify", str(tmp_path / "out")]) == 0
    assert "all right" in capsys.readouterr().err
    exam.write_text(exam.read_text().replace("links = 3", "links = 4"))
    assert main(["build", str(exam), "--variants", "2", "--out", str(tmp_path / "no")]) == 2
    assert "3, 5 or 7 moving links" in capsys.readouterr().err


def test_it_has_the_structure_that_it_was_made_for(made: Path) -> None:
    form = next(iter(load_family(made).forms.values()))
    assert parse_code("RPR01-RRR23") in structures_of(form.sample)


def test_structures_are_listed_and_drawn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list", "--structures"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 6 + 68
    assert next(line for line in lines if line.startswith("RRR01 ")).split()[1:4] == ["easy", "four_bar", "crank,"]
    page = tmp_path / "structures.html"
    assert main(["list", "--structures", "--links", "3", "--figure", str(page)]) == 0
    assert page.read_text("utf-8").count("<svg") == 6
    assert main(["list", "--structures", "--figure", str(tmp_path / "page.png")]) == 2


def test_its_solution_is_written_by_three_methods(made: Path) -> None:
    """Its second group hangs on an arm that is fixed to the block of a slotted arm and turns with that."""
    variant = draw(load_family(made), None, [("methods", 1)])[0]
    asked = read_ask(variant.form)
    task = task_of(variant, variant.motion(), 0, asked)
    written = [solution(task, [method]) for method in ("velocity_centre", "graphical", "coordinates")]
    assert all(len(found.answers) == len(asked) for found in written)
    said = [item.key for step in written[0].steps for item in step.items if isinstance(item, Sentence)]
    assert "turning.same_omega" in said
