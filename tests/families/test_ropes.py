"""Ropes of hoists: passed several times, parallel to themselves, with stations at rest that nothing else names."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from variantgen.cli import main

HEAD = """
length_unit = "m"
[points]
A = { coordinates = { x = 1.3, y = 1 } }
B = { coordinates = { x = 0.2, y = 0 } }
C = { coordinates = { x = 0.1, y = 2 } }
D = { coordinates = { x = -2, y = 4 } }
K = { coordinates = { x = 0.7, y = 4.2 } }
L = { coordinates = { x = 0.4, y = 4 } }
F = { coordinates = { x = -0.3, y = 3.9 } }
"""
GUIDES = "".join(f"[[joints]]\nguide = {{ point = '{point}', angle = 90 }}\n" for point in "ABC")
DRIVER = "[[drivers]]\ntravel = { point = 'A', v = 1.2, a = -0.6, angle = -90 }\n"


class Scene:
    """A scene file and the command that solves it."""

    def __init__(self, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
        self.folder, self.capsys = folder, capsys

    def answers(self, text: str, *ask: str) -> dict[str, float]:
        code, out, err = self.run(text, "--json", *ask)
        assert code == 0, err
        return {answer["quantity"]: answer["value"] for answer in json.loads(out)["answers"]}

    def run(self, text: str, *more: str) -> tuple[int, str, str]:
        path = self.folder / "hoist.toml"
        path.write_text(text, encoding="utf-8")
        code = main(["solve", str(path), *more])
        shown = self.capsys.readouterr()
        return code, shown.out, shown.err


@pytest.fixture
def scene(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Scene:
    return Scene(tmp_path, capsys)


def rope(*stations: str, more: str = ", parallel = true") -> str:
    return f"[[joints]]\nrope = {{ path = [{', '.join(repr(name) for name in stations)}]{more} }}\n"


@pytest.mark.parametrize(
    ("ropes", "part"),
    [
        # s_A + n s_B = const: B rises with 1/n of the velocity with which A goes down.
        ([("A", "K", "B", "F")], 2),
        ([("A", "K", "B", "L", "B")], 3),
        ([("A", "K", "B", "L", "B", "F")], 4),
        ([("A", "K", "B", "K", "B", "K", "B", "F")], 6),
        # s_A + 2 s_C = const, 2 s_B - s_C = const.
        ([("A", "K", "C", "F"), ("C", "B", "L")], 4),
        # s_C + s_B = const, (s_A - s_C) + (s_B - s_C) + s_B = const.
        ([("C", "L", "B"), ("A", "C", "B", "F")], 4),
    ],
)
def test_strands_share_the_motion(scene: Scene, ropes: list[tuple[str, ...]], part: int) -> None:
    used = {name for path in ropes for name in path}
    guides = "".join(f"[[joints]]\nguide = {{ point = '{point}', angle = 90 }}\n" for point in "ABC" if point in used)
    text = HEAD + guides + "".join(rope(*path) for path in ropes) + DRIVER
    found = scene.answers(text, "--ask", "v_B.y", "--ask", "a_B.y")
    assert found["v_B.y"] == pytest.approx(1.2 / part, rel=1e-12)
    assert found["a_B.y"] == pytest.approx(-0.6 / part, rel=1e-12)


FOUR = HEAD + "".join(f"[[joints]]\nguide = {{ point = '{p}', angle = 90 }}\n" for p in "AB") + DRIVER
FOUR += rope("A", "K", "B", "L", "B", "F")


def test_a_rope_behind_a_movable_pulley(scene: Scene) -> None:
    # B rises with a quarter of 1.2. Of its strands the first is hauled in at 1.2, the last one hangs still, and seen
    # from B those on both sides of a sheave are equally fast: 1.2 - 2 * 0.3.
    speeds = {"v_rope.A.K": 1.2, "v_rope.K.B": 1.2, "v_rope.B.L": 0.6, "v_rope.B.F": 0.0}
    found = scene.answers(FOUR, *(word for name in speeds for word in ("--ask", name)))
    assert found == pytest.approx(speeds, abs=1e-12)


def test_the_speed_behind_a_movable_pulley_is_explained(scene: Scene) -> None:
    # A goes down: the derivative of y_A is negative, and the formula is true with it.
    asked = ("--ask", "v_rope.B.L", "--ask", "v_A/B.y", "--explain")
    code, out, _ = scene.run(FOUR, *asked)
    assert code == 0
    out = out.replace("\xa0", " ").replace("y\u0307", "y'")
    assert "v_cord BL = −y'_A − 2 y'_B = 1.2 − 2 · 0.3 = 0.6 m/s" in out
    assert "v_A/B y = y'_A − y'_B = −1.2 − 0.3 = −1.5 m/s" in out
    _, out, _ = scene.run(FOUR, *asked, "--lang", "ru")
    assert "Относительно оси B подвижного" in out


def test_strands_of_other_speeds_are_not_one(scene: Scene) -> None:
    """Between K and B three strands are hauled in at 1.2, 0.72 and 0.24: none is the speed of the cord between them."""
    text = FOUR.replace(rope("A", "K", "B", "L", "B", "F"), rope("A", "K", "B", "K", "B", "K", "B"))
    code, _, message = scene.run(text, "--ask", "v_rope.K.B")
    assert code == 2
    assert "several strands run so" in message
    assert scene.answers(text, "--ask", "v_rope.A.K") == {"v_rope.A.K": pytest.approx(1.2)}


def test_a_strand_follows_the_guide_of_its_block(scene: Scene) -> None:
    # D moves along a slope, B hangs on three strands: the rope turns about K.
    guides = "[[joints]]\nguide = { point = 'D', angle = 30 }\n[[joints]]\nguide = { point = 'B', angle = 90 }\n"
    driver = "[[drivers]]\ntravel = { point = 'D', v = 1.5, angle = 210 }\n"
    found = scene.answers(HEAD + guides + rope("D", "K", "B", "L", "B") + driver, "--ask", "v_B.y")
    assert found["v_B.y"] == pytest.approx(0.5, rel=1e-12)


def test_without_parallel_the_true_directions_count(scene: Scene) -> None:
    guides = GUIDES.replace("[[joints]]\nguide = { point = 'C', angle = 90 }\n", "")
    found = scene.answers(HEAD + guides + rope("A", "K", "B", more="") + DRIVER, "--ask", "v_B.y")
    to_a, to_b = (3.2 / (0.6**2 + 3.2**2) ** 0.5, 4.2 / (0.5**2 + 4.2**2) ** 0.5)
    assert found["v_B.y"] == pytest.approx(1.2 * to_a / to_b, rel=1e-7)


def test_a_rope_does_not_come_to_a_point_twice_in_a_row(scene: Scene) -> None:
    code, _, message = scene.run(HEAD + GUIDES + rope("A", "K", "K", "B") + DRIVER)
    assert code == 2
    assert "twice in a row" in message


def test_a_body_of_one_point_does_not_turn(scene: Scene) -> None:
    text = "length_unit = 'm'\n[points]\nB = { coordinates = { x = 0, y = 0 } }\n[bodies]\nblock = ['B']\n"
    text += (
        "[[joints]]\nguide = { point = 'B', angle = 30 }\n[[drivers]]\ntravel = { point = 'B', v = 2, angle = 30 }\n"
    )
    assert scene.answers(text, "--ask", "omega_block", "--ask", "v_B") == {"omega_block": 0.0, "v_B": pytest.approx(2)}


def test_a_belt_comes_back_as_it_left(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Two wheels of 15 and 10 cm: the smaller one is 1.5 times as fast; a belt that comes back otherwise would tear."""
    scene = tmp_path / "belt.toml"
    wheels = "".join(f"[[joints]]\npivot = {{ point = '{point}' }}\n" for point in "OP")
    station = "{{ point = 'O', radius = {}, side = '{}', body = 'A' }}"
    for radius, side, code in ((15, "right", 0), (15, "left", 2), (12, "right", 2)):
        ends = station.format(15, "right"), station.format(radius, side)
        other = "{ point = 'P', radius = 10, side = 'right', body = 'B' }"
        scene.write_text(
            "length_unit = 'cm'\nask = ['omega_B']\n"
            "[points]\nO = { coordinates = { x = 0, y = 0 } }\nP = { coordinates = { x = 90, y = 0 } }\n"
            f"[bodies]\nA = ['O']\nB = ['P']\n{wheels}"
            f"[[joints]]\nrope = {{ path = [{ends[0]}, {other}, {ends[1]}] }}\n"
            "[[drivers]]\nrotation = { body = 'A', omega = 2 }\n"
        )
        assert main(["solve", str(scene)]) == code
        said = capsys.readouterr()
        assert ("omega_B = 3 rad/s" in said.out) if code == 0 else ("contradict each other" in said.err)


@pytest.mark.parametrize(
    ("language", "said", "unsaid"),
    [("en", "The belt neither stretches nor slips.", "the cord"), ("ru", "Ремень нерастяжим", "нити")],
)
def test_what_comes_back_is_called_a_belt(
    language: str, said: str, unsaid: str, capsys: pytest.CaptureFixture[str]
) -> None:
    scene = Path(__file__).parents[1] / "kind_scenes" / "belt_over_four.toml"
    assert main(["solve", str(scene), "--ask", "omega_B", "--explain", "--lang", language]) == 0
    text = capsys.readouterr().out
    assert said in text and unsaid not in text
