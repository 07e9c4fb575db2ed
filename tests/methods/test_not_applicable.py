"""What no method goes through link by link has answers all the same, tolerances by its data, steps by coordinates."""

from __future__ import annotations

import json

import pytest

from tests.scene_files import scene_file, solved_items
from tests.scene_texts import CRANK
from variantgen.cli import main
from variantgen.methods import compose
from variantgen.methods.by_groups import solve_groups
from variantgen.methods.steps.not_applicable import NotApplicableError

# A body on a level line, its three points driven and guided upright: no velocity tells a second direction.
LEVEL = """
length_unit = "cm"
ask = ["omega_p", "v_O"]
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { coordinates = { x = 10, y = 0 } }
B = { coordinates = { x = 30, y = 0 } }
[bodies]
p = ["O", "A", "B"]
[[joints]]
guide = { point = "O", angle = 90 }
[[drivers]]
travel = { point = "A", v = 10, angle = 90 }
[[drivers]]
travel = { point = "B", v = 20, angle = 90 }
"""
# A load T on a rope over two movable pulleys C, E and a fixed one, all pieces upright.
PULLEYS = """
length_unit = "cm"
ask = ["v_E"]
[points]
K = { coordinates = { x = -10, y = 100 } }
C = { coordinates = { x = 0, y = 0 } }
L = { coordinates = { x = 20, y = 100 } }
E = { coordinates = { x = 40, y = 0 } }
T = { coordinates = { x = 50, y = 120 } }
[[joints]]
guide = { point = "C", angle = 90 }
[[joints]]
guide = { point = "E", angle = 90 }
[[joints]]
guide = { point = "T", angle = 90 }
[[joints]]
rope.path = [
    { point = "K", fixed = true }, { point = "C", radius = 10, side = "right" },
    { point = "L", radius = 10, side = "left", fixed = true }, { point = "E", radius = 10, side = "right" },
    { point = "T" },
]
[[drivers]]
travel = { point = "T", v = 30, angle = 90 }
[[drivers]]
travel = { point = "C", v = 5, angle = 90 }
"""
TWO_NAMES = CRANK.replace('["O", ', '["O", "Q", ').replace("A = {", "Q = { coordinates = { x = 0, y = 0 } }\nA = {")
PARAMETERS = """
[parameters]
v_A = { unit = "cm/s", from = 5, to = 15, step = 1 }
v_B = { unit = "cm/s", from = 40, to = 90, step = 1 }
"""
EXAM = """title = "Level"
language = "en"
[[problem]]
family = "level"
points = 5
"""


def test_a_body_on_a_level_line(tmp_path, capsys):
    path = str(scene_file(tmp_path, LEVEL))
    found = solved_items(path, capsys)
    # omega = (20 - 10) / 20, and O is 10 cm to the left of A.
    assert found["omega_p"]["value"] == pytest.approx(0.5)
    assert found["v_O"]["value"] == pytest.approx(10 - 0.5 * 10)
    # v_O = (v_A x_B - v_B x_A) / (x_B - x_A): each datum counts, three standard deviations of 0.13 % of each.
    assert 0.01 <= found["v_O"]["tolerance"] / 5 <= 0.05
    assert main(["solve", path, "--explain"]) == 0
    output = capsys.readouterr().out
    assert "is rigid, so that the position of point" in output.replace("\n", " ")


def test_a_rope_over_two_movable_pulleys(tmp_path, capsys):
    path = str(scene_file(tmp_path, PULLEYS))
    found = solved_items(path, capsys)
    # -2 v_C - 2 v_E + v_T = 0
    assert found["v_E"]["value"] == pytest.approx((30 - 2 * 5) / 2)
    # d v_E = d v_T / 2 and d v_C: 30 and 10 of 20 halves, sqrt(1.5^2 + 0.5^2) times 0.4 %, below the floor of 1 %.
    assert found["v_E"]["tolerance"] == pytest.approx(0.1)
    assert main(["solve", path, "--explain"]) == 0
    assert "length of the cord" in capsys.readouterr().out


def test_tolerances_follow_the_data_where_no_method_leads(tmp_path, capsys):
    """v_E = (v_T - 2 v_C) / 2 with 30 and 14: the two data are weighed 15 and 14 times the answer of 1."""
    found = solved_items(scene_file(tmp_path, PULLEYS.replace("v = 5,", "v = 14,")), capsys)
    assert found["v_E"]["value"] == pytest.approx(1.0)
    assert found["v_E"]["tolerance"] == pytest.approx(0.004 * (15**2 + 14**2) ** 0.5, abs=1.1e-3)


def test_without_any_method_the_answers_stand(tmp_path, capsys, monkeypatch):
    def nowhere(*_):
        raise NotApplicableError("nowhere")

    monkeypatch.setattr(solve_groups, "velocities", nowhere)
    monkeypatch.setattr(compose, "_by_one_method", nowhere)
    path = str(scene_file(tmp_path, LEVEL))
    assert solved_items(path, capsys)["omega_p"]["value"] == pytest.approx(0.5)
    assert main(["solve", path, "--explain"]) == 0
    output = capsys.readouterr()
    assert "no method of solution leads to omega_p, v_O; the answers themselves" in output.err
    # omega = (20 - 10) / 20, and O is 10 cm to the left of A.
    assert "omega_p = 0.5 rad/s\nv_O = 5 cm/s" in output.out


@pytest.mark.parametrize("words", [["solve"], ["solve", "--explain"], ["check"]])
def test_two_names_for_one_place(tmp_path, capsys, words):
    assert main([words[0], str(scene_file(tmp_path, TWO_NAMES)), *words[1:]]) == 2
    output = capsys.readouterr().err
    assert "bodies.OA: the points O and Q of this body lie in one place: two names for one point" in output
    assert "use one of the names everywhere" in output


def test_check_says_that_nothing_explains_it(tmp_path, capsys, monkeypatch):
    def nowhere(*_):
        raise NotApplicableError("nowhere")

    monkeypatch.setattr(solve_groups, "velocities", nowhere)
    monkeypatch.setattr(compose, "_by_one_method", nowhere)
    assert main(["check", str(scene_file(tmp_path, LEVEL))]) == 0
    assert "no method of solution leads to omega_p, v_O" in capsys.readouterr().out


def test_build_and_show_without_any_method(tmp_path, capsys, monkeypatch):
    def nowhere(*_):
        raise NotApplicableError("nowhere")

    monkeypatch.setattr(solve_groups, "velocities", nowhere)
    monkeypatch.setattr(compose, "_by_one_method", nowhere)
    monkeypatch.chdir(tmp_path)
    own = tmp_path / "level"
    own.mkdir()
    head = 'schema = 1\ntitle = { en = "Level" }\nsource = "own"\n'
    scene = head + LEVEL.replace("[points]", PARAMETERS + "[points]", 1).replace("v = 10", 'v = "v_A"').replace(
        "10, y = 0", "10, y = 15"
    )
    (own / "family.toml").write_text(scene.replace("v = 20", 'v = "v_B"').lstrip(), encoding="utf-8")
    (own / "statement.en.j2").write_text("{{ A }} has {{ v_A }}, {{ B }} has {{ v_B }}.", encoding="utf-8")
    (tmp_path / "exam.toml").write_text(EXAM, encoding="utf-8")
    assert main(["build", "exam.toml", "--variants", "3", "--out", "made"]) == 0
    assert "answers only, no worked solution: level" in capsys.readouterr().err
    for student in json.loads((tmp_path / "made/manifest.json").read_text(encoding="utf-8"))["students"]:
        problem = student["problems"][0]
        a, b = (float(problem["parameters"][name]["value"]) for name in ("v_A", "v_B"))
        found = {item["quantity"]: item for item in problem["answers"]}
        # omega = (v_B - v_A) / 20 cm, mirrored or not.
        assert abs(found["omega_p"]["value"]) == pytest.approx((b - a) / 20)
        assert found["omega_p"]["tolerance"] > 0
    assert main(["show", "level", "--families", ".", "--explain", "--out", "page.svg"]) == 0
    assert "no method of solution leads to" in capsys.readouterr().err
    assert (tmp_path / "page.svg").is_file()
