"""Problems of the kinds of the books with data of our own, beside formulas that share nothing with the solver."""

from __future__ import annotations

import cmath
from collections.abc import Callable
from math import acos, asin, cos, exp, hypot, pi, radians, sin, sqrt
from pathlib import Path

import pytest

from tests.scene_files import solved_values
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


def _two_cyclists() -> dict[str, float]:
    def apart(t: float) -> float:
        return hypot(6 * t - 20, -60 + 8 * t - 0.2 * t**2)

    # (6 t - 20) 6 = (60 - 8 t + 0.2 t^2) (8 - 0.4 t)
    nearest = _root(lambda t: (6 * t - 20) * 6 + (-60 + 8 * t - 0.2 * t**2) * (8 - 0.4 * t), 0, 15)
    found = {"v_A_B": hypot(6, 6), "v_A_B.angle": -45, "average_v_B.y": 5}
    return found | {"t_min_distance_A.B": nearest, "min_t_distance_A.B": apart(nearest)}


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    """The root between two places, by halving."""
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (low, middle) if function(low) * function(middle) <= 0 else (middle, high)
    return low


def _spindle() -> dict[str, float]:
    turned = 48 - 16 * (1 - exp(-3))
    mean = turned / 6 * 30 / pi
    found = {"omega_D": 8 * (1 - exp(-3)), "turned_D": turned / 2 / pi}
    return found | {"mean_t_omega_D": mean, "way_A": 0.25 * turned}


def _spiral() -> dict[str, float]:
    r = 0.4 * exp(0.45)
    found = {"v_P.along_OP": 0.3 * r, "v_P.across_OP": 0.6 * r, "rho_P": r * sqrt(1 + 0.5**2)}
    return found | {"a_P.along_OP": (0.3**2 - 0.6**2) * r, "a_P.across_OP": 2 * 0.3 * 0.6 * r}


def _jet() -> dict[str, float]:
    v, a = complex(34, 64 * 34 / 200), complex(2, (34**2 + 64 * 2) / 200)
    along, across = (a * v.conjugate()).real / abs(v), abs((a * v.conjugate()).imag) / abs(v)
    return {"v_J": abs(v), "a_J.t": along, "a_J.n": across, "rho_J": abs(v) ** 2 / across}


def _coupler_across_rocker() -> dict[str, float]:
    """The right angle at B: AC is the hypotenuse of AB and BC."""
    begin = acos((7**2 + 20**2 - 18**2 - 14**2) / (2 * 7 * 20))

    def joint(t: float) -> tuple[complex, complex]:
        a = cmath.rect(7, begin - 4 * pi * t)
        return a, _crossing(a, 18, 20, 14)

    parts = [_rates(lambda t, part=part: getattr(joint(t)[1] - joint(t)[0], part), 0.0) for part in ("real", "imag")]
    found = {"omega_BC": _rates(lambda t: cmath.phase(joint(t)[1] - 20), 0.0)[0]}
    found["omega_AB"] = _rates(lambda t: cmath.phase(joint(t)[1] - joint(t)[0]), 0.0)[0]
    (vx, ax), (vy, ay) = parts
    return found | {"v_B_A": hypot(vx, vy) / 12, "a_B_A": hypot(ax, ay) / 12}


def _boat() -> dict[str, float]:
    speed, way = 12 * exp(-5 / 3), 36 * (1 - exp(-5 / 3))
    return {"v_M": speed, "a_M": speed / 3, "way_M": way, "mean_t_v_M": way / 5}


def _crank_swings() -> dict[str, float]:
    """It swings there and back in the same way: what is reached on the way up comes first."""

    def place(t: float) -> float:
        phi = radians(50 + 40 * sin(4 * t))
        return 120 * cos(phi) + sqrt(300**2 - (120 * sin(phi)) ** 2)

    best = max((k * 1e-3 for k in range(390)), key=lambda t: abs(_rates(place, t)[0]))
    best = _root(lambda t: _rates(place, t)[1], best - 2e-3, best + 2e-3)
    found = {"max_t_v_B": abs(_rates(place, best)[0]) / 1000, "t_max_v_B": best}
    return found | {"max_t_x_B": place(3 * pi / 8), "t_zero_omega_OA": pi / 8}


def _radar() -> dict[str, float]:
    """tan(angle) = h / 40; its rate 240 t / (1600 + 9 t^4) is largest where 27 t^4 = 1600."""
    square = 1600 + 9 * 4**4
    found = {"omega_CR": 240 * 4 / square, "epsilon_CR": 240 * (square - 36 * 4**4) / square**2}
    found |= {"v_R.along_CR": 24 * 48 / sqrt(square), "distance_C.R": sqrt(square)}
    return found | {"t_max_omega_CR": (1600 / 27) ** 0.25}


def _wheel_comes_back() -> dict[str, float]:
    """s' = 4 t - t^2, s(6) = 0; at 1 s the wheel turns at 10 rad/s and speeds up by 2 / 0.3."""
    found = {"max_t_v_O": 12, "t_max_v_O": 6, "t_zero_v_O": 4, "turned_w": 0}
    return found | {"v_M_O": 3, "a_M": hypot(2 - 3**2 / 0.3, 2)}


def _projectile() -> dict[str, float]:
    lands = (60 + sqrt(60**2 + 4 * 16.1 * 6)) / 32.2
    return {"t_zero_y_M": lands, "max_t_y_M": 6 + 60**2 / 64.4, "t_max_y_M": 60 / 32.2, "average_v_M.x": 80}


def _follower() -> dict[str, float]:
    return {"max_t_v_F": 40 * pi, "t_max_v_F": 0.25, "max_t_a_F": 80 * pi**2, "mean_t_v_F": 80}


def _ladder_in_time() -> dict[str, float]:
    angle = asin(3 / 5) - asin(1 / 5)
    found = {"turned_AB": angle * 180 / pi, "mean_t_omega_AB": angle / 4, "way_D": 2.5 * angle}
    return found | {"max_t_v_B": 3 * 0.5 / 4, "average_v_B.y": (4 - sqrt(24)) / 4}


def _car_and_bend() -> dict[str, float]:
    ray = cmath.rect(60, radians(-120))
    seen = (-0.05j - 0.25**2) * ray - cmath.rect(1.2, radians(30))
    found = {"v_B_A": 15, "v_B_A.angle": -90}
    return found | {"a_B_A": abs(seen), "a_B_A.angle": cmath.phase(seen) * 180 / pi}


def _planet_seen() -> dict[str, float]:
    """The sun of 40 rests: the planet of 20 turns three times as fast as its arm; M lies across it."""
    arm, planet = 2 * pi, 6 * pi
    found = {"omega_p": planet, "v_M_A": planet * 0.02, "a_M_A": planet**2 * 0.02}
    return found | {"v_M": hypot(arm * 60, planet * 20)}


def _slider(phi: float) -> tuple[float, float]:
    """The place of a slider (cm) by the angle of its crank of 20, with a rod of 60, and the angle of the rod."""
    return 20 * cos(phi) + sqrt(60**2 - (20 * sin(phi)) ** 2), -asin(sin(phi) / 3)


def _crank_turned() -> dict[str, float]:
    """0.5 t^2 + t = 2 pi / 3."""
    instant = sqrt(1 + 4 * pi / 3) - 1
    v, a = _rates(lambda t: _slider(t**2 / 2 + t)[0], instant)
    turning, _ = _rates(lambda t: _slider(t**2 / 2 + t)[1], instant)
    return {"instant_t": instant, "v_B": abs(v), "a_B": abs(a), "omega_AB": turning}


def _slider_at_speed() -> dict[str, float]:
    def place(t: float) -> float:
        return _slider(t**2 / 2 + t)[0]

    before = next(k * 1e-3 for k in range(1, 3000) if abs(_rates(place, (k + 1) * 1e-3)[0]) >= 50)
    instant = _root(lambda t: abs(_rates(place, t)[0]) - 50, before, before + 1e-3)
    found = {"instant_t": instant, "x_B": place(instant) / 100, "omega_OA": instant + 1}
    return found | {"epsilon_AB": _rates(lambda t: _slider(t**2 / 2 + t)[1], instant)[1]}


def _stone() -> dict[str, float]:
    """4.9 t^2 - 15 t + 6 = 0: the way up is before the beginning of the interval, so the stone falls."""
    instant = (15 + sqrt(15**2 - 4 * 4.9 * 6)) / 9.8
    down = 15 - 9.8 * instant
    speed = hypot(12, down)
    found = {"instant_t": instant, "v_M": speed, "v_M.angle": cmath.phase(complex(12, down)) * 180 / pi}
    return found | {"rho_M": speed**3 / (12 * 9.8), "max_t_y_M": 2 + 15**2 / 19.6}


KINDS = {
    "crank_turned": _crank_turned,
    "slider_at_speed": _slider_at_speed,
    "stone_at_height": _stone,
    "two_cyclists": _two_cyclists,
    "spindle_from_rest": _spindle,
    "spiral_arm": _spiral,
    "jet_on_parabola": _jet,
    "coupler_across_rocker": _coupler_across_rocker,
    "boat_slows": _boat,
    "crank_swings": _crank_swings,
    "radar": _radar,
    "wheel_comes_back": _wheel_comes_back,
    "loads_seen": lambda: {"v_B": 3, "v_B_A": 9, "v_B_A.y": 9, "a_B_A": 2.25},
    "planet_seen": _planet_seen,
    "projectile": _projectile,
    "harmonic_follower": _follower,
    "ladder_in_time": _ladder_in_time,
    "car_and_bend": _car_and_bend,
    "belt_over_four": _belt_over_four,
    "crossed_belt": lambda: {"omega_B": -300 * 15 / 25, "v_rope.O.C": 300 * pi / 30 * 0.15},  # no point moves
    "tackle_of_five": lambda: {"v_B": 1.2 / 5},
    "weston_hoist": lambda: {"v_B": 2 * (15 - 12) / 2, "a_B": 0.4 * (15 - 12) / 2},
    "elevator_two_to_one": lambda: {"v_C": 4 * 0.5 / 2, "v_rope.O.C": 2, "v_rope.O.W": 2, "v_rope.F.C": 0},
    "two_pulleys_three_loads": lambda: {"v_C": 1, "v_B": 2 * 1 + 0.5, "v_B_D": 2.5 + 0.5},
    "geared_winch": lambda: {"v_B": 20 * pi / 30 * 6 / 24 * 10, "omega_drum": 20 * pi / 30 / 4},
    "belt_and_hoist": lambda: {"v_B": 40 * pi / 30 * 20 / 2, "omega_shaft": 40, "v_rope.O.C": 4 * pi * 12},
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
    found = solved_values(path, capsys)
    assert found == pytest.approx(KINDS[name](), rel=1e-5, abs=1e-12)
    assert main(["solve", path, "--explain"]) == 0
    shown = capsys.readouterr()
    assert "\nAnswer: " in shown.out, shown.err
    assert " / 1 " not in shown.out
