"""Figures of parallel ropes: as many strands and sheaves as the rope has, upright, and the words for them."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

from variantgen.figure.drawing import Arc, Drawing, Layer, Strokes
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


TESTS = Path(__file__).parents[1]
HOISTS = [
    *(f"kind_scenes/{name}" for name in ("tackle_of_five", "weston_hoist", "elevator_two_to_one", "hoist_two_ropes")),
    *(f"kind_scenes/{name}" for name in ("two_pulleys_three_loads", "loads_seen")),
    *(f"books/hibbeler_12_{number}" for number in (21, 22, 23, 172, 173, 174)),
]
END = 1e-6  # u


def lying(figure: Drawing, layer: Layer) -> list[tuple[complex, ...]]:
    return [line.points for line in figure.lines if isinstance(line, Line) and line.layer is layer]


def wheels(figure: Drawing) -> list[tuple[complex, float]]:
    full = [line for line in figure.lines if isinstance(line, Arc) and line.layer is Layer.DISC]
    return [(line.centre, line.radius) for line in full]


def beside(place: complex, ends: tuple[complex, ...]) -> float:
    """How far a place is from a straight line of two ends."""
    way = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
    along = ((place - ends[0]) * way.conjugate()).real
    return abs(place - ends[0] - way * min(max(along, 0.0), abs(ends[1] - ends[0])))


@pytest.mark.parametrize("name", HOISTS)
def test_strands_are_upright_and_touch_what_they_lead_to(name: str) -> None:
    """A wheel at its rim and square to the radius; else a support, a load or the frame of a block."""
    figure = picture(one_variant(str(TESTS / f"{name}.toml"))).drawing
    discs, frames = wheels(figure), [*lying(figure, Layer.LINK), *lying(figure, Layer.SLIDER)]
    pieces = lying(figure, Layer.THREAD)
    assert pieces
    for ends in pieces:
        assert abs((ends[1] - ends[0]).real) < END
        for end in ends:
            at_rim = [c for c, r in discs if abs(abs(end - c) - r) < END and abs((end - c).imag) < END]
            hinges = [c for c, r in discs if abs(end - c) < END]
            held = [f for f in frames if any(beside(end, pair) < END for pair in pairwise(f))]
            boxed = [f for f in frames if len(f) == 4 and abs(end - sum(f) / 4) < END]
            assert at_rim or hinges or held or boxed, (name, end)


@pytest.mark.parametrize("name", HOISTS)
def test_sheaves_loads_and_supports_are_clear_of_each_other(name: str) -> None:
    figure = picture(one_variant(str(TESTS / f"{name}.toml"))).drawing
    discs, pieces = wheels(figure), lying(figure, Layer.THREAD)
    for k, (centre, radius) in enumerate(discs):
        for other, size in discs[:k]:
            assert abs(other - centre) < END or abs(other - centre) > radius + size, name
    boxes = [sum(f) / 4 for f in lying(figure, Layer.SLIDER) if len(f) == 4]
    for box in boxes:  # half a load is 3 u
        assert all(beside(box, ends) > 3 or min(abs(box - end) for end in ends) < END for ends in pieces), name
        assert all(abs(box - centre) > radius + 3 for centre, radius in discs), name
    hatched = [line.segments for line in figure.lines if isinstance(line, Strokes)]
    for stroke in (stroke for strokes in hatched for stroke in strokes):
        # The base of a drum may stand between its rims.
        around = [abs(abs(end - centre) - radius) for centre, radius in discs for end in stroke]
        assert min(around, default=1.0) > 0.1, name


def test_a_load_on_a_slope_stands_on_it() -> None:
    figure = picture(one_variant(str(TESTS / "textbook_kinds" / "incline_blocks_rope.toml"))).drawing
    slope = max((ends[1] - ends[0] for ends in lying(figure, Layer.GROUND)), key=abs)
    assert abs(slope.imag / slope.real) == pytest.approx(0.57735, rel=1e-4)  # 30 degrees
    # The other load hangs: its block is drawn alone.
    assert sum(len(points) == 4 for points in (*lying(figure, Layer.SLIDER), *lying(figure, Layer.DISC))) == 2


def test_a_pulley_between_upright_strands_needs_no_wall() -> None:
    figure = picture(one_variant(str(TESTS / "textbook_kinds" / "movable_pulley_rope.toml"))).drawing
    assert not lying(figure, Layer.GROUND)


def test_two_ropes_over_a_pulley_have_one_bracket(tmp_path: Path) -> None:
    """A platform of two points on ropes over the same deflector."""
    pulley = '{ point = "L", radius = 0.2, side = "left" }'
    drum = '{ point = "D", radius = 0.4, side = "left", body = "drum" }'
    places = {"P": (-1.5, 0), "Q": (1.5, 0), "K": (-1.3, 4), "L": (1.7, 4), "D": (4, 1)}
    lines = [f"{name} = {{ coordinates = {{ x = {x}, y = {y} }} }}" for name, (x, y) in places.items()]
    file = tmp_path / "platform.toml"
    file.write_text(
        'length_unit = "m"\nask = ["v_Q"]\n[points]\n' + "\n".join(lines) + '\n[bodies]\nplatform = ["P", "Q"]\n'
        'drum = ["D"]\n[[joints]]\npivot = { point = "D" }\n[[joints]]\nguide = { point = "P", angle = 90 }\n'
        f'[[joints]]\nrope.path = ["P", {pulley.replace("L", "K")}, {pulley}, {drum}]\n'
        f'[[joints]]\nrope.path = ["Q", {pulley}, {drum}]\n'
        '[[drivers]]\nrotation = { body = "drum", omega = -3 }\n',
        encoding="utf-8",
    )
    figure = picture(one_variant(str(file))).drawing
    # Of each bracket a stem and a base; the bar of the platform.
    assert len(lying(figure, Layer.LINK)) == 2 * 2 + 1
