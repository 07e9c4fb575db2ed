"""What can be solved and is hardly meant is told: sides of ropes, ropes through wheels, pins beside their slots."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.scene_files import scene_file
from variantgen.cli import main

HOIST = """
length_unit = "m"
ask = ["v_B"]
[points]
A = {{ coordinates = {{ x = -0.5, y = -2 }} }}
B = {{ coordinates = {{ x = 0.5, y = -3 }} }}
K = {{ coordinates = {{ x = 0, y = 0 }} }}
W = {{ coordinates = {{ x = -0.5, y = {wheel} }} }}
V = {{ coordinates = {{ x = -0.5, y = 9 }} }}
[bodies]
wheel = ["W", "V"]
[[joints]]
guide = {{ point = "A", angle = 90 }}
[[joints]]
guide = {{ point = "B", angle = 90 }}
[[joints]]
pivot = {{ point = "W" }}
[[joints]]
rope = {{ path = ["A", {{ point = "K", radius = 0.5, side = "{side}", fixed = true }}, "B"] }}
[[joints]]
rope = {{ path = ["C", {{ point = "W", radius = 0.2, side = "left", body = "wheel" }}] }}
[[joints]]
guide = {{ point = "C", angle = 90 }}
[[drivers]]
travel = {{ point = "A", v = 1, angle = 90 }}
[[drivers]]
rotation = {{ body = "wheel", omega = 1 }}
"""
HOIST = HOIST.replace("V = {{", "C = {{ coordinates = {{ x = -0.7, y = -8 }} }}\nV = {{")
SLOT = """
length_unit = "mm"
ask = ["v_rel_P"]
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
Q = {{ coordinates = {{ x = 0, y = -40 }} }}
P = {{ coordinates = {{ x = 20, y = 0 }} }}
D = {{ coordinates = {{ x = {x}, y = 40 }} }}
[bodies]
OP = ["O", "P"]
QD = ["Q", "D"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
pivot = {{ point = "Q" }}
[[joints]]
slot = {{ point = "P", body = "QD", along = ["Q", "D"] }}
[[drivers]]
rotation = {{ body = "OP", omega = 2 }}
"""


@pytest.mark.parametrize("command", ["solve", "check"])
@pytest.mark.parametrize(
    ("text", "told"),
    [
        (HOIST.format(side="left", wheel=8), ()),
        # The crossing threads of the wrong side: asin(0.5 / |KA|) + asin(0.5 / |KA|) beside the vertical, 28 degrees.
        (HOIST.format(side="right", wheel=8), ("path[2].side", "28 degrees with its guide", 'side = "left"')),
        # The rope to A comes down at x = -0.5, through the axle of the wheel.
        (HOIST.format(side="left", wheel=-1), ("passes through the circle about W", "0 mm from its centre")),
        # QD has the slope 2 and goes through P.
        (SLOT.format(x=40), ()),
        # The line x = 0: P stands 20 mm beside it.
        (SLOT.format(x=0), ("P is 20 mm beside the line QD", "slot of P")),
    ],
)
def test_it_is_told_with_key_and_remedy(
    text: str, told: tuple[str, ...], command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = scene_file(tmp_path, text)
    code = main([command, str(path)])
    shown = capsys.readouterr()
    assert code == 0, shown
    said = shown.err if command == "solve" else shown.out
    assert ("joints." in said) is bool(told), said
    assert all(words in said for words in told), said


@pytest.mark.parametrize(("side", "told"), [("left", False), ("right", True)])
def test_a_pulley_is_told_where_its_rope_is_aslant(
    side: str, told: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """How fast B is depends on the place of the pulley only where the rope does not run along the guides."""
    path = scene_file(tmp_path, HOIST.format(side=side, wheel=8))
    assert main(["show", str(path)]) == 0
    assert ("x_K = 0 m, y_K = 0 m" in " ".join(capsys.readouterr().out.split())) is told


def test_a_pulley_wound_far_beyond_half_a_turn_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    # Up from the boom and down to the drum, over the pulley: that is its right side.
    assert main(["solve", str(Path(__file__).parents[1] / "textbook_kinds" / "crane_rope.toml")]) == 0
    said = capsys.readouterr().err
    assert "goes round K by 285 degrees" in said or "goes round K by 286 degrees" in said
    assert 'with side = "right"' in said
