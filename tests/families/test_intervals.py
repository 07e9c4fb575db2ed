"""Values of an interval of time: extremes, instants, ways and means beside formulas and quadrature of one's own."""

from __future__ import annotations

import json
import math

import mpmath
import numpy as np
import pytest

import variantgen
from tests.scene_files import scene_file, solved_values
from variantgen.cli import main

# A point on the axis x: x' = 3 (t - 5) (t + 1), so that it turns back at 5 s.
LINE = """
length_unit = "m"
[parameters]
t = { unit = "s", values = [4] }
[laws]
time = "t"
x = "t^3 - 6*t^2 - 15*t + 40"
interval = [0, 10]
[points]
M = { coordinates = { x = "x", y = 0 } }
[[joints]]
guide = { point = "M" }
[[drivers]]
travel = { point = "M", v = "x_dot" }
"""
ON_LINE = {
    "t_zero_v_M": 5,
    "way_M": 450,  # from 40 to -60 and to 290
    "mean_t_v_M": 45,
    "shift_M": 250,
    "average_v_M.x": 25,
    "average_a_M.x": (165 + 15) / 10,
    "max_t_v_M": 165,
    "t_max_v_M": 10,
    "min_t_v_M": 0,
    "t_min_v_M": 5,
    "max_t_x_M": 290,
    "min_t_x_M": -60,
    "t_min_x_M": 5,
    "t_back_M": 3 + math.sqrt(24),  # t^2 - 6 t - 15 = 0
    "t_zero_a_M": 2,
    "t_zero_v_M.x": 5,
    "t_zero_x_M": float(mpmath.findroot(lambda t: t**3 - 6 * t**2 - 15 * t + 40, 1.8)),
}
# A shell: 40 m/s and 30 m/s, g = 10 m/s2; a quarter of the way round a disc that comes up to speed.
SHELL = """
length_unit = "m"
[parameters]
t = { unit = "s", values = [1] }
T = { unit = "s", values = [4] }
[laws]
time = "t"
x = "40*t"
y = "30*t - 5*t^2 + 2"
interval = ["0 s", "2*T"]
[points]
M = { coordinates = { x = "x", y = "y" } }
[[drivers]]
travel = { point = "M", v = "x_dot" }
[[drivers]]
travel = { point = "M", v = "y_dot", angle = 90 }
"""
SHELL_FLIES = {
    "t_zero_y_M": 3 + math.sqrt(9.4),  # 5 t^2 - 30 t - 2 = 0
    "t_zero_v_M.y": 3,
    "t_max_y_M": 3,
    "max_t_y_M": 47,
    "min_t_v_M": 40,
    "max_t_v_M": math.hypot(40, 50),
    "way_M": float(mpmath.quad(lambda t: mpmath.sqrt(1600 + (30 - 10 * t) ** 2), [0, 3, 8])),
    "shift_M": math.hypot(320, 80),
    "shift_M.y": -80,
    "average_v_M": math.hypot(40, 10),
    "average_v_M.angle": math.degrees(math.atan2(-10, 40)),
    "average_a_M": 10,
    "max_t_a_M": 10,
}
# A crank of 30 cm with a rod of 80 cm that starts from rest: phi = 0.5 t^2, in 0 to 4 s 8 rad.
CRANK = """
length_unit = "cm"
[parameters]
t = { unit = "s", values = [1.5] }
[laws]
time = "t"
phi = "0.5*t^2"
interval = [0, 4]
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = 30, angle = "phi" } }
B = { line_circle = { through = "O", centre = "A", distance = 80, angle = 0, branch = "ahead" } }
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
[[joints]]
pivot = { point = "O" }
[[joints]]
guide = { point = "B" }
[[drivers]]
rotation = { body = "OA", omega = "phi_dot" }
"""


def _slider(t):
    phi = t * t / 2
    return 30 * mpmath.cos(phi) + mpmath.sqrt(6400 - 900 * mpmath.sin(phi) ** 2)


def _speed(t):
    return abs(mpmath.diff(_slider, t))


def _crank_turns() -> dict[str, float]:
    dead = [math.sqrt(2 * math.pi * k) for k in range(3)]  # where the crank lies along the guide
    best = float(mpmath.findroot(lambda t: mpmath.diff(_slider, t, 2), 3.85))  # the last peak before the end
    way = 60 + 60 + abs(110 - float(_slider(4)))
    return {
        "turned_OA": math.degrees(8),
        "turned_AB": math.degrees(-math.asin(30 * math.sin(8) / 80)),
        "max_t_omega_OA": 4,
        "t_max_omega_OA": 4,
        "way_B": way,
        "mean_t_v_B": way / 4,
        "shift_B.x": float(_slider(4)) - 110,
        "way_A": 30 * 8,
        "t_zero_v_B": dead[1],
        "min_t_x_B": 50,
        "t_min_x_B": dead[1],
        "max_t_v_B": float(_speed(best)),
        "t_max_v_B": best,
        "t_zero_omega_AB": math.sqrt(math.pi),  # at half pi
    }


@pytest.mark.parametrize(
    ("text", "expected"),
    [(LINE, ON_LINE), (SHELL, SHELL_FLIES), (CRANK, _crank_turns())],
    ids=["line", "shell", "crank"],
)
def test_values(text, expected, tmp_path, capsys):
    assert solved_values(scene_file(tmp_path, text), capsys, *expected) == pytest.approx(expected, rel=1e-7, abs=1e-7)


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize(
    ("text", "expected"),
    [(LINE, ON_LINE), (SHELL, SHELL_FLIES), (CRANK, _crank_turns())],
    ids=["line", "shell", "crank"],
)
def test_the_page_tells_the_interval_and_how_values_are_found(text, expected, language, tmp_path, capsys):
    asks = [word for name in expected for word in ("--ask", name)]
    path = str(scene_file(tmp_path, text))
    assert main(["show", path, "--explain", "--lang", language, *asks]) == 0, capsys.readouterr().err
    out = capsys.readouterr().out.replace("\N{NO-BREAK SPACE}", " ")
    last = "10" if text == LINE else "8" if text == SHELL else "4"
    assert f"0 ≤ t ≤ {last}" in " ".join(out.split())
    assert {"en": "interval of time", "ru": "промежуток времени"}[language] in out
    assert main(["show", path, "--lang", language, *asks, "--out", str(tmp_path / "page.pdf")]) == 0


def test_units(tmp_path, capsys):
    found = solved_values(scene_file(tmp_path, CRANK), capsys, "turned_OA in rev", "t_zero_v_B in min", "way_A in m")
    expected = {"turned_OA": 4 / math.pi, "t_zero_v_B": math.sqrt(2 * math.pi) / 60, "way_A": 2.4}
    assert found == pytest.approx(expected)


def test_what_does_not_come_has_no_value(tmp_path, capsys):
    path = str(scene_file(tmp_path, LINE.replace("[0, 10]", "[6, 10]")))
    assert main(["solve", path, "--ask", "t_zero_v_M"]) == 0
    assert "t_zero_v_M: no value: it does not come in the interval" in capsys.readouterr().out


def test_a_mechanism_that_cannot_move_all_through_the_interval_has_no_values(tmp_path, capsys):
    """The rod of 20 is shorter than the crank: the slider exists only near the guide."""
    text = CRANK.replace("distance = 80", "distance = 20").replace("values = [1.5]", "values = [0.5]")
    assert solved_values(scene_file(tmp_path, text), capsys, "way_B", "max_t_v_B") == {"way_B": None, "max_t_v_B": None}


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("[0, 10]", "[10, 0]", "ends before it begins"),
        ("[0, 10]", "10", "expected its beginning and its end"),
        ("[0, 10]", '[0, "x"]', "is a length, expected a time"),
        ('v = "x_dot"', "v = -15", "state its motion by a law of time too"),
    ],
)
def test_wrong_intervals(old, new, said, tmp_path, capsys):
    assert main(["solve", str(scene_file(tmp_path, LINE.replace(old, new))), "--ask", "way_M"]) == 2
    assert said in capsys.readouterr().err


@pytest.mark.parametrize("name", ["way_M", "t_zero_v_M", "max_t_v_M", "max_v_M"])
def test_without_an_interval_it_is_asked_for(name, tmp_path, capsys):
    path = str(scene_file(tmp_path, LINE.replace("interval = [0, 10]", "")))
    assert main(["solve", path, "--ask", name]) == 2
    assert "interval = [0, 3]" in capsys.readouterr().err


FAMILY = (
    CRANK.replace("values = [1.5]", "from = 0.5, to = 2, step = 0.05")
    .replace("distance = 30", 'distance = "OA"')
    .replace("[laws]", 'OA = { unit = "cm", from = 20, to = 40, step = 1 }\n[laws]')
)


def test_variants_of_a_scene_with_an_interval(tmp_path):
    """The way of the pin is 8 OA; the rod of 80 turns by - arcsin(OA sin 8 / 80)."""
    path = str(scene_file(tmp_path, FAMILY))
    found = variantgen.batch(path, 40, seed=1, ask=["way_A", "turned_AB", "t_zero_v_B"])
    lengths = found.table()["OA"]
    assert found.answers["way_A"] == pytest.approx(8 * lengths)
    assert found.answers["turned_AB"] == pytest.approx(np.degrees(-np.arcsin(lengths * math.sin(8) / 80)))
    assert found.answers["t_zero_v_B"] == pytest.approx(np.full(40, math.sqrt(2 * math.pi)))


def test_what_a_law_tells_by_the_axes_is_not_reflected(tmp_path):
    """The page says that phi is the angle of OA with the axis x; without a law the scene may be reflected."""
    path = str(scene_file(tmp_path, FAMILY))
    assert set(np.sign(variantgen.batch(path, 40, seed=1, ask=["turned_OA"]).answers["turned_OA"])) == {1.0}
    plain = FAMILY.partition("[laws]")[0] + "[points]" + FAMILY.partition("[points]")[2]
    path = str(scene_file(tmp_path, plain.replace('angle = "phi"', "angle = 70").replace('"phi_dot"', "2")))
    found = variantgen.batch(path, 40, seed=1, ask=["v_A.x"]).answers["v_A.x"]
    assert set(np.sign(found)) == {-1.0, 1.0}


def test_an_exam_with_an_interval(tmp_path, capsys):
    scene_file(tmp_path, FAMILY)
    exam = """
title = "T"
course = ""
seed = "5"
language = "en"
[[problem]]
family = "SCENE"
ask = ["v_B", "max_t_v_B", "way_B"]
"""
    (tmp_path / "exam.toml").write_text(exam.replace("SCENE", str(tmp_path / "scene.toml")), encoding="utf-8")
    out = tmp_path / "out"
    made = ["build", str(tmp_path / "exam.toml"), "--variants", "4", "--format", "html", "--out", str(out)]
    assert main(made) == 0, capsys.readouterr().err
    assert main(["verify", str(out)]) == 0, capsys.readouterr().err


def test_everything_of_an_interval(tmp_path, capsys):
    assert main(["solve", str(scene_file(tmp_path, LINE)), "--all", "--json"]) == 0
    found = {item["quantity"]: item["value"] for item in json.loads(capsys.readouterr().out)["all"]}
    names = ["way_M", "shift_M", "max_t_v_M", "t_max_v_M", "t_zero_v_M", "t_back_M"]
    assert {name: found[name] for name in names} == pytest.approx({name: ON_LINE[name] for name in names})


RADAR = """
length_unit = "m"
[parameters]
t = { unit = "s", values = [4] }
[laws]
time = "t"
h = "3*t^2"
interval = [0, 8]
[points]
C = { coordinates = { x = 0, y = 0 } }
R = { coordinates = { x = 40, y = "h" } }
S = "R"
[bodies]
CR = ["C", "S"]
[[joints]]
pivot = { point = "C" }
[[joints]]
guide = { point = "R", angle = 90 }
[[joints]]
slot = { point = "R", body = "CR", along = ["C", "S"] }
[[drivers]]
travel = { point = "R", v = "h_dot", angle = 90 }
"""


def test_places_of_bodies_that_are_named_anew_at_every_instant(tmp_path, capsys):
    """The angle arctan(h / 40) of a slotted arm; the contact of a wheel of 0.5 m that rolls 3 m and back 1 m."""
    found = solved_values(scene_file(tmp_path, RADAR), capsys, "turned_CR", "t_max_omega_CR", "max_t_a_R")
    expected = {"turned_CR": math.degrees(math.atan(192 / 40)), "t_max_omega_CR": (1600 / 27) ** 0.25, "max_t_a_R": 6}
    assert found == pytest.approx(expected)
    wheel = LINE.replace('M = { coordinates = { x = "x", y = 0 } }', WHEEL).replace(
        '[[joints]]\nguide = { point = "M" }', '[[joints]]\nrolling = { body = "w", centre = "M", contact = "P" }'
    )
    wheel = wheel.replace("t^3 - 6*t^2 - 15*t + 40", "4*t - t^2").replace("[0, 10]", "[0, 3]")
    wheel = wheel.replace("[[joints]]", '[bodies]\nw = ["M", "P"]\n[[joints]]')
    found = solved_values(scene_file(tmp_path, wheel), capsys, "turned_w", "way_M", "max_t_a_P")
    expected = {"turned_w": -math.degrees(3 / 0.5), "way_M": 5, "max_t_a_P": 4**2 / 0.5}
    assert found == pytest.approx(expected)


WHEEL = """
M = { coordinates = { x = "x", y = 0.5 } }
P = { coordinates = { x = "x", y = 0 } }
"""
