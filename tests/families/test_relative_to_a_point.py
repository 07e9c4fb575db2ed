"""Velocity and acceleration of one point relative to another: values by hand, names, solutions in both languages."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from tests.scene_files import scene_file
from variantgen.errors import InputError
from variantgen.families.quantities import parse_quantity, split_name
from variantgen.families.reading.load import load_family
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.outputs.single.explanation import explain
from variantgen.single import answers, one_variant
from variantgen.testing.linkages import slider_crank
from variantgen.wording.answer_notes import answer_notes
from variantgen.wording.formula import to_plain
from variantgen.wording.language import load_language

# A car that brakes on a straight road and another one that speeds up on a bend of 40 m.
CARS = """
length_unit = "m"
ask = ["v_A/B", "v_A/B.angle", "a_A/B", "a_A/B.x", "a_A/B.along_AB"]
[points]
A = { coordinates = { x = 0, y = 0 } }
C = { coordinates = { x = 50, y = 30 } }
B = { polar = { origin = "C", distance = 40, angle = 200 } }
[bodies]
CB = ["C", "B"]
[[joints]]
pivot = { point = "C" }
[[drivers]]
vector_motion = { point = "A", v = 18, angle = 0, a = 2, a_angle = 180 }
[[drivers]]
rotation = { body = "CB", omega = 0.4, epsilon = 0.1 }
"""
# A crank of 20 cm at 50 degrees, a rod of 60 cm to a slider on the axis x, the midpoints of both; 3 rad/s.
MIDPOINTS = """
length_unit = "cm"
ask = ["v_B/A", "a_B/A", "v_D/C", "a_D/C", "v_D/C.x"]
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = 20, angle = 50 } }
B = { line_circle = { through = "O", centre = "A", distance = 60, angle = 0, branch = "ahead" } }
C = { fraction = { start = "O", end = "A" } }
D = { fraction = { start = "A", end = "B" } }
[bodies]
OA = ["O", "A", "C"]
AB = ["A", "B", "D"]
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B" }
[[drivers]]
rotation = { body = "OA", omega = 3 }
"""


def value(scene: Scene, name: str) -> float:
    return float(parse_quantity(name, scene).value(solve(scene))[0])


def of_file(text: str, tmp_path: Path) -> dict[str, float]:
    path = scene_file(tmp_path, text)
    return {answer.quantity.name: answer.value for answer in answers(one_variant(path))}


def test_two_cars(tmp_path):
    """v_B = 16 m/s across CB, a_B = 6.4 m/s2 towards C and 4 m/s2 across it."""
    ray = complex(math.cos(math.radians(200)), math.sin(math.radians(200)))
    velocity = 18 - 16j * ray
    acceleration = -2 - (-6.4 + 4j) * ray
    way = 50 + 30j + 40 * ray
    along = (acceleration * way.conjugate()).real / abs(way)
    assert of_file(CARS, tmp_path) == pytest.approx(
        {
            "v_A_B": abs(velocity),
            "v_A_B.angle": math.degrees(math.atan2(velocity.imag, velocity.real)),
            "a_A_B": abs(acceleration),
            "a_A_B.x": acceleration.real,
            "a_A_B.along_AB": along,
        }
    )


def test_midpoints_of_a_crank_and_its_rod(tmp_path):
    """B seen from A turns with the rod; D seen from C is half of B seen from O, for CD is half of OB."""
    phi, omega = math.radians(50), 3.0
    slope = math.asin(20 * math.sin(phi) / 60)
    turning = 20 * math.cos(phi) * omega / (60 * math.cos(slope))
    faster = (60 * math.sin(slope) * turning**2 - 20 * math.sin(phi) * omega**2) / (60 * math.cos(slope))
    v = -20 * math.sin(phi) * omega - 60 * math.sin(slope) * turning
    a = -20 * math.cos(phi) * omega**2 - 60 * (math.cos(slope) * turning**2 + math.sin(slope) * faster)
    assert of_file(MIDPOINTS, tmp_path) == pytest.approx(
        {
            "v_B_A": 60 * turning,
            "a_B_A": 60 * math.hypot(turning**2, faster),
            "v_D_C": -v / 2,
            "a_D_C": -a / 2,
            "v_D_C.x": v / 2,
        }
    )


def test_largest_over_a_turn():
    """The rod of a central slider-crank turns fastest where the crank lies along the guide: v_B/A is then v_A."""
    assert value(slider_crank(0.2, 0.6, 0.0, 0.9, 3.0), "max_v_B_A") == pytest.approx(0.6, rel=1e-9)


def test_names():
    scene = slider_crank(0.2, 0.6, 0.0, 0.9, 3.0)
    assert split_name("v_B/A in cm/s").written == "v_B_A in cm/s"
    assert split_name("a_B/A.along_OB").name == "a_B_A.along_OB"
    for wrong in ("v_B/O", "v_B/B", "v_B/Z", "v_B/A.t", "v_B/A.along_AZ", "omega_B/A"):
        with pytest.raises(InputError):
            parse_quantity(wrong, scene)


@pytest.mark.parametrize(("language", "symbol"), [("en", "v_B/A"), ("ru", "v_BA")])
def test_symbols_and_notes(language, symbol):
    words = load_language(language)
    asked = [split_name(name) for name in ("v_B/A", "v_B/A.x", "v_B/A.angle", "max_v_B/A")]
    shown = [to_plain(words.quantity(quantity, {})) for quantity in asked]
    assert shown == [symbol, f"{symbol} x", f"∠({symbol}, x)", f"{symbol} {words.words('index')['max']}"]
    assert sum(symbol.removeprefix("v_") in note for note in answer_notes(asked, words)) == 1


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("methods", [[], ["coordinates"], ["graphical"]])
@pytest.mark.parametrize("text", [CARS, MIDPOINTS])
def test_a_solution(text, methods, language, tmp_path):
    """Every number printed is compared with the motion; a method that does not apply says so."""
    path = scene_file(tmp_path, text)
    shown = str(explain(one_variant(path), language=language, methods=methods))
    assert {"en": "relative to point", "ru": "относительно точки"}[language] in shown


def test_in_the_catalogue():
    form = load_family("four_bar").forms["crank"]
    quantity = parse_quantity("v_B/A", form.sample)
    assert form.may_be_asked(quantity)
    assert [source.name for source in quantity.sources(form.sample)] == ["omega_AB"]
