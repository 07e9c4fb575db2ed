"""Two names of one place, where a file says so: points of two bodies with two velocities."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.scene_files import scene_file, solved_values
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
    path = scene_file(tmp_path, ARM)
    found = solved_values(path, capsys, "v_A", "v_E", "v_rel_A")
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
    path = scene_file(tmp_path, ARM.replace('E = "A"', place))
    assert main(["solve", str(path)]) == 2
    assert said in capsys.readouterr().err
