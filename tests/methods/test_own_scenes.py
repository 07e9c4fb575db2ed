"""Scenes of one's own: the same mechanism in every unit has the same answers, tolerances and a full solution."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from tests.own_scenes import FACTORS, SCENES, OwnScene
from tests.scene_files import scene_file, solved_items
from variantgen.cli import main
from variantgen.methods.compose import solution
from variantgen.methods.linkage.problem import task_of
from variantgen.methods.solution_options import SolutionOptions
from variantgen.single import answers, asked_quantities, one_variant
from variantgen.variants.variant import Variant, solve_variants
from variantgen.wording.language import load_language
from variantgen.wording.solution.explain import explain


def _variant(folder: Path, scene: OwnScene, unit: str, parameters: bool) -> Variant:
    path = folder / f"scene-{unit}-{parameters}.toml"
    path.write_text(scene.written(unit, parameters), encoding="utf-8")
    return one_variant(str(path))


def _in_si(value: float, unit: str) -> float:
    return value * FACTORS.get(unit.partition("/")[0], 1.0)


@pytest.mark.parametrize("parameters", [False, True], ids=["numbers", "parameters"])
@pytest.mark.parametrize("name", SCENES)
def test_answers_and_solutions_do_not_depend_on_the_unit(name, parameters, tmp_path):
    scene = SCENES[name]()
    relative = {}
    for unit in FACTORS:
        variant = _variant(tmp_path, scene, unit, parameters)
        found = answers(variant)
        for answer, (quantity, expected) in zip(found, scene.answers.items(), strict=True):
            assert answer.quantity.name == quantity
            assert _in_si(answer.value, answer.unit.name) == pytest.approx(expected, rel=1e-7), (unit, quantity)
        relative[unit] = [a.tolerance / abs(a.value) for a in found]
        asked = asked_quantities(variant)
        motion = solve_variants([variant], max(q.order for q in asked))
        output = solution(task_of(variant, motion, 0, asked))
        assert output.steps
        for (quantity, value), answer in zip(output.answers, found, strict=True):
            assert abs(value.exact) == pytest.approx(abs(answer.value), rel=1e-7), (unit, quantity)
        for language in ("en", "ru"):
            assert explain(variant, motion, 0, asked, load_language(language), SolutionOptions()).sections
    for unit in FACTORS:
        assert relative[unit] == pytest.approx(relative["m"], rel=1e-9)
        assert all(share <= 0.06 for share in relative[unit]), relative[unit]


def test_the_scene_of_the_guide(tmp_path, capsys):
    guide = (Path(__file__).parents[2] / "catalog" / "README.md").read_text(encoding="utf-8")
    path = scene_file(tmp_path, guide.split("```toml scene\n")[1].split("```")[0])
    found = solved_items(path, capsys)
    # x = 60 cos beta, beta = 40 deg, shrinks at 30 cm/s, which grows by 20 cm/s^2.
    turn = 30 / (60 * math.sin(math.radians(40)))
    epsilon = (20 - 60 * turn**2 * math.cos(math.radians(40))) / (60 * math.sin(math.radians(40)))
    assert found["epsilon_OB"]["value"] == pytest.approx(epsilon, rel=1e-7)
    assert found["epsilon_OB"]["value"] == pytest.approx(-0.2025, abs=5e-5)
    assert 0.002 < found["epsilon_OB"]["tolerance"] < 0.01
    assert main(["solve", str(path), "--explain"]) == 0
    assert "0.2025\N{NO-BREAK SPACE}rad/s" in capsys.readouterr().out


ANGLES = """
length_unit = "cm"
ask = ["v_A", "v_B"]
[parameters]
OA = { unit = "cm", values = [40] }
phi = { unit = "deg", values = [50] }
k = { unit = "rad/s", values = [0.7] }
t = { unit = "s", values = [1.3] }
[laws]
time = "t"
s = "OA * cos(k * t)"
[derived]
arc = "OA * phi"
[points]
A = { coordinates = { x = "s", y = 0 } }
B = { polar = { origin = "A", distance = "arc", angle = "90*deg" } }
[bodies]
AB = ["A", "B"]
[[joints]]
guide = { point = "A", angle = 0 }
[[drivers]]
travel = { point = "A", v = "s_dot", angle = 0 }
[[drivers]]
rotation = { body = "AB", omega = "k" }
"""


def test_angles_of_rates_and_angles_of_data(tmp_path, capsys):
    """``cos(k t)`` has its angle in radians, the arc ``OA phi`` one in degrees: both are right in the solution."""
    path = tmp_path / "angles.toml"
    path.write_text(ANGLES, encoding="utf-8")
    assert main(["solve", str(path), "--explain"]) == 0
    output = capsys.readouterr().out.replace("\N{NO-BREAK SPACE}", " ")
    speed, arc = 40 * 0.7 * math.sin(0.7 * 1.3), 40 * math.radians(50)
    assert f"{speed:.2f} cm/s" in output
    # The rotation adds 0.7 arc to the left of AB, which points up: against or along the motion of A.
    assert f"{abs(-speed - 0.7 * arc):.2f} cm/s" in output
