"""Laws given by a velocity or an acceleration with a start: numbers of mpmath and by hand, texts, messages."""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Callable
from pathlib import Path

import mpmath
import numpy as np
import pytest

import variantgen
from tests.scene_files import scene_file, solved_values
from variantgen.cli import main

SCENE = """
length_unit = "{unit}"
[parameters]
{parameter}
[laws]
{laws}
[points]
B = {{ coordinates = {{ x = "s", y = 0 }} }}
[[joints]]
guide = {{ point = "B" }}
[[drivers]]
travel = {{ point = "B", v = "s_dot" }}
"""
BY_TIME = 't = { unit = "s", values = [2] }'
BY_PLACE = 's = { unit = "m", values = [2] }'


def _written(folder: Path, law: str, parameter: str = BY_TIME, interval: str = "", unit: str = "m") -> str:
    laws = ('time = "t"\n' if parameter.startswith("t") else "") + f"s = {{ {law} }}\n" + interval
    return str(scene_file(folder, SCENE.format(unit=unit, parameter=parameter, laws=laws)))


def _by_mpmath(acceleration: Callable, place: float, velocity: float, t: float) -> tuple[float, float, float]:
    """Place, velocity, acceleration at the time t of ``s'' = a(t, s, v)``, by mpmath's Taylor series."""
    flow = mpmath.odefun(lambda x, y: [y[1], acceleration(x, y[0], y[1])], 0, [place, velocity], tol=1e-15)
    s, v = flow(t)
    return float(s), float(v), float(acceleration(t, s, v))


# The acceleration as a file states it and as a function, with place and velocity at t = 0.
ACCELERATIONS: list[tuple[str, Callable, float, float]] = [
    ("6*t - 12", lambda t, s, v: 6 * t - 12, 1, 9),
    ("2 * sin(3*t) + exp(-t)", lambda t, s, v: 2 * mpmath.sin(3 * t) + mpmath.exp(-t), 0.5, -1),
    ("t * exp(-0.5*t)", lambda t, s, v: t * mpmath.exp(-t / 2), 0, 0),
    ("-0.4*v", lambda t, s, v: -0.4 * v, 2, 8),
    ("9.81 - 0.1*v", lambda t, s, v: 9.81 - 0.1 * v, 0, 3),
    ("-0.4*v^2", lambda t, s, v: -0.4 * v**2, 1, 8),
    ("-4*s", lambda t, s, v: -4 * s, 0.3, 2),
    ("5 - 4*s", lambda t, s, v: 5 - 4 * s, 0.3, 2),
    ("9.81 - 0.02*v^2", lambda t, s, v: 9.81 - 0.02 * v**2, 0, 0),  # from here on by an integrator
    ("-0.3*v - 4*s", lambda t, s, v: -0.3 * v - 4 * s, 1, 0),
    ("0.5*s", lambda t, s, v: 0.5 * s, 1, 0.2),
    ("2*t - 0.5*v*s", lambda t, s, v: 2 * t - 0.5 * v * s, 0.4, 1),
    ("sin(t)^2", lambda t, s, v: mpmath.sin(t) ** 2, 0, 1),
]


@pytest.mark.parametrize(("text", "function", "place", "velocity"), ACCELERATIONS, ids=[a[0] for a in ACCELERATIONS])
def test_an_acceleration_leads_to_the_motion(
    text: str, function: Callable, place: float, velocity: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = _written(tmp_path, f'a = "{text}", start = {{ s = {place}, v = {velocity} }}')
    found = solved_values(path, capsys, "x_B", "v_B.x", "a_B.x")
    expected = _by_mpmath(function, place, velocity, 2)
    assert list(found.values()) == pytest.approx(expected, rel=1e-7, abs=1e-7)


@pytest.mark.parametrize(
    ("text", "begun", "expected"),
    [
        # 3 t^2 - 2 t from t = 1, s = 5: t^3 - t^2 + 5; velocity 8, acceleration 6 t - 2.
        ("3*t^2 - 2*t", "t = 1, s = 5", (9, 8, 10)),
        # v = 10 - 0.2 s: s = 50 (1 - e^(-t/5)).
        ("10 - 0.2*s", "s = 0", (50 * (1 - math.exp(-0.4)), 10 * math.exp(-0.4), -2 * math.exp(-0.4))),
        # v = s^2 / 4 from s = 1: s = 1 / (1 - t/4).
        ("s^2 / 4", "s = 1", (2, 1, 1)),
        # v = 2 sqrt(s) from s = 1 by an integrator: s = (1 + t)^2.
        ("2*sqrt(s)", "s = 1", (9, 6, 2)),
        # v = t s by an integrator: s = e^(t^2 / 2).
        ("t * s", "s = 1", (math.exp(2), 2 * math.exp(2), 5 * math.exp(2))),
    ],
)
def test_a_velocity_leads_to_the_motion(
    text: str, begun: str, expected: tuple[float, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = solved_values(_written(tmp_path, f'v = "{text}", start = {{ {begun} }}'), capsys, "x_B", "v_B.x", "a_B.x")
    assert list(found.values()) == pytest.approx(expected, rel=1e-7)


@pytest.mark.parametrize(
    ("law", "velocity", "acceleration"),
    [
        ('v = "10 - 0.2*s"', 9.6, -0.2 * 9.6),
        ('a = "4*s", start = { s = 0, v = 3 }', 5, 8),  # v^2 = 9 + 4 s^2
        ('a = "-4*s", start = { s = 2.5, v = -4 }', -5, -8),  # v^2 = 16 + 4 (2.5^2 - s^2)
        ('a = "-0.5*v", start = { s = 0, v = 9 }', 8, -4),  # v = 9 - 0.5 s
        ('a = "-0.4*v^2", start = { s = 0, v = 8 }', 8 * math.exp(-0.8), -0.4 * 64 * math.exp(-1.6)),
        # dv^2/ds = 2 (9.81 - 0.02 v^2), by an integrator
        (
            'a = "9.81 - 0.02*v^2", start = { s = 0, v = 0 }',
            math.sqrt(490.5 * (1 - math.exp(-0.08))),
            9.81 * math.exp(-0.08),
        ),
        ('a = "30/s^2", start = { s = 1, v = 2 }', math.sqrt(4 + 60 * (1 - 0.5)), 7.5),
    ],
)
def test_rates_at_a_place(
    law: str, velocity: float, acceleration: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = solved_values(_written(tmp_path, law, BY_PLACE), capsys, "v_B.x", "a_B.x")
    assert list(found.values()) == pytest.approx([velocity, acceleration], rel=1e-7)


@pytest.mark.parametrize(
    ("law", "interval", "expected"),
    [
        ('a = "4*s", start = { s = 0, v = 3 }', "[0, 2]", math.asinh(4 / 3) / 2),
        ('a = "4*s", start = { s = 0.5, v = 0 }', '["0.5 m", 2]', math.acosh(4) / 2),  # from rest
        ('v = "10 - 2*s"', "[0, 4]", math.log(5) / 2),
        ('a = "-2", start = { s = 0, v = 4 }', "[0, 3]", 1),
        ('v = "-5"', "[3, 1]", 0.4),
    ],
)
def test_the_time_of_a_way(
    law: str, interval: str, expected: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = _written(tmp_path, law, BY_PLACE, f"interval = {interval}")
    found = solved_values(path, capsys, "duration_B", "mean_t_v_B", "way_B")
    assert found["duration_B"] == pytest.approx(expected, rel=1e-7)
    assert found["mean_t_v_B"] == pytest.approx(found["way_B"] / expected, rel=1e-7)


def test_numbers_are_in_the_unit_of_the_law(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """In feet: v^2 = 16 + 2 * 3 * 2 = 28 with 2 ft as the place; starts may have units of their own."""
    law = 'a = "36 in/s^2", unit = "ft", start = { s = "0 m", v = "48 in/s" }'
    path = _written(tmp_path, law, 's = { unit = "ft", values = [2] }', unit="m")
    assert solved_values(path, capsys, "v_B in ft/s")["v_B"] == pytest.approx(math.sqrt(28))


def test_parameters_in_a_rate(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """``v = v_0 (1 - t/T)``: at half the time half the velocity, and three quarters of ``v_0 T / 2``."""
    parameters = f'{BY_TIME}\nT = {{ unit = "s", values = [4] }}\nu = {{ unit = "m/s", values = [6] }}'
    path = _written(tmp_path, 'v = "u * (1 - t/T)", start = { s = "1 m" }', parameters)
    assert list(solved_values(path, capsys, "x_B", "v_B").values()) == pytest.approx([1 + 9, 3])


def _plain(capsys: pytest.CaptureFixture[str]) -> str:
    """What has been printed, with plain blanks and letters with their dots."""
    return unicodedata.normalize("NFC", capsys.readouterr().out).replace("\N{NO-BREAK SPACE}", " ")


CRANK = """
length_unit = "cm"
[parameters]
{parameter}
[laws]
{laws}
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
A = {{ polar = {{ origin = "O", distance = 20, angle = "phi" }} }}
B = {{ line_circle = {{ through = "O", angle = 0, centre = "A", distance = 50, branch = 1 }} }}
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
guide = {{ point = "B" }}
[[drivers]]
rotation = {{ body = "OA", omega = "phi_dot" }}
"""


def _place(phi: mpmath.mpf) -> mpmath.mpf:
    """The slider of the crank, in centimetres."""
    return 20 * mpmath.cos(phi) + mpmath.sqrt(2500 - (20 * mpmath.sin(phi)) ** 2)


def test_a_crank_between_two_positions(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """At 10 rad/s from 30 to 90 degrees: no law of time is needed."""
    laws = 'phi = { omega = 10 }\ninterval = ["30 deg", "90 deg"]'
    path = tmp_path / "crank.toml"
    path.write_text(CRANK.format(parameter='phi = { unit = "deg", values = [30] }', laws=laws), encoding="utf-8")
    found = solved_values(str(path), capsys, "mean_t_v_B", "duration_B", "max_t_v_B", "t_max_v_B", "way_B", "turned_OA")

    def speed(phi: mpmath.mpf) -> mpmath.mpf:
        return -10 * mpmath.diff(_place, phi)

    fastest = mpmath.findroot(lambda phi: mpmath.diff(speed, phi), 1.3)
    way = float(_place(mpmath.pi / 6) - _place(mpmath.pi / 2))
    time = math.pi / 30
    assert list(found.values()) == pytest.approx(
        [way / time, time, float(speed(fastest)), float((fastest - mpmath.pi / 6) / 10), way, 60], rel=1e-7
    )


def test_a_sheet_of_an_interval_backwards(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    laws = 'phi = { omega = "-100 rpm" }\ninterval = ["90 deg", "30 deg"]'
    path = tmp_path / "crank.toml"
    path.write_text(CRANK.format(parameter='phi = { unit = "deg", values = [60] }', laws=laws), encoding="utf-8")
    for language in ("en", "ru"):
        assert main(["show", str(path), "--ask", "duration_B", "--lang", language, "--explain"]) == 0
        assert "90 ≥ φ ≥ 30°" in _plain(capsys)
        assert (
            main(["show", str(path), "--ask", "duration_B", "--lang", language, "--out", str(tmp_path / "p.pdf")]) == 0
        )


def test_a_crank_with_an_angular_acceleration_of_the_time(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """``epsilon = 6 t`` from rest at 20 degrees: ``phi = t^3 + 20 degrees``."""
    laws = 'time = "t"\nphi = { epsilon = "6*t", start = { phi = "20 deg", omega = 0 } }'
    path = tmp_path / "crank.toml"
    path.write_text(CRANK.format(parameter='t = { unit = "s", values = [0.8] }', laws=laws), encoding="utf-8")
    found = solved_values(str(path), capsys, "omega_OA", "epsilon_OA", "v_B.x", "a_B.x")

    def place(t: mpmath.mpf) -> mpmath.mpf:
        return _place(t**3 + mpmath.pi / 9)

    expected = [3 * 0.64, 4.8, *(float(mpmath.diff(place, 0.8, n)) for n in (1, 2))]
    assert list(found.values()) == pytest.approx(expected, rel=1e-7)


def test_a_crank_whose_velocity_depends_on_its_angle(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """``epsilon = 2 phi`` from rest at 0.1 rad: ``omega^2 = 2 (phi^2 - 0.01)``."""
    laws = 'phi = { epsilon = "2*phi", start = { phi = 0.1, omega = 0 } }'
    path = tmp_path / "crank.toml"
    path.write_text(CRANK.format(parameter='phi = { unit = "deg", values = [60] }', laws=laws), encoding="utf-8")
    found = solved_values(str(path), capsys, "omega_OA", "epsilon_OA")
    assert list(found.values()) == pytest.approx([math.sqrt(2 * ((math.pi / 3) ** 2 - 0.01)), 2 * math.pi / 3])


def test_what_is_a_function_of_the_place(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """On ``y = x^2 / 4`` with ``v_x = 3`` at x = 2: ``v_y = x v_x / 2``, ``a_y = v_x^2 / 2``."""
    path = tmp_path / "path.toml"
    path.write_text(
        """
length_unit = "m"
[parameters]
x = { unit = "m", values = [2] }
[laws]
x = { v = 3 }
y = "x^2 / (4*m)"
[points]
B = { coordinates = { x = "x", y = "y" } }
[[drivers]]
travel = { point = "B", v = "x_dot" }
[[drivers]]
travel = { point = "B", v = "y_dot", angle = 90 }
""",
        encoding="utf-8",
    )
    found = solved_values(str(path), capsys, "v_B.x", "v_B.y", "a_B.y", "rho_B")
    assert list(found.values()) == pytest.approx([3, 3, 4.5, (9 + 9) ** 1.5 / (3 * 4.5)])


@pytest.mark.parametrize(
    ("law", "parameter", "lines"),
    [
        ('a = "6*t - 12", start = { s = 0, v = 9 }', BY_TIME, ["ṡ = 3 t^2 − 12 t + C_1", "C_1 = 9"]),
        ('a = "-0.4*v", start = { s = 2, v = 8 }', BY_TIME, ["s̈ = −0.4 · ṡ", "ṡ = 8 · exp(−0.4 · t)"]),
        ('a = "4*s", start = { s = 0, v = 3 }', BY_PLACE, ["ṡ^2 / 2 = 2 s^2 + C", "C = 4.5", "v_B = ṡ = √(4 s^2 + 9)"]),
        ('a = "9.81 - 0.02*v^2", start = { s = 0, v = 0 }', BY_TIME, ["s̈ = 9.81 − ṡ^2 / 50", "ṡ = 15.71 m/s"]),
    ],
)
def test_a_solution_integrates(
    law: str, parameter: str, lines: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = _written(tmp_path, law, parameter)
    for language, heading in (("en", "1. Law of motion"), ("ru", "1. Закон движения")):
        assert main(["solve", path, "--explain", "--lang", language, "--ask", "v_B", "--ask", "a_B"]) == 0
        shown = _plain(capsys)
        assert heading in shown
        for line in lines if language == "en" else ():
            assert line in shown


def test_a_sheet_tells_the_rate_and_the_start(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = _written(tmp_path, 'a = "-0.4*v", start = { s = 2, v = 8 }')
    assert main(["show", path, "--ask", "v_B"]) == 0
    english = _plain(capsys)
    assert "s̈ = −0.4 · ṡ m/s²" in english
    assert "t_0 = 0 s, s_0 = 2 m, ṡ_0 = 8 m/s" in english
    assert "index 0" in english
    assert main(["check", path]) == 0


def test_a_start_is_told_in_the_unit_in_which_it_is_short(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """30 rpm are pi rad/s; and what the law says of the crank, the angle of OA, stands on the sheet once."""
    laws = 'phi = { epsilon = "-2*omega", start = { phi = "10 deg", omega = "30 rpm" } }'
    path = tmp_path / "crank.toml"
    path.write_text(CRANK.format(parameter='phi = { unit = "deg", values = [30] }', laws=laws), encoding="utf-8")
    for language, unit in (("en", "rpm"), ("ru", "об/мин")):
        assert main(["show", str(path), "--ask", "v_B", "--lang", language]) == 0
        shown = " ".join(_plain(capsys).split())
        assert f"φ̇_0 = 30 {unit}" in shown
        assert shown.count("∠(OA, x)") == 1


def test_a_start_by_a_parameter(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    parameters = f'{BY_TIME}\nu = {{ unit = "m/s", values = [8] }}'
    path = _written(tmp_path, 'a = "-0.4*v", start = { s = "2 m", v = "u" }', parameters)
    assert list(solved_values(path, capsys, "v_B").values()) == pytest.approx([8 * math.exp(-0.8)], rel=1e-7)
    assert main(["show", path, "--ask", "v_B"]) == 0
    shown = _plain(capsys)
    assert "u = 8 m/s" in shown
    assert "ṡ_0 = u" in shown


def test_values_that_do_not_come_to_the_place_are_no_contradiction(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """``v^2 = u^2 - 4 s^2``: with 3 m/s it turns back before 2 m, and the others stay."""
    parameters = f'{BY_PLACE}\nu = {{ unit = "m/s", values = [3, 5, 8] }}'
    path = _written(tmp_path, 'a = "-4*s", start = { s = "0 m", v = "u" }', parameters)
    assert main(["solve", path, "--set", "u=5", "--ask", "v_B.x"]) == 0
    assert "v_B.x = 3 m/s" in _plain(capsys)


@pytest.mark.parametrize("parameter", [BY_TIME, BY_PLACE])
def test_an_acceleration_is_told_where_velocities_depend_on_it(
    parameter: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    parameters = f'{parameter}\na_0 = {{ unit = "m/s^2", values = [3] }}'
    path = _written(tmp_path, 'a = "a_0", start = { s = "0 m", v = "1 m/s" }', parameters)
    assert main(["show", path, "--ask", "v_B"]) == 0
    shown = _plain(capsys)
    assert "a_0 = 3 m/s²" in shown
    assert f"v_B = {7 if parameter == BY_TIME else '3.606'} m/s" in shown  # 1 + 3 * 2, the root of 1 + 2 * 3 * 2


@pytest.mark.parametrize(
    ("law", "parameter", "key", "said"),
    [
        ('a = "6*t"', BY_TIME, "laws.s.start", "start = { t = 0, s = 0, v = 2 }"),
        ('a = "6*t", start = { s = 0 }', BY_TIME, "laws.s.start.v", "with your numbers"),
        ('v = "6*t", start = { s = 0, v = 1 }', BY_TIME, "laws.s.start.v", "unknown key"),
        ('a = "0.5*v^2", start = { s = 0, v = 9 }', BY_TIME, "laws.s", "does not come from its start"),
        ('a = "v^2 + t", start = { s = 0, v = 9 }', BY_TIME, "laws.s", "does not come from its start"),
        ('v = "sqrt(1 - t)", start = { s = 0 }', BY_TIME, "laws.s", "does not come from its start"),
        ('a = "-4*s", start = { s = 0, v = 3 }', BY_PLACE, "laws.s", "its velocity comes to zero before"),
        # Thrown upwards it comes to a place below with a velocity downwards, not with that of the way there.
        ('a = "-9.8", start = { s = 4, v = 5 }', BY_PLACE, "laws.s", "or leads away"),
        ('a = "4*s", start = { s = 0, v = 0 }', BY_PLACE, "laws.s", "its velocity comes to zero before"),
        (
            'a = "-4*s", start = { s = "0 m", v = "u" }',
            f'{BY_PLACE}\nu = {{ unit = "m/s", values = [-8, 7, 8] }}',
            "laws.s.start",
            "now forwards, now backwards",
        ),
        # Through a pole, which none of the places that are looked at need meet.
        ('v = "1/(t - 1.01)^2", start = { s = 0 }', BY_TIME, "laws.s", "does not come from its start"),
        ('v = "s^2", start = { s = 0.99 }', BY_TIME, "laws.s", "does not come from its start"),
        ('a = "-1/(s - 1.01)^3", start = { s = 0, v = 1 }', BY_PLACE, "laws.s", "does not come from its start"),
        ("v = 1, a = 2, start = { s = 0 }", BY_TIME, "laws.s", "one rate"),
        ('omega = "2"', BY_PLACE, "laws.s", "an angle"),
        ('v = "2*v", start = { s = 0 }', BY_TIME, "laws.s", "cannot depend on itself"),
        ('v = "6*q", start = { s = 0 }', BY_TIME, "laws.s", "unknown name"),
        ('v = "2*t^2*m", start = { s = 0 }', BY_TIME, "laws.s", "expected a velocity"),
        ('a = "6*t", start = { s = "one m", v = 9 }', BY_TIME, "laws.s.start.s", "not an arithmetic expression"),
        ('a = "6*t", start = { s = 0, v = "9 s" }', BY_TIME, "laws.s.start.v", "9 s"),
        ('v = "t", unit = "deg", start = { s = 0 }', BY_TIME, "laws.s.unit", "unit of length"),
    ],
)
def test_mistakes_are_said(
    law: str, parameter: str, key: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["solve", _written(tmp_path, law, parameter), "--ask", "v_B"]) == 2
    shown = capsys.readouterr().err
    assert f"{key}:" in shown
    assert said in shown


def test_a_driver_against_its_law_is_told_at_a_place(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """v = 3 / s times 0.2 m; the driver goes the other way."""
    path = Path(_written(tmp_path, 'v = "3*s"', 's = { unit = "mm", values = [200] }', unit="mm"))
    path.write_text(path.read_text("utf-8").replace('"s_dot"', '"-s_dot"'), encoding="utf-8")
    assert main(["solve", str(path), "--ask", "v_B"]) == 2
    assert "expected 0.6 m/s, for at s = 200 mm its place" in capsys.readouterr().err


def test_an_interval_against_the_motion_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = _written(tmp_path, "v = 5", BY_PLACE, "interval = [3, 1]")
    assert main(["solve", path, "--ask", "duration_B"]) == 2
    assert "laws.interval: s does not come from its first value to its last one" in capsys.readouterr().err


def test_a_batch_of_laws_that_are_integrated_numerically(tmp_path: Path) -> None:
    """``dv^2/ds = 2 (c - 0.02 v^2)`` from rest, for several accelerations and places at once."""
    parameters = (
        's = { unit = "m", values = [1, 2, 3, 5] }\nc = { unit = "m/s^2", values = [4, 8, 9.81] }\n'
        'h = { unit = "m", values = [50] }'
    )
    path = _written(tmp_path, 'a = "c - v^2 / h", start = { s = 0, v = 0 }', parameters)
    found = variantgen.batch(path, 12, 1, ask=["v_B", "a_B"])
    place, c = (np.asarray(found.parameters[name]) for name in ("s", "c"))
    square = 50 * c * (1 - np.exp(-place / 25))
    assert len(set(zip(place.tolist(), c.tolist(), strict=True))) > 3
    assert np.asarray(found.answers["v_B"]) == pytest.approx(np.sqrt(square), rel=1e-9)
    assert np.asarray(found.answers["a_B"]) == pytest.approx(c - square / 50, rel=1e-9)


FOUND = """
length_unit = "m"
[laws]
time = "t"
interval = [0, 6]
instant = "{event}"
s = {{ {law} }}
[points]
B = {{ coordinates = {{ x = "s", y = 0 }} }}
[[joints]]
guide = {{ point = "B" }}
[[drivers]]
travel = {{ point = "B", v = "s_dot" }}
"""


@pytest.mark.parametrize(
    ("law", "event", "time", "velocity"),
    [
        # v = 8 - 0.4 s = 8 e^(-0.4 t)
        ('a = "-0.4*v", start = { s = 0, v = 8 }', "s = 1.4 m", -math.log(7.44 / 8) / 0.4, 7.44),
        # v = k tanh(g t / k), k^2 = 490.5, by an integrator
        (
            'a = "9.81 - 0.02*v^2", start = { s = 0, v = 0 }',
            "v_B = 10 m/s",
            math.sqrt(490.5) / 9.81 * math.atanh(10 / math.sqrt(490.5)),
            10,
        ),
    ],
)
def test_an_instant_of_such_a_law_is_found(
    law: str, event: str, time: float, velocity: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "found.toml"
    path.write_text(FOUND.format(event=event, law=law), encoding="utf-8")
    found = solved_values(str(path), capsys, "t", "v_B")
    assert list(found.values()) == pytest.approx([time, velocity], rel=1e-7)


def test_no_instant_is_found_at_a_given_place(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = _written(tmp_path, "v = 5", BY_PLACE, 'interval = [0, 2]\ninstant = "v_B = 5 m/s"')
    assert main(["solve", path, "--ask", "v_B"]) == 2
    assert "laws.instant: an instant cannot be found where the place s is given" in capsys.readouterr().err
