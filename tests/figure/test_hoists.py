"""Figures of parallel ropes: as many strands and sheaves as the rope has, upright, and the words for them."""

from __future__ import annotations

from pathlib import Path

import pytest

from variantgen.figure.drawing import Arc, Drawing, Layer
from variantgen.figure.drawing import Path as Line
from variantgen.outputs.single.picture import picture
from variantgen.single import one_variant

SCENE = """
length_unit = "m"
ask = ["v_A"]
[points]
A = {{ coordinates = {{ x = 4, y = 2 }} }}
B = {{ coordinates = {{ x = 1, y = 0 }} }}
K = {{ coordinates = {{ x = 3, y = 6 }} }}
L = {{ coordinates = {{ x = 1, y = 6 }} }}
F = {{ coordinates = {{ x = 0.5, y = 6 }} }}
[[joints]]
guide = {{ point = "A", angle = {angle} }}
[[joints]]
guide = {{ point = "B", angle = 90 }}
[[joints]]
rope = {{ path = {path}, parallel = true }}
[[drivers]]
travel = {{ point = "B", v = 1, angle = 90 }}
"""


def drawing(folder: Path, path: str, angle: int = 90, language: str = "en") -> Drawing:
    file = folder / "hoist.toml"
    file.write_text(SCENE.format(path=path, angle=angle), encoding="utf-8")
    return picture(one_variant(str(file)), language=language).drawing


def strands(figure: Drawing) -> list[complex]:
    lines = [line for line in figure.lines if isinstance(line, Line) and line.layer is Layer.THREAD]
    return [line.points[1] - line.points[0] for line in lines]


@pytest.mark.parametrize(
    ("path", "pieces", "sheaves"),
    [
        ('["A", "K", "B", "F"]', 3, 2),
        ('["A", "K", "B", "L", "B"]', 4, 3),
        ('["A", "K", "B", "L", "B", "F"]', 5, 4),
    ],
)
def test_strands_and_sheaves(path: str, pieces: int, sheaves: int, tmp_path: Path) -> None:
    figure = drawing(tmp_path, path)
    steps = strands(figure)
    assert len(steps) == pieces
    assert all(abs(step.real) < 1e-6 * abs(step) for step in steps)
    discs = [line for line in figure.lines if isinstance(line, Arc) and line.layer is Layer.DISC]
    wraps = [line for line in figure.lines if isinstance(line, Arc) and line.layer is Layer.THREAD]
    assert len(discs) == len(wraps) == sheaves
    assert all(abs(abs(wrap.sweep) - 3.14159265) < 1e-6 for wrap in wraps)


def test_a_rope_turns_into_the_way_of_its_block(tmp_path: Path) -> None:
    # A moves along the floor: its strand is level, the one behind the sheave is upright.
    figure = drawing(tmp_path, '["A", "K", "B", "F"]', 0)
    level, *upright = strands(figure)
    assert abs(level.imag) < 1e-6 * abs(level)
    assert all(abs(step.real) < 1e-6 * abs(step) for step in upright)


@pytest.mark.parametrize(("language", "words"), [("en", "then the movable pulley B"), ("ru", "затем подвижный блок B")])
def test_the_words_for_a_block(language: str, words: str, tmp_path: Path) -> None:
    assert words in drawing(tmp_path, '["A", "K", "B", "F"]', language=language).alt


def test_two_loads_hang_upright_on_a_movable_sheave(tmp_path: Path) -> None:
    text = SCENE.format(path='["A", "K", "C"]', angle=90)
    text = text.replace("x = 4", "x = 2").replace("x = 1, y = 0", "x = 3, y = 0")
    points = "C = { coordinates = { x = 4, y = 4 } }\nD = { coordinates = { x = 5, y = 1 } }\n"
    text = text.replace("[[joints]]", points + "[[joints]]", 1)
    text += '[[joints]]\nguide = { point = "C", angle = 90 }\n[[joints]]\nguide = { point = "D", angle = 90 }\n'
    text += '[[joints]]\nrope = { path = ["B", "C", "D"], parallel = true }\n'
    text += '[[drivers]]\ntravel = { point = "A", v = 1, angle = 90 }\n'
    file = tmp_path / "hoist.toml"
    file.write_text(text, encoding="utf-8")
    steps = strands(picture(one_variant(str(file))).drawing)
    assert len(steps) == 4
    assert all(abs(step.real) < 1e-6 * abs(step) for step in steps)
