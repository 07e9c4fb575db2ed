"""``solve`` and ``show``: the document that scripts may rely on."""

from __future__ import annotations

import json
from math import sqrt
from pathlib import Path

import pytest

from tests.scene_files import scene_file
from variantgen.cli import main

K27 = ["OA=200", "OC=100", "AB=200", "h=200", "phi=90", "sense=clockwise", "branch=ahead", "omega_OA=1", "epsilon_OA=0"]


def solved(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict[str, object]:
    assert main(["solve", *arguments, "--json"]) == 0
    captured = capsys.readouterr()
    assert captured.err == ""
    document: dict[str, object] = json.loads(captured.out)
    return document


def test_document_of_a_worked_case(capsys: pytest.CaptureFixture[str]) -> None:
    settings = [part for text in K27 for part in ("--set", text)]
    found = solved(capsys, "sleeve_on_crank", *settings)
    assert list(found) == ["family", "form", "parameters", "outcome", "points", "bodies", "relative", "answers"]
    assert found["outcome"] == "solved"
    assert found["parameters"]["OA"] == {"value": 200.0, "unit": "cm", "si": 2.0}
    assert found["points"]["B"]["position"] == pytest.approx([2, 2])
    assert found["points"]["B"]["velocity"] == pytest.approx([2, 0])
    assert found["points"]["B"]["acceleration"] == pytest.approx([0, 0])
    assert found["bodies"]["AB"]["omega"] == 0.0
    assert found["bodies"]["AB"]["velocity_centre"] is None
    relative = found["relative"]["C"]
    assert relative["body"] == "BD"
    assert sum(x * x for x in relative["velocity"]) == pytest.approx(4 / 5)
    assert sum(x * x for x in relative["acceleration"]) == pytest.approx((6 * sqrt(5) / 25) ** 2)
    answers = {answer["quantity"]: answer for answer in found["answers"]}
    assert answers["v_rel_C"]["value"] == pytest.approx(200 / sqrt(5))
    assert answers["v_rel_C"]["unit"] == "cm/s"
    assert answers["v_rel_C"]["tolerance"] == pytest.approx(2 / sqrt(5), rel=1e-2)


def test_parts_that_were_not_computed_are_absent(capsys: pytest.CaptureFixture[str]) -> None:
    found = solved(capsys, "four_bar", "--ask", "v_B")
    assert "relative" not in found
    assert "acceleration" not in found["points"]["B"]
    assert "epsilon" not in found["bodies"]["AB"]


def test_same_seed_same_document(capsys: pytest.CaptureFixture[str]) -> None:
    first = solved(capsys, "slider_crank", "--seed", "abc")
    assert solved(capsys, "slider_crank", "--seed", "abc") == first
    assert solved(capsys, "slider_crank", "--seed", "abd") != first


SCENE = """
length_unit = "cm"
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = 20, angle = 90 } }
B = { line_circle = { through = "O", centre = "A", distance = "0.4 m" } }
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B" }
[[drivers]]
rotation = { body = "OA", omega = 2 }
"""


def test_a_scene_file_without_parameters(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = scene_file(tmp_path, SCENE)
    found = solved(capsys, str(path))
    # Crank across the line of the slider: the rod is in translation, v_B = v_A = 40 cm/s.
    assert found["bodies"]["AB"]["omega"] == 0.0
    assert {a["quantity"]: a["value"] for a in found["answers"]}["v_B"] == pytest.approx(40)


def test_a_scene_that_does_not_assemble(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = scene_file(tmp_path, SCENE.replace("0.4 m", "10 cm"))
    assert main(["solve", str(path), "--json"]) == 2
    captured = capsys.readouterr()
    assert json.loads(captured.out)["outcome"] == "not_assembled"
    assert "does not assemble" in captured.err


@pytest.mark.parametrize(("lang", "word"), [("en", "Given:"), ("ru", "Дано:")])
def test_show_prints_a_problem(lang: str, word: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["show", "four_bar", "--lang", lang, "--seed", "3"]) == 0
    assert word in capsys.readouterr().out


@pytest.mark.parametrize(("ending", "start"), [("pdf", b"%PDF"), ("png", b"\x89PNG"), ("svg", b"<svg")])
def test_show_writes_a_page(ending: str, start: bytes, tmp_path: Path) -> None:
    out = tmp_path / f"page.{ending}"
    assert main(["show", "spool", "--out", str(out)]) == 0
    assert out.read_bytes().startswith(start)


def test_show_refuses_an_unknown_ending(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["show", "spool", "--out", str(tmp_path / "page.docx")]) == 2
    assert "unknown format" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("ending", "start"),
    [
        ("svg", b"<?xml"),
        ("png", b"\x89PNG"),
        ("pdf", b"%PDF"),
        ("tikz", b"\\begin{tikzpicture}"),
        ("tex", b"\\documentclass{article}"),
    ],
)
def test_show_writes_the_figure_alone(ending: str, start: bytes, tmp_path: Path) -> None:
    figure, page = tmp_path / f"figure.{ending}", tmp_path / "page.svg"
    assert main(["show", "slider_crank", "--figure", str(figure), "--out", str(page), "--lang", "ru"]) == 0
    assert start in figure.read_bytes()
    assert page.read_bytes().startswith(b"<svg")
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted((figure.name, page.name))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--figure", "figure.docx"], "unknown format of a figure"),
        (["--figure", "nowhere/figure.svg"], "cannot be written"),
        (["--figure", "figure.svg", "--view", "statment"], "statement"),
    ],
)
def test_show_refuses_a_figure_that_cannot_be(
    arguments: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["show", "slider_crank", *arguments]) == 2
    assert said in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_a_given_quantity_cannot_be_asked(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", "four_bar", "--form", "crank", "--ask", "omega_OA"]) == 2
    assert "is given" in capsys.readouterr().err


def test_show_screens_for_what_is_asked(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["show", "rolling_wheel", "--set", "a_O=0", "--ask", "a_A"]) == 0
    out = capsys.readouterr().out
    assert "constant" in out
    assert "a_O" not in out
    assert main(["show", "rolling_wheel", "--ask", "v_P"]) == 2
    assert "v_P not trivial" in capsys.readouterr().err


def test_a_parameter_set_twice(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", "four_bar", "--set", "OA=20", "--set", "OA=22"]) == 2
    assert "set twice" in capsys.readouterr().err


@pytest.mark.parametrize("family", ["four_bar", "slider_crank", "sleeve_on_crank", "rolling_wheel", "spool"])
def test_output_that_cannot_be_written(family: str) -> None:
    import subprocess
    import sys

    with open("/dev/full", "w") as full:  # noqa: PTH123  (a device)
        done = subprocess.run(
            [sys.executable, "-m", "variantgen", "solve", family, "--json"],
            check=False,
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
        )
    assert done.returncode == 2
    assert "Traceback" not in done.stderr
    assert "writing failed" in done.stderr


def test_show_writes_the_figure_of_each_kind(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = set()
    for kind in ("statement", "velocities", "accelerations", "velocity_plan", "acceleration_plan"):
        path = tmp_path / f"{kind}.svg"
        assert main(["show", "four_bar", "--seed", "3", "--lang", "ru", "--view", kind, "--figure", str(path)]) == 0
        assert path.read_text("utf-8").endswith("</svg>\n")
        made.add(path.read_text("utf-8"))
    assert len(made) == 5
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "written" in captured.err


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--figure", "figure.svg", "--view", "velocity_pln"], "did you mean velocity_plan"),
        (["--figure", "figure.jpeg"], "unknown format of a figure"),
        (["--figure", "nowhere/figure.svg"], "cannot be written"),
    ],
)
def test_show_says_what_is_wrong_with_a_figure(
    arguments: list[str], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["show", "four_bar", *arguments]) == 2
    assert said in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("lang", "words"), [("en", ["1. Geometry", "Answer:", "Check."]), ("ru", ["1. Геометрия", "Ответ:", "Проверка."])]
)
def test_solve_explains(lang: str, words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", "four_bar", "--seed", "3", "--explain", "--lang", lang]) == 0
    said = capsys.readouterr().out
    assert [word for word in words if word not in said] == []
    assert max(map(len, said.splitlines())) <= 100


def test_the_method_and_depth_of_an_explanation_are_chosen(capsys: pytest.CaptureFixture[str]) -> None:
    command = ["solve", "four_bar", "--seed", "3", "--explain", "--ask", "v_B"]
    said = []
    for options in ([], ["--method", "velocity_pole"], ["--depth", "short"], ["--depth", "answers"]):
        assert main([*command, *options]) == 0
        said.append(capsys.readouterr().out)
    assert len(set(said)) == 4
    assert len(said[3]) < len(said[2]) < len(said[0])
    assert len({text.split("Answer:")[1].split("\n")[0] for text in said}) == 1


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--explain", "--method", "centre"], ["method: unknown method", "centre"]),
        (["--explain", "--depth", "long"], ["depth: unknown depth", "long"]),
        (["--explain", "--notation", "beta"], ["--notation", "beta"]),
        (["--explain", "--lang", "xx"], ["language", "xx"]),
        (["--explain", "--json"], ["--json", "choose"]),
        (["--method", "graphical"], ["--method", "add --explain"]),
    ],
)
def test_wrong_wishes(options: list[str], words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["solve", "four_bar", *options]) == 2
    message = capsys.readouterr().err
    assert [word for word in words if word not in message] == []


@pytest.mark.parametrize(("ending", "start"), [("pdf", b"%PDF"), ("png", b"\x89PNG"), ("svg", b"<svg")])
def test_show_writes_a_page_with_the_solution(ending: str, start: bytes, tmp_path: Path) -> None:
    plain, out = tmp_path / f"plain.{ending}", tmp_path / f"page.{ending}"
    command = ["show", "slider_crank", "--lang", "ru", "--out"]
    assert main([*command, str(plain)]) == 0
    assert main([*command, str(out), "--explain"]) == 0
    assert out.read_bytes().startswith(start)
    assert len(out.read_bytes()) > 1.3 * len(plain.read_bytes())


def test_show_prints_problem_and_solution(capsys: pytest.CaptureFixture[str]) -> None:
    """A solution of many steps begins with a plan."""
    scene = Path(__file__).parent / "textbook_kinds" / "toggle_press.toml"
    assert main(["show", str(scene), "--explain"]) == 0
    said = capsys.readouterr().out
    assert said.index("Given:") < said.index("Plan:") < said.index("Answer:")
