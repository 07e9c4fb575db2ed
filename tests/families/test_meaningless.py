"""What can be written in a family or scene file and has no meaning is refused, with key, value and remedy."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from variantgen.cli import main

SCENE = """
length_unit = "cm"
[parameters]
OA = { unit = "cm", values = [20] }
AB = { unit = "cm", values = [60] }
phi = { unit = "deg", values = [60] }
[derived]
half = "OA / 2"
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = "OA", angle = "phi" } }
B = { line_circle = { through = "O", centre = "A", distance = "AB" } }
C = { fraction = { start = "A", end = "B" } }
K = { coordinates = { x = 90, y = 40 } }
[bodies]
OA = ["O", "A"]
AB = ["A", "B", "C"]
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B" }
[[drivers]]
rotation = { body = "OA", omega = 2 }
"""
WHEEL = """
length_unit = "cm"
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { coordinates = { x = 50, y = 0 } }
M = { coordinates = { x = 50, y = 10 } }
[bodies]
arm = ["O", "A"]
gear = ["A", "M"]
[[joints]]
pivot = { point = "O" }
[[joints]]
gears = { body = "gear", centre = "A", radius = 20, other_centre = "O" }
[[drivers]]
rotation = { body = "arm", omega = 2 }
"""


def answer(content: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, str, str]:
    path = folder / "scene.toml"
    path.write_text(content, "utf-8")
    code = main(["solve", str(path), "--json"])
    out, message = capsys.readouterr()
    assert "Traceback" not in message
    return code, out, message


@pytest.mark.parametrize("scene", [SCENE, WHEEL])
def test_the_sound_scenes_are_solved(scene: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, message = answer(scene, tmp_path, capsys)
    assert code == 0, message
    assert json.loads(out)["outcome"] == "solved"


@pytest.mark.parametrize(
    ("scene", "old", "new", "said"),
    [
        (SCENE, 'half = "OA / 2"', 'half = "sqrt(OA**2 - AB**2)"', ["derived.half", "root of a negative", "OA**2"]),
        (SCENE, 'half = "OA / 2"', 'half = "OA * acos(AB / OA)"', ["derived.half", "expected a finite value"]),
        (SCENE, 'half = "OA / 2"', 'half = "OA / (1 - 1)"', ["derived.half", "division by zero"]),
        (SCENE, 'half = "OA / 2"', 'm = "OA / 2"', ["derived.m", "word of the expression language", "m_1"]),
        (SCENE, 'half = "OA / 2"', '"a b" = "OA / 2"', ["derived.a b", "letter followed by"]),
        (SCENE, 'OA = { unit = "cm"', 'cm = { unit = "cm"', ["parameters.cm", "word of the expression language"]),
        (SCENE, 'AB = { unit = "cm"', 'AB = { symbol = "OA", unit = "cm"', ["parameters.AB.symbol", "like OA"]),
        (SCENE, 'distance = "AB" }', 'distance = "-AB" }', ["points.B.distance", "above 0"]),
        (SCENE, 'distance = "AB" }', 'distance = "AB", branch = 0.5 }', ["points.B.branch", "one of 1, -1"]),
        (SCENE, 'through = "O", ', 'through = "O", angle = 5, towards = "K", ', ["towards", "both give the direction"]),
        (SCENE, "K = {", "rod_1 = {", ["points.rod_1", "Latin letter", "rod_1"]),
        (SCENE, '"A", "B", "C"]', '"A", "B", "A"]', ["bodies.AB", "lists a point twice", "A"]),
        (SCENE, 'body = "OA", omega = 2', 'body = "OA", relative_to = "OA", omega = 2', ["names a body twice", "OA"]),
        (SCENE, 'guide = { point = "B" }', 'arc_slot = { point = "B", centre = "C" }', ["at rest", "C", "pivot"]),
        (SCENE, 'guide = { point = "B" }', 'slot = { point = "B", body = "OA", along = ["O", "O"] }', ["point twice"]),
        (
            SCENE,
            'guide = { point = "B" }',
            'rope.path = [{ point = "B" }, { point = "A", fixed = true }]',
            ["rope of B", "taken to be at rest", "A"],
        ),
        (SCENE, 'guide = { point = "B" }', 'rope.path = [{ point = "B" }]', ["at least two bends"]),
        (
            SCENE,
            'guide = { point = "B" }',
            'rope.path = [{ point = "B" }, { point = "K", radius = -3, fixed = true }]',
            ["joints[2].path[2].radius", "not negative"],
        ),
        (
            SCENE,
            'guide = { point = "B" }',
            'rope.path = [{ point = "B" }, { point = "K", body = "OA" }]',
            ["is no point of the body OA", "K"],
        ),
        (
            SCENE,
            'guide = { point = "B" }',
            'rolling = { body = "AB", centre = "B", contact = "K", on = "OA" }',
            ["go together"],
        ),
        (SCENE, "[[drivers]]", "[symbols]\nqwerty = 'x'\n[[drivers]]", ["symbols.qwerty", "unknown body or parameter"]),
        (
            SCENE,
            "[[drivers]]",
            "[figure]\nlengths = [{ name = 'q', from = 'O', to = 'K' }]\n[[drivers]]",
            ["lengths[1].name", "q"],
        ),
        (WHEEL, "radius = 20", "radius = -20", ["radius", "above 0"]),
        (WHEEL, "radius = 20", "radius = 60", ["two circles that should touch cannot"]),
        (WHEEL, 'other_centre = "O"', 'other_centre = "M"', ["taken to be at rest", "M"]),
        (WHEEL, 'centre = "A", radius', 'centre = "O", radius', ["is no point of the body gear", "O"]),
        # The centre is not the axle: the distance of the centres changes while the gears turn.
        (WHEEL, 'centre = "A", radius', 'centre = "M", radius', ["an independent computation gives another motion"]),
    ],
)  # fmt: skip
def test_meaningless(
    scene: str, old: str, new: str, said: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert old in scene
    code, _, message = answer(scene.replace(old, new), tmp_path, capsys)
    assert code == 2, message
    assert all(part in message for part in said), message


@pytest.mark.parametrize("path", ["sqrt(OA**2 - AB**2)", "acos(AB / OA) * OA", "OA * OA / (OA - OA)"])
def test_a_variant_without_a_meaning_is_not_drawn(
    path: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    content = SCENE.replace("values = [20]", "values = [18, 20]").replace("OA / 2", path)
    code, _, message = answer(content, tmp_path, capsys)
    assert code == 2
    assert "derived.half with a meaning" in message


def show_ladder(page: Path, phi: str, gamma: str) -> int:
    """The exit code of drawing a ladder with a wall at the angle gamma to the floor."""
    data = [f"phi={phi}", f"gamma={gamma}", "AB=5.8", "way=towards_the_corner", "v_A=6", "a_A=-8"]
    settings = [word for item in data for word in ("--set", item)]
    return main(["show", "ladder", "--form", "oblique", *settings, "--out", str(page)])


@pytest.mark.parametrize("gamma", ["0.0000001", "0.000001", "0.0001"])
def test_a_wall_that_nearly_lies_on_the_floor_is_drawn(
    gamma: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The corner is up to 2 million km away: the ladder's coordinates are rounded to half a micrometre."""
    page = tmp_path / "page.svg"
    assert show_ladder(page, "45", gamma) == 0, capsys.readouterr().err
    assert "</svg>" in page.read_text("utf-8")


def test_a_ladder_that_lies_on_the_floor_cannot_be_drawn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = tmp_path / "page.svg"
    assert show_ladder(page, "0", "60") == 2
    assert "cannot be drawn" in capsys.readouterr().err
    assert not page.exists()
