"""``list FAMILY``, ``solve --all`` and ``--range``: what an author of exams looks up."""

from __future__ import annotations

import json
import math
import re

import pytest

from variantgen.cli import main
from variantgen.exam.exam_file import parse_exam
from variantgen.families.reading.folders import family_names

# A crank of 20 cm at 30 degrees and a rod of 50 cm to a slider on the axis x; 2 rad/s.
CRANK = """
length_unit = "cm"
ask = ["v_B"]
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = 20, angle = 30 } }
B = { line_circle = { through = "O", centre = "A", distance = 50, angle = 0 } }
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B", angle = 0 }
[[drivers]]
rotation = { body = "OA", omega = 2 }
"""


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "crank.toml"
    path.write_text(CRANK, encoding="utf-8")
    return path


def _rows(text: str) -> dict[str, list[str]]:
    """Rows of the terminal's tables by their first word; of those of a name the first."""
    found: dict[str, list[str]] = {}
    for line in text.splitlines():
        if line.strip():
            found.setdefault(line.split()[0], line.split()[1:])
    return found


def test_a_family_with_its_forms(capsys):
    assert main(["list", "slider_crank"]) == 0
    out = capsys.readouterr().out
    assert "form central\n" in out
    assert "form driven_by_slider\n" in out
    assert re.search(r"^  OA +cm +10 to 40, step 1$", out, re.MULTILINE)
    assert re.search(r"^  sense +counter_clockwise or clockwise$", out, re.MULTILINE)
    assert re.search(r"^\* omega_AB +ω_AB +rad/s +\.abs +\.sense$", out, re.MULTILINE)
    assert re.search(r"^  v_A +v_A +cm/s +\.x +\.y +\.angle \(deg\)$", out, re.MULTILINE)
    assert '[[problem]]\nfamily = "slider_crank"\n' in out


def test_the_work_of_each_form(capsys):
    """18 calculations for the spool and 30 for the wheel are counted on paper, as in test_fairness."""
    assert main(["list"]) == 0
    lines = {line.split()[0]: line for line in capsys.readouterr().out.splitlines()}
    assert lines["spool"].endswith("[18 easy]")
    assert lines["rolling_wheel"].endswith("[30 easy]")
    assert "[central 43 medium, " in lines["slider_crank"]
    assert main(["list", "spool"]) == 0
    assert "work: some 18 calculations (easy)\n" in capsys.readouterr().out


def test_the_document_of_a_family(capsys):
    assert main(["list", "slider_crank", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert list(found) == ["family", "title", "source", "length_unit", "forms", "problem"]
    central = found["forms"][0]
    assert central["form"] == "central"
    assert central["parameters"]["OA"] == {"symbol": "OA", "unit": "cm", "from": 10.0, "to": 40.0, "step": 1.0}
    assert central["parameters"]["sense"] == {"choices": ["counter_clockwise", "clockwise"]}
    assert {"quantity": "v_B.angle", "symbol": "∠(v_B, x)", "unit": "deg"} in central["can_be_asked"]
    assert {"quantity": "rho_B", "symbol": "ρ_B", "unit": "cm"} in central["likewise"]
    assert "omega_OA" not in [item["quantity"] for item in central["can_be_asked"]]  # it is given


def test_values_of_a_turn_that_are_asked_by_themselves_are_listed(capsys):
    assert main(["list", "limit_positions"]) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert sum(line[:2] == ["*", "stroke_B"] for line in lines) == 1
    assert [line[-1] for line in lines if line[1:2] == ["stroke_B"]] == ["cm"]
    assert [line[-1] for line in lines if line[1:2] == ["swing_BC"]] == ["deg"]


@pytest.mark.parametrize("family", family_names())
def test_the_problem_can_be_pasted(family, capsys, tmp_path):
    """As it stands, and with each of its comments in force."""
    assert main(["list", family, "--json"]) == 0
    problem = json.loads(capsys.readouterr().out)["problem"]
    head = 'title = "T"\ncourse = ""\nlanguage = "en"\n'
    plain = parse_exam(head + problem, tmp_path / "exam.toml", ())
    assert [f.name for f in plain.tasks[0].families] == [family]
    ranged = [line for line in problem.splitlines() if line.startswith("# ")]
    whole = problem.replace("# ", "")
    chosen = parse_exam(head + whole, tmp_path / "exam.toml", ())
    assert bool(ranged) == (chosen.text != plain.text)
    assert chosen.tasks[0].points == plain.tasks[0].points


def test_figures_of_the_forms(tmp_path, capsys):
    assert main(["list", "slider_crank", "--figure", str(tmp_path / "f.svg")]) == 0
    forms = ["central", "driven_by_slider", "offset"]
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"f-{form}.svg" for form in forms]
    assert "figure:" not in capsys.readouterr().out


def test_a_scene(scene, capsys):
    assert main(["list", str(scene)]) == 0
    out = capsys.readouterr().out
    assert "no parameters: one variant" in out
    assert f'family = "{scene}"' in out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["list", "four_barr"], "did you mean four_bar"),
        (["list", "--figure", "f.svg"], "of which family?"),
        (["list", "four_bar", "--figure", "."], "unknown format of a figure"),
        (["list", "four_bar", "--figure", "x.bmp"], "unknown format of a figure (got x.bmp)"),
    ],
)
def test_wrong_wishes(arguments, said, capsys):
    assert main(arguments) == 2
    assert said in capsys.readouterr().err


def test_everything_of_a_scene(scene, capsys):
    """By the formulas of the slider-crank, x = r cos phi + c cos psi with sin psi = r sin phi / c."""
    assert main(["solve", str(scene), "--all"]) == 0
    rows = _rows(capsys.readouterr().out)
    r, c, phi, w = 20.0, 50.0, math.radians(30), 2.0
    psi = math.asin(r * math.sin(phi) / c)
    turn = r * w * math.cos(phi) / (c * math.cos(psi))
    x = r * math.cos(phi) + c * math.cos(psi)
    v = r * w * math.sin(phi) + c * turn * math.sin(psi)
    heads = rows["points"]
    place = {name: float(rows["B"][heads.index(name)]) for name in ("x", "y", "v", "v.x", "v.y", "v.angle")}
    assert place == {
        "x": pytest.approx(x, rel=1e-4), "y": 0, "v": pytest.approx(v, rel=1e-4), "v.x": pytest.approx(-v, rel=1e-4),
        "v.y": 0, "v.angle": 180,
    }  # fmt: skip
    heads = rows["bodies"]
    assert float(rows["AB"][heads.index("omega")]) == pytest.approx(-turn, rel=1e-4)
    assert float(rows["AB"][heads.index("length")]) == 50
    # The velocity centre is above B, on the line of the crank.
    assert float(rows["AB"][heads.index("P.x")]) == pytest.approx(x, rel=1e-4)
    assert float(rows["AB"][heads.index("P.y")]) == pytest.approx(x * math.tan(phi), rel=1e-4)
    assert rows["O"][2:6] == ["0", "0", "0", "-"]


def test_curvature_of_paths(scene, capsys):
    """The pin of the crank runs on its circle: a_n = r w^2; the slider on a line."""
    assert main(["solve", str(scene), "--all", "--json"]) == 0
    tables = json.loads(capsys.readouterr().out)["tables"]
    paths = next(table["rows"] for table in tables if table["title"] == "paths")
    assert paths["A"] == [pytest.approx(0, abs=1e-9), pytest.approx(80), pytest.approx(20)]
    assert paths["B"][1:] == [0, None]


def test_everything_as_data(scene, capsys):
    assert main(["solve", str(scene), "--all", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    values = {item["quantity"]: (item["value"], item["unit"]) for item in found["all"]}
    assert values["v_A"] == (pytest.approx(40), "cm/s")
    assert values["a_A.angle"] == (pytest.approx(-150), "deg")
    assert values["omega_OA.sense"] == (1, "1")
    assert [table["title"] for table in found["tables"]] == ["points", "paths", "bodies"]
    assert found["answers"][0]["quantity"] == "v_B"


def test_a_centre_at_infinity_has_no_place(capsys):
    assert main(["solve", "parallelogram_with_disc", "--all", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    bodies = next(table for table in found["tables"] if table["title"] == "bodies")
    column = [item["name"] for item in bodies["columns"]].index("P.x")
    assert any(row[column] is None for row in bodies["rows"].values())


@pytest.mark.parametrize("whole", ["--all", "--json"])
@pytest.mark.parametrize("wish", [["--method", "pole"], ["--depth", "full"], ["--notation", "alpha"]])
def test_wishes_of_a_solution_need_one(whole, wish, scene, capsys):
    assert main(["solve", str(scene), whole, *wish]) == 2
    assert f"{wish[0]}: only has a meaning for solutions" in capsys.readouterr().err


def test_tables_hold_what_is_asked_already(scene, capsys):
    assert main(["solve", str(scene), "--all", "--ask", "v_A"]) == 2
    assert "leave out --all or --ask" in capsys.readouterr().err


@pytest.mark.parametrize("seed", ["1", "2", "3"])
def test_a_range(seed, capsys):
    wishes = ["--range", "phi=30..60", "--range", "side=left", "--seed", seed]
    assert main(["solve", "four_bar", "--form", "crank", "--json", *wishes]) == 0
    found = json.loads(capsys.readouterr().out)["parameters"]
    assert 30 <= found["phi"]["value"] <= 60
    assert found["side"]["value"] == "left"


@pytest.mark.parametrize(
    ("wish", "said"),
    [
        ("phi", "expected NAME=LOW..HIGH"),
        ("phi=30", "expected [lowest, highest]"),
        ("phi=70..60", "the lowest comes first"),
        ("side=up", "unknown word"),
        ("psi=1..2", "unknown parameter"),
    ],
)
def test_a_wrong_range(wish, said, capsys):
    assert main(["show", "four_bar", "--range", wish]) == 2
    assert said in capsys.readouterr().err
