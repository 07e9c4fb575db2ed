"""Belts that come back to their first pulley: all strands are seen, and the last one demands nothing new."""

from __future__ import annotations

from math import sqrt
from pathlib import Path

import pytest

from variantgen.cli import main
from variantgen.figure.drawing import Arc, Drawing, Layer
from variantgen.figure.drawing import Path as Line
from variantgen.outputs.single.picture import picture
from variantgen.single import one_variant
from variantgen.wording.formula import to_plain

SCENE = """
length_unit = "cm"
ask = ["omega_B", "v_M"]
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
C = {{ coordinates = {{ x = 90, y = 0 }} }}
M = {{ coordinates = {{ x = 90, y = 25 }} }}
P = {{ coordinates = {{ x = 40, y = {height} }} }}
[bodies]
A = ["O"]
B = ["C", "M"]
{bodies}
[[joints]]
pivot = {{ point = "O" }}
{joints}
[[joints]]
rope.path = [{path}]
[[drivers]]
rotation = {{ body = "A", omega = 30 }}
{drivers}
"""


def station(point: str, radius: float, side: str, body: str = "") -> str:
    return f'{{ point = "{point}", radius = {radius}, side = "{side}"' + (f', body = "{body}" }}' if body else " }")


FIRST = station("O", 15, "left", "A")


def scene(
    folder: Path,
    *path: str,
    height: float = 60,
    bodies: str = "",
    joints: str = '[[joints]]\npivot = { point = "C" }',
    drivers: str = "",
) -> str:
    file = folder / "belt.toml"
    text = SCENE.format(path=", ".join(path), height=height, bodies=bodies, joints=joints, drivers=drivers)
    file.write_text(text, encoding="utf-8")
    return str(file)


def strands(figure: Drawing) -> list[tuple[complex, complex]]:
    """The ends (cm, with O at the origin) of the straight pieces."""
    lines = [line.points for line in figure.lines if isinstance(line, Line) and line.layer is Layer.THREAD]
    return [tuple((end - figure.origin) / figure.scale * 100 for end in ends) for ends in lines]  # type: ignore[misc]


def distance(centre: complex, ends: tuple[complex, complex]) -> float:
    """From the line to a centre, positive where the centre is on its left."""
    way = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
    return ((centre - ends[0]) * way.conjugate()).imag


@pytest.mark.parametrize("view", ["statement", "velocities"])
@pytest.mark.parametrize(
    ("side", "away", "length"),
    [("left", -25, sqrt(90**2 - 10**2)), ("right", 25, sqrt(90**2 - 40**2))],  # outer and inner tangents
)
def test_two_tangents(side: str, away: float, length: float, view: str, tmp_path: Path) -> None:
    variant = one_variant(scene(tmp_path, FIRST, station("C", 25, side, "B"), FIRST))
    out, back = strands(picture(variant, view).drawing)
    for ends in (out, back):
        assert distance(0j, ends) == pytest.approx(-15)
        assert distance(90 + 0j, ends) == pytest.approx(away)
        assert abs(ends[1] - ends[0]) == pytest.approx(length)
    assert (out[0].imag > 0) != (back[1].imag > 0)


@pytest.mark.parametrize(
    ("side", "english", "russian"),
    [("left", "Closed belt: the disc with centre O (round it on the left)", "Замкнутый ремень: диск с центром O"),
     ("right", "Closed crossed belt: the disc", "Замкнутый перекрёстный ремень: диск")],
)  # fmt: skip
def test_the_words_for_a_belt(side: str, english: str, russian: str, tmp_path: Path) -> None:
    variant = one_variant(scene(tmp_path, FIRST, station("C", 25, side, "B"), FIRST))
    assert english in picture(variant).drawing.alt
    assert russian in picture(variant, language="ru").drawing.alt


def test_three_pulleys(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = [station("O", 15, "right", "A"), station("C", 25, "right", "B"), station("P", 10, "right", "D")]
    pivots = "".join(f'[[joints]]\npivot = {{ point = "{point}" }}\n' for point in "CP")
    file = scene(tmp_path, *path, path[0], bodies='D = ["P"]', joints=pivots)
    found = strands(picture(one_variant(file)).drawing)
    assert len(found) == 3
    assert distance(40 + 60j, found[1]) == pytest.approx(10) == pytest.approx(distance(40 + 60j, found[2]))
    assert main(["solve", file, "--ask", "omega_D", "--ask", "v_rope.P.O"]) == 0
    assert capsys.readouterr().out == "omega_D = 45 rad/s\nv_rope.P.O = 450 cm/s\n"  # 30 * 15 / 10


def test_an_idler_on_the_way_back(tmp_path: Path) -> None:
    path = [station("O", 15, "right", "A"), station("C", 25, "right", "B"), station("P", 6, "left")]
    figure = picture(one_variant(scene(tmp_path, *path, path[0], height=20))).drawing
    assert len(strands(figure)) == 3
    wraps = [line for line in figure.lines if isinstance(line, Arc) and line.layer is Layer.THREAD]
    assert [line.radius / figure.scale for line in wraps] == [pytest.approx(0.06)]


def test_on_a_turning_arm(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """As seen from the arm the first pulley turns at 28 rad/s, the second one at 28 * 15 / 25."""
    file = scene(
        tmp_path, FIRST, station("C", 25, "left", "B"), FIRST, bodies='arm = ["O", "C"]', joints="",
        drivers='[[drivers]]\nrotation = { body = "arm", omega = 2 }',
    )  # fmt: skip
    assert main(["solve", file, "--ask", "omega_B"]) == 0
    assert capsys.readouterr().out == "omega_B = 18.8 rad/s\n"
    assert len(strands(picture(one_variant(file)).drawing)) == 2


def test_a_closed_belt_does_not_stretch(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The axle of the second pulley moves away."""
    file = scene(
        tmp_path, FIRST, station("C", 25, "left", "B"), FIRST, joints='[[joints]]\nguide = { point = "C", angle = 0 }',
        drivers='[[drivers]]\ntravel = { point = "C", v = 2 }',
    )  # fmt: skip
    assert main(["solve", file]) == 2
    assert "contradict each other" in capsys.readouterr().err


@pytest.mark.parametrize("side", ["left", "right"])
def test_the_speed_of_a_belt_as_an_arrow(side: str, tmp_path: Path) -> None:
    """No point of the figure moves but the belt, which leaves the upper side of O to the left: towards O."""
    file = scene(tmp_path, FIRST, station("C", 25, side, "B"), FIRST)
    Path(file).write_text(Path(file).read_text().replace('"v_M"', '"v_rope.C.O"').replace('["C", "M"]', '["C"]'))
    figure = picture(one_variant(file), "velocities").drawing
    named = next(label for label in figure.labels if "belt CO" in to_plain(label.formula))
    assert named.arrow is not None
    arrow = named.arrow[1] - named.arrow[0]
    out, _ = strands(figure)
    way = (out[0] - out[1]) / abs(out[0] - out[1])
    assert arrow / abs(arrow) == pytest.approx(way)


@pytest.mark.parametrize(
    ("language", "symbol", "note"),
    [
        ("en", "v_belt CO (cm/s)", "The index belt CO: speed of the belt between C and O."),
        ("ru", "v_ремня CO (см/с)", "Индекс «ремня CO» — скорость ремня между C и O."),
    ],
)
def test_the_speed_of_a_belt_is_called_so(
    language: str, symbol: str, note: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = scene(tmp_path, FIRST, station("C", 25, "left", "B"), FIRST)
    assert main(["show", file, "--lang", language, "--ask", "v_rope.C.O in cm/s"]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert symbol in said
    assert note in said


def test_the_base_of_a_small_pulley_stands_outside_its_rim(tmp_path: Path) -> None:
    """A rim of 8 cm would cut a base as near to the hinge as usual, and its hatching."""
    big, small = station("O", 15, "left", "A"), station("C", 8, "left", "B")
    figure = picture(one_variant(scene(tmp_path, big, small, big))).drawing
    axle, rim = 0.9 * figure.scale + figure.origin, 0.08 * figure.scale
    lines = [line.points for line in figure.lines if isinstance(line, Line) and line.layer is Layer.SLIDER]
    near = [ends for ends in lines if all(abs(end - axle) < 2 * rim for end in ends)]
    # The legs lead to the axle, the base passes it.
    (base,) = [distance(axle, (first, second)) for first, second in near if abs(distance(axle, (first, second))) > 1]
    assert abs(base) > rim
