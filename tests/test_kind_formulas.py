"""Problems of the kinds of the books with data of our own, beside formulas that share nothing with the solver."""

from __future__ import annotations

import cmath
import json
from collections.abc import Callable
from math import acos, cos, hypot, pi, radians, sin, sqrt
from pathlib import Path

import pytest

from variantgen.cli import main

FOLDER = Path(__file__).parent / "kind_scenes"
STEP = 1e-4  # rad or s: an error of some 1e-7 in a second derivative


def _rates(place: Callable[[float], float], at: float) -> tuple[float, float]:
    """The first and the second derivative by central differences of the fourth order."""
    far, near, here, on, beyond = (place(at + k * STEP) for k in (-2, -1, 0, 1, 2))
    return (far - 8 * near + 8 * on - beyond) / (12 * STEP), (-far + 16 * near - 30 * here + 16 * on - beyond) / (
        12 * STEP**2
    )


def _crossing(first: complex, radius: float, second: complex, other: float) -> complex:
    """The point on the left of the way between two centres with these distances from them."""
    step = second - first
    corner = acos((radius**2 + abs(step) ** 2 - other**2) / (2 * radius * abs(step)))
    return first + step / abs(step) * cmath.rect(radius, corner)


def _epicyclic() -> dict[str, float]:
    arm = 240 * pi / 30 * 8 / 16
    planet = arm * 30 / 10  # no slip on the fixed wheel: 30 is the sum of the radii 20 and 10
    speed = 1j * (arm * cmath.rect(30, radians(40)) + planet * cmath.rect(10, radians(130)))
    return {"omega_planet": planet, "v_M": abs(speed), "omega_arm": 120}


def _rack() -> dict[str, float]:
    omega, epsilon = (80 * 3 - 15 * 3**2) / 60, (80 - 30 * 3) / 60
    return {"omega_gear": omega * 30 / pi, "epsilon_gear": epsilon, "a_M": 60 * hypot(omega**2, epsilon)}


def _ladder() -> dict[str, float]:
    x, v, a = 1 + 0.5 * 1.2**2, 1.2, 1.0
    y = sqrt(16 - x**2)
    down, omega = x * v / y, v / y
    return {"v_B": down, "a_B": (v**2 + x * a + down**2) / y, "omega_AB": omega, "epsilon_AB": (a + x * omega**2) / y}


def _lever_with_rope() -> dict[str, float]:
    def pin(t: float) -> complex:
        return 300j + cmath.rect(120, radians(20) + 2 * pi * t)

    def rope(t: float) -> float:
        return abs(600 * pin(t) / abs(pin(t)) - (-500 + 600j))

    v, a = _rates(rope, 0.0)
    return {"omega_CD": _rates(lambda t: cmath.phase(pin(t)), 0.0)[0], "v_W": abs(v), "a_W": abs(a)}


def _yoke() -> dict[str, float]:
    v, a = _rates(lambda t: 0.75 * cos(3 * t**2 + 0.2), 0.5)
    return {"v_Y": abs(v), "a_Y": abs(a)}


def _piston() -> dict[str, float]:
    def place(phi: float) -> float:
        return 3 * cos(phi) + sqrt(64 - (3 * sin(phi)) ** 2)

    rate = 2000 * pi / 30
    v, a = _rates(place, radians(40))
    turning = 3 * cos(radians(40)) * rate / sqrt(64 - (3 * sin(radians(40))) ** 2)
    return {"v_P": abs(v) * rate / 12, "a_P": abs(a) * rate**2 / 12, "omega_AP": turning, "x_P": place(radians(40))}


def _stephenson() -> dict[str, float]:
    def joints(t: float) -> tuple[complex, complex]:
        a = cmath.rect(15, radians(75) + 8 * t)
        b = _crossing(a, 45, 50, 30)
        e = a + (b - a) / 45 * (20 + 15j)
        return e, complex(e.real + sqrt(60**2 - e.imag**2))

    v, acceleration = _rates(lambda t: joints(t)[1].real, 0.0)
    turning, _ = _rates(lambda t: cmath.phase(joints(t)[1] - joints(t)[0]), 0.0)
    return {"v_D": abs(v), "omega_ED": turning, "a_D": abs(acceleration)}


def _whitworth() -> dict[str, float]:
    def ram(t: float) -> complex:
        pin = 50j + cmath.rect(120, radians(35) + pi * t)  # from C
        d = -90 * pin / abs(pin)
        return complex(d.real - sqrt(400**2 - d.imag**2), cmath.phase(pin))

    v, a = _rates(lambda t: ram(t).real, 0.0)
    half = acos(50 / 120)  # the arm of the ram lies along its guide
    ratio = (pi - half) / half
    return {"v_R": abs(v), "a_R": abs(a), "time_ratio_R": ratio, "omega_CD": _rates(lambda t: ram(t).imag, 0.0)[0]}


def _cam() -> dict[str, float]:
    def lift(t: float) -> float:
        phi = radians(30) + 150 * pi / 30 * t
        return 25 * sin(phi) + sqrt(75**2 - (25 * cos(phi)) ** 2)

    v, a = _rates(lift, 0.0)
    return {"v_B": abs(v), "a_B": abs(a)}


def _planet_between() -> dict[str, float]:
    sun, ring = 12 * 40, -3 * 80  # speeds of the contacts, 40 mm apart
    return {"omega_planet": (ring - sun) / 40, "omega_arm": (ring + sun) / 2 / 60}


def _belt_over_four() -> dict[str, float]:
    rim = 300 * 15  # rpm cm; the last pulley lies on the other side of the belt
    return {
        "omega_B": rim / 10,
        "omega_C": rim / 20,
        "omega_D": -rim / 5,
        "v_rope.P.Q": rim * pi / 30 / 100,
    }


KINDS = {
    "belt_over_four": _belt_over_four,
    "crossed_belt": lambda: {"omega_B": -300 * 15 / 25, "v_rope.O.C": 300 * pi / 30 * 0.15},  # no point moves
    "planet_between": _planet_between,
    "epicyclic_belt": _epicyclic,
    "hoist_two_ropes": lambda: {"v_B": 3 / 2, "v_D": 3 / 4, "a_D": 1.5 / 4},
    "rack_by_law": _rack,
    "ladder_by_law": _ladder,
    "slotted_lever_rope": _lever_with_rope,
    "yoke_by_law": _yoke,
    "piston_in_inches": _piston,
    "stephenson": _stephenson,
    "whitworth_ram": _whitworth,
    "cam_with_roller": _cam,
}


@pytest.mark.parametrize("name", KINDS)
def test_a_scene_has_the_answers_of_its_own_formula(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    path = str(FOLDER / f"{name}.toml")
    assert main(["solve", path, "--json"]) == 0
    found = {answer["quantity"]: answer["value"] for answer in json.loads(capsys.readouterr().out)["answers"]}
    assert found == pytest.approx(KINDS[name](), rel=1e-5)
    assert main(["solve", path, "--explain"]) == 0
    shown = capsys.readouterr()
    assert "\nAnswer: " in shown.out, shown.err
    assert " / 1 " not in shown.out
