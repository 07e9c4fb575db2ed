"""Two names of one place, where a file says so: points of two bodies with two velocities."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from variantgen.cli import main

ARM = """
length_unit = "cm"
[points]
O = { coordinates = { x = 0, y = 30 } }
C = { coordinates = { x = 0, y = 0 } }
A = { coordinates = { x = 40, y = 30 } }
E = "A"
[bodies]
OA = ["O", "A"]
arm = ["C", "E"]
[[joints]]
pivot = { point = "O" }
[[joints]]
pivot = { point = "C" }
[[joints]]
slot = { point = "A", body = "arm", along = ["C", "E"] }
[[drivers]]
rotation = { body = "OA", omega = 2 }
"""


def test_two_points_of_one_place_with_two_velocities(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "arm.toml"
    path.write_text(ARM, "utf-8")
    assert main(["solve", str(path), "--json", "--ask", "v_A", "--ask", "v_E", "--ask", "v_rel_A"]) == 0
    found = {answer["quantity"]: answer["value"] for answer in json.loads(capsys.readouterr().out)["answers"]}
    # The pin moves upwards with 80; the arm lies along 4:3, so its point has 4/5 of that, the rest is along the slot.
    assert found == {"v_A": pytest.approx(80), "v_E": pytest.approx(64), "v_rel_A": pytest.approx(48)}


@pytest.mark.parametrize(
    ("place", "said"),
    [
        ('E = "B"', "points.E: unknown point, or one without a place of its own (got B)"),
        ('E = "E"', "points.E: unknown point, or one without a place of its own (got E)"),
        ('E = "N"\nN = { near = { x = 1, y = 2 } }', "points.E: is placed by conditions"),
    ],
)
def test_a_place_that_no_point_has(place: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "arm.toml"
    path.write_text(ARM.replace('E = "A"', place), "utf-8")
    assert main(["solve", str(path)]) == 2
    assert said in capsys.readouterr().err
