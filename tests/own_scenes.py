"""Scenes as an author writes them, with answers by formulas of their own: text, data in SI, expected answers in SI.

In a text ``{OA}`` stands for a datum: written as a number in the scene's unit, or as a parameter of that name.
"""

from __future__ import annotations

from cmath import exp
from collections.abc import Callable
from dataclasses import dataclass
from math import asin, atan2, cos, hypot, radians, sin, sqrt, tan

import numpy as np

FACTORS = {"m": 1.0, "dm": 0.1, "cm": 0.01, "mm": 0.001}


@dataclass(frozen=True)
class OwnScene:
    """A scene: its text, its data (SI, angles in degrees) with what they measure, and its answers (SI, rad)."""

    text: str
    data: dict[str, tuple[float, str]]
    answers: dict[str, float]

    def written(self, unit: str, parameters: bool = False) -> str:
        """The file in a unit of length, with literal numbers or with parameters of one value."""
        head = f'length_unit = "{unit}"\nask = [{", ".join(repr(name) for name in self.answers)}]\n'
        numbers = {name: shown(value, measure, unit) for name, (value, measure) in self.data.items()}
        if not parameters:
            return head + self.text.format(**numbers)
        lines = [
            f'{name} = {{ unit = "{_UNITS[measure].format(unit)}", values = [{numbers[name]}] }}\n'
            for name, (_, measure) in self.data.items()
        ]
        return head + "[parameters]\n" + "".join(lines) + self.text.format(**{name: f'"{name}"' for name in self.data})


_UNITS = {
    "length": "{}",
    "velocity": "{}/s",
    "acceleration": "{}/s^2",
    "angle": "deg",
    "omega": "rad/s",
    "epsilon": "rad/s^2",
}


def shown(value: float, measure: str, unit: str) -> str:
    """A datum as it is written in a scene of that unit."""
    factor = FACTORS[unit] if measure in ("length", "velocity", "acceleration") else 1.0
    return f"{value / factor:.9g}"


def L(value: float) -> tuple[float, str]:  # noqa: N802
    """A length."""
    return value, "length"


def _crank_slider() -> OwnScene:
    r, c, phi, w, e = 0.2, 0.6, radians(35), 3.0, 2.0
    s = asin(r * sin(phi) / c)  # the rod falls towards the slider at this angle
    s1 = r * w * cos(phi) / (c * cos(s))
    x1 = -r * w * sin(phi) - c * s1 * sin(s)
    s2 = (r * (e * cos(phi) - w**2 * sin(phi)) + c * s1**2 * sin(s)) / (c * cos(s))
    x2 = -r * (e * sin(phi) + w**2 * cos(phi)) - c * (s2 * sin(s) + s1**2 * cos(s))
    text = """
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
A = {{ polar = {{ origin = "O", distance = {OA}, angle = {phi} }} }}
B = {{ line_circle = {{ through = "O", centre = "A", distance = {AB}, angle = 0 }} }}
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
guide = {{ point = "B", angle = 0 }}
[[drivers]]
rotation = {{ body = "OA", omega = {w}, epsilon = {e} }}
"""
    data = {"OA": L(r), "AB": L(c), "phi": (35.0, "angle"), "w": (w, "omega"), "e": (e, "epsilon")}
    return OwnScene(text, data, {"v_B.x": x1, "omega_AB": -s1, "a_B.x": x2, "epsilon_AB": -s2, "v_A": r * w})


def _wheel_and_rod() -> OwnScene:
    """The scene of the guide: x = OB cos beta shrinks at v."""
    radius, rod, beta, v, a = 0.2, 0.6, radians(40), 0.3, 0.2
    b1 = v / (rod * sin(beta))
    b2 = (a - rod * b1**2 * cos(beta)) / (rod * sin(beta))
    y1 = rod * b1 * cos(beta)
    y2 = rod * (b2 * cos(beta) - b1**2 * sin(beta))
    text = """
[points]
P = {{ coordinates = {{ x = 0, y = 0 }} }}
O = {{ coordinates = {{ x = 0, y = {R} }} }}
B = {{ polar = {{ origin = "O", distance = {OB}, angle = {beta} }} }}
[bodies]
wheel = ["O", "P"]
OB = ["O", "B"]
[[joints]]
rolling = {{ body = "wheel", centre = "O", contact = "P" }}
[[joints]]
guide = {{ point = "B", angle = 90 }}
[[drivers]]
travel = {{ point = "O", v = {v}, a = {a} }}
"""
    data = {
        "R": L(radius), "OB": L(rod), "beta": (40.0, "angle"), "v": (v, "velocity"), "a": (a, "acceleration"),
    }  # fmt: skip
    answers = {
        "omega_wheel": -v / radius, "v_B.y": y1, "omega_OB": b1, "a_B.y": y2, "epsilon_OB": b2,
        "a_P": v**2 / radius, "epsilon_wheel": -a / radius,
    }  # fmt: skip
    return OwnScene(text, data, answers)


def _four_bar() -> OwnScene:
    """Two circles that cross, then two linear equations: sum of omega_k d_k = 0 round the loop."""
    a, b, c, d, phi, w = 0.15, 0.4, 0.3, 0.45, radians(60), 2.0
    first = a * exp(1j * phi)
    gap = d - first
    along = (abs(gap) ** 2 + b**2 - c**2) / (2 * abs(gap))
    hinge = first + gap / abs(gap) * (along + 1j * sqrt(b**2 - along**2))
    arms = (first, hinge - first, hinge - d)
    rows = np.array([[(1j * arms[1]).real, -(1j * arms[2]).real], [(1j * arms[1]).imag, -(1j * arms[2]).imag]])
    w1, w2 = np.linalg.solve(rows, [(-1j * w * arms[0]).real, (-1j * w * arms[0]).imag])
    right = w**2 * arms[0] + w1**2 * arms[1] - w2**2 * arms[2]
    e1, e2 = np.linalg.solve(rows, [right.real, right.imag])
    text = """
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
C = {{ coordinates = {{ x = {OC}, y = 0 }} }}
A = {{ polar = {{ origin = "O", distance = {OA}, angle = {phi} }} }}
B = {{ circle_circle = {{ first = "A", first_distance = {AB}, second = "C", second_distance = {BC}, side = "left" }} }}
[bodies]
OA = ["O", "A"]
AB = ["A", "B"]
BC = ["B", "C"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
pivot = {{ point = "C" }}
[[drivers]]
rotation = {{ body = "OA", omega = {w} }}
"""
    data = {"OA": L(a), "AB": L(b), "BC": L(c), "OC": L(d), "phi": (60.0, "angle"), "w": (w, "omega")}
    answers = {
        "omega_AB": w1, "omega_BC": w2, "epsilon_AB": e1, "epsilon_BC": e2, "v_B": abs(w2) * c,
        "a_B": hypot(w2**2, e2) * c,
    }  # fmt: skip
    return OwnScene(text, data, answers)


def _ladder() -> OwnScene:
    """A rod of length AB between a wall and a floor: A down the wall, B along the floor."""
    rod, theta, v = 1.25, radians(50), 0.4
    t1 = -v / (rod * cos(theta))  # y_A = l sin theta falls at v
    x1 = -rod * sin(theta) * t1
    t2 = t1**2 * tan(theta)
    x2 = -rod * (cos(theta) * t1**2 + sin(theta) * t2)
    text = """
[points]
B = {{ coordinates = {{ x = 0, y = 0 }} }}
A = {{ polar = {{ origin = "B", distance = {AB}, angle = "180*deg - theta" }} }}
[bodies]
AB = ["A", "B"]
[[joints]]
guide = {{ point = "A", angle = 90 }}
[[joints]]
guide = {{ point = "B", angle = 0 }}
[[drivers]]
travel = {{ point = "A", v = {v}, angle = -90 }}
"""
    text = text.replace('"180*deg - theta"', "130")
    data = {"AB": L(rod), "v": (v, "velocity")}
    return OwnScene(text, data, {"omega_AB": -t1, "v_B.x": x1, "a_B.x": x2, "epsilon_AB": -t2})


def _gear_pair() -> OwnScene:
    first, second, w, e = 0.12, 0.3, 5.0, 4.0
    text = """
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
C = {{ coordinates = {{ x = {OC}, y = 0 }} }}
M = {{ polar = {{ origin = "C", distance = {CM}, angle = 30 }} }}
N = {{ polar = {{ origin = "O", distance = 0.04, angle = 80 }} }}
[bodies]
gear1 = ["O", "N"]
gear2 = ["C", "M"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
pivot = {{ point = "C" }}
[[joints]]
gears = {{ body = "gear1", centre = "O", radius = {r}, other_centre = "C", other = "gear2" }}
[[drivers]]
rotation = {{ body = "gear1", omega = {w}, epsilon = {e} }}
""".replace("0.04", "{ON}")
    data = {
        "OC": L(first + second), "CM": L(0.2), "ON": L(0.04), "r": L(first), "w": (w, "omega"), "e": (e, "epsilon"),
    }  # fmt: skip
    w2, e2 = -w * first / second, -e * first / second
    return OwnScene(
        text, data, {"omega_gear2": w2, "epsilon_gear2": e2, "v_M": 0.2 * abs(w2), "a_M": 0.2 * hypot(w2**2, e2)}
    )


def _planet() -> OwnScene:
    """A carrier leads a gear round a fixed one: Omega (1 + R/r), no acceleration but the centripetal ones."""
    fixed, planet, w = 0.25, 0.1, 2.0
    text = """
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
A = {{ polar = {{ origin = "O", distance = {OA}, angle = 55 }} }}
M = {{ polar = {{ origin = "A", distance = {r}, angle = 145 }} }}
[bodies]
OA = ["O", "A"]
gear = ["A", "M"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
gears = {{ body = "gear", centre = "A", radius = {r}, other_centre = "O" }}
[[drivers]]
rotation = {{ body = "OA", omega = {w} }}
"""
    data = {"OA": L(fixed + planet), "r": L(planet), "w": (w, "omega")}
    turn = w * (fixed + planet) / planet
    arm = fixed + planet
    # M is at a quarter turn from the line of centres.
    return OwnScene(
        text,
        data,
        {
            "omega_gear": turn,
            "v_A": w * arm,
            "v_M": hypot(w * arm, turn * planet),
            "a_M": hypot(w**2 * arm, turn**2 * planet),
        },
    )


def _inner_roller() -> OwnScene:
    """A roller in a fixed ring: v_O = omega r, a_n = v_O^2 / (R - r)."""
    gap, r, w, e = 0.35, 0.15, 4.0, 3.0
    text = """
[points]
C = {{ coordinates = {{ x = 0, y = 0 }} }}
O = {{ polar = {{ origin = "C", distance = {CO}, angle = -60 }} }}
M = {{ polar = {{ origin = "O", distance = {r}, angle = 120 }} }}
[bodies]
roller = ["O", "M"]
[[joints]]
rolling_on_circle = {{ body = "roller", centre = "O", radius = {r}, around = "C", inside = true }}
[[drivers]]
rotation = {{ body = "roller", omega = {w}, epsilon = {e} }}
"""
    data = {"CO": L(gap), "r": L(r), "w": (w, "omega"), "e": (e, "epsilon")}
    v = w * r
    # M lies towards the centre of the ring: a_M along the line of centres v^2/gap - w^2 r seen from O.
    return OwnScene(
        text,
        data,
        {"v_O": v, "v_M": 2 * v, "a_O": hypot(e * r, v**2 / gap), "a_M": hypot(2 * e * r, v**2 / gap - w**2 * r)},
    )


def _rocker() -> OwnScene:
    """A crank turns a slotted rocker: z_A = d + r e^(i phi), psi = arg z_A."""
    r, d, phi, w = 0.2, 0.5, radians(70), 3.0
    z, v = 1j * d + r * exp(1j * phi), 1j * w * r * exp(1j * phi)
    a = -(w**2) * r * exp(1j * phi)
    psi, rho = atan2(z.imag, z.real), abs(z)
    slip, turn = (v * exp(-1j * psi)).real, (v * exp(-1j * psi)).imag / rho
    e = ((a * exp(-1j * psi)).imag - 2 * slip * turn) / rho
    text = """
[points]
C = {{ coordinates = {{ x = 0, y = 0 }} }}
O = {{ coordinates = {{ x = 0, y = {CO} }} }}
A = {{ polar = {{ origin = "O", distance = {OA}, angle = {phi} }} }}
D = {{ polar = {{ origin = "C", distance = {CD}, towards = "A" }} }}
[bodies]
OA = ["O", "A"]
CD = ["C", "D"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
pivot = {{ point = "C" }}
[[joints]]
slot = {{ point = "A", body = "CD", along = ["C", "D"] }}
[[drivers]]
rotation = {{ body = "OA", omega = {w} }}
"""
    data = {"OA": L(r), "CO": L(d), "CD": L(0.9), "phi": (70.0, "angle"), "w": (w, "omega")}
    return OwnScene(
        text,
        data,
        {
            "omega_CD": turn,
            "epsilon_CD": e,
            "v_rel_A": abs(slip),
            "a_cor_A": 2 * abs(turn * slip),
            "v_D": 0.9 * abs(turn),
        },
    )


def _cylinder() -> OwnScene:
    """A cylinder AB lifts a boom OB: c^2 = a^2 + b^2 - 2 a b cos theta, differentiated twice."""
    a, b, theta, v, g = 0.8, 1.2, radians(65), 0.15, 0.05
    c = sqrt(a**2 + b**2 - 2 * a * b * cos(theta))
    t1 = c * v / (a * b * sin(theta))
    t2 = (v**2 + c * g - a * b * cos(theta) * t1**2) / (a * b * sin(theta))
    text = """
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
A = {{ coordinates = {{ x = {OA}, y = 0 }} }}
B = {{ polar = {{ origin = "O", distance = {OB}, angle = {theta} }} }}
[bodies]
OB = ["O", "B"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
pivot = {{ point = "A" }}
[[drivers]]
extension = {{ start = "A", end = "B", v = {v}, a = {g} }}
"""
    data = {
        "OA": L(a), "OB": L(b), "theta": (65.0, "angle"), "v": (v, "velocity"), "g": (g, "acceleration"),
    }  # fmt: skip
    return OwnScene(text, data, {"omega_OB": t1, "epsilon_OB": t2, "v_B": b * t1, "a_B": b * hypot(t1**2, t2)})


def _spool() -> OwnScene:
    """A spool rolls, its thread is pulled off below: the end moves with omega (R - r)."""
    big, small, v, a = 0.3, 0.1, 0.4, 0.25
    text = """
[points]
P = {{ coordinates = {{ x = 0, y = 0 }} }}
O = {{ coordinates = {{ x = 0, y = {R} }} }}
T = {{ coordinates = {{ x = {far}, y = {low} }} }}
[bodies]
spool = ["O", "P"]
[[joints]]
rolling = {{ body = "spool", centre = "O", contact = "P" }}
[[joints]]
guide = {{ point = "T", angle = 0 }}
[[joints]]
rope.path = [{{ point = "O", radius = {r}, side = "right", body = "spool" }}, {{ point = "T" }}]
[[drivers]]
travel = {{ point = "T", v = {v}, a = {a}, angle = 0 }}
"""
    data = {
        "R": L(big), "r": L(small), "low": L(big - small), "far": L(1.5),
        "v": (v, "velocity"), "a": (a, "acceleration"),
    }  # fmt: skip
    w, e = v / (big - small), a / (big - small)
    return OwnScene(
        text, data, {"omega_spool": -w, "v_O": w * big, "epsilon_spool": -e, "a_O": e * big, "a_P": w**2 * big}
    )


def _movable_pulley() -> OwnScene:
    """One end of the rope is fixed, the other is pulled up: the pulley goes up at half the speed."""
    r, v, a = 0.2, 0.6, 0.3
    text = """
[points]
C = {{ coordinates = {{ x = 0, y = 0 }} }}
K = {{ coordinates = {{ x = {left}, y = {high} }} }}
T = {{ coordinates = {{ x = {r}, y = {high} }} }}
M = {{ coordinates = {{ x = 0, y = {r} }} }}
[bodies]
pulley = ["C", "M"]
[[joints]]
guide = {{ point = "C", angle = 90 }}
[[joints]]
guide = {{ point = "T", angle = 90 }}
[[joints]]
rope.path = [{{ point = "K", fixed = true }}, {{ point = "C", radius = {r}, side = "right", body = "pulley" }}]
[[joints]]
rope.path = [{{ point = "C", radius = {r}, side = "right", body = "pulley" }}, {{ point = "T" }}]
[[drivers]]
travel = {{ point = "T", v = {v}, a = {a}, angle = 90 }}
""".replace('side = "right", body = "pulley" }}, {{ point = "T"', 'side = "right", body = "pulley" }}, {{ point = "T"')
    data = {"r": L(r), "left": L(-r), "high": L(0.9), "v": (v, "velocity"), "a": (a, "acceleration")}
    w, e = v / (2 * r), a / (2 * r)
    return OwnScene(
        text, data, {"v_C": v / 2, "omega_pulley": w, "a_C": a / 2, "epsilon_pulley": e, "v_M": hypot(v / 2, w * r)}
    )


def _slider_on_rod() -> OwnScene:
    """A ring slides out on a turning rod: v = i omega z + u, a = (i epsilon - omega^2) z + 2 i omega u + u'."""
    s, w, e, u, du = 0.5, 2.0, 1.5, 0.3, 0.2
    v, a = complex(u, w * s), complex(du - w**2 * s, e * s + 2 * w * u)
    text = """
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
B = {{ polar = {{ origin = "O", distance = {OB}, angle = {phi} }} }}
M = {{ polar = {{ origin = "O", distance = {OM}, angle = {phi} }} }}
[bodies]
OB = ["O", "B"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
slot = {{ point = "M", body = "OB", along = ["O", "B"] }}
[[drivers]]
rotation = {{ body = "OB", omega = {w}, epsilon = {e} }}
[[drivers]]
relative_travel = {{ point = "M", body = "OB", along = ["O", "B"], v = {u}, a = {du} }}
"""
    data = {
        "OB": L(0.8), "OM": L(s), "phi": (25.0, "angle"), "w": (w, "omega"), "e": (e, "epsilon"),
        "u": (u, "velocity"), "du": (du, "acceleration"),
    }  # fmt: skip
    return OwnScene(text, data, {"v_M": abs(v), "a_M": abs(a), "a_cor_M": 2 * w * u, "v_rel_M": u})


def _bead_on_disc() -> OwnScene:
    """A bead runs round a circle of a turning disc, both about the same axle: the rates add."""
    r, w, u = 0.4, 1.5, 0.5
    text = """
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
N = {{ coordinates = {{ x = {ON}, y = 0 }} }}
M = {{ polar = {{ origin = "O", distance = {r}, angle = 100 }} }}
[bodies]
disc = ["O", "N"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
arc_slot = {{ point = "M", centre = "O", body = "disc" }}
[[drivers]]
rotation = {{ body = "disc", omega = {w} }}
[[drivers]]
circling = {{ point = "M", body = "disc", centre = "O", v = {u} }}
"""
    data = {"r": L(r), "ON": L(0.6), "w": (w, "omega"), "u": (u, "velocity")}
    return OwnScene(text, data, {"v_M": w * r + u, "a_M": (w * r + u) ** 2 / r, "a_cor_M": 2 * w * u})


def _plate() -> OwnScene:
    """The velocity of A and the line of B's are given: equal projections, then omega; no accelerations."""
    length, v, angle = 0.7, 0.5, radians(30)
    # AB is horizontal, B moves along 60 degrees.
    vb = v * cos(angle) / cos(radians(60))
    w = (vb * sin(radians(60)) - v * sin(angle)) / length
    text = """
[points]
A = {{ coordinates = {{ x = 0, y = 0 }} }}
B = {{ coordinates = {{ x = {AB}, y = 0 }} }}
C = {{ polar = {{ origin = "A", distance = {AC}, angle = 40 }} }}
[bodies]
plate = ["A", "B", "C"]
[[joints]]
guide = {{ point = "B", angle = 60 }}
[[drivers]]
vector_motion = {{ point = "A", v = {v}, angle = {alpha} }}
"""
    data = {"AB": L(length), "AC": L(0.4), "v": (v, "velocity"), "alpha": (30.0, "angle")}
    vc = v * exp(1j * angle) + 1j * w * 0.4 * exp(1j * radians(40))
    return OwnScene(text, data, {"omega_plate": w, "v_B": vb, "v_C": abs(vc)})


def _rack_and_pinion() -> OwnScene:
    """A pinion between two racks: the mean and half the difference of their speeds."""
    r, low, up = 0.15, 0.2, 0.8
    text = """
[points]
K = {{ coordinates = {{ x = 0, y = 0 }} }}
O = {{ coordinates = {{ x = 0, y = {r} }} }}
N = {{ coordinates = {{ x = 0, y = {d} }} }}
A = {{ coordinates = {{ x = {far}, y = 0 }} }}
B = {{ coordinates = {{ x = {far}, y = {d} }} }}
E = {{ coordinates = {{ x = {near}, y = 0 }} }}
F = {{ coordinates = {{ x = {near}, y = {d} }} }}
[bodies]
pinion = ["O", "K", "N"]
low = ["A", "E"]
up = ["B", "F"]
[[joints]]
guide = {{ point = "A", angle = 0 }}
[[joints]]
translation = {{ body = "low" }}
[[joints]]
guide = {{ point = "B", angle = 0 }}
[[joints]]
translation = {{ body = "up" }}
[[joints]]
rolling = {{ body = "pinion", centre = "O", contact = "K", on = "low", on_point = "A" }}
[[joints]]
rolling = {{ body = "pinion", centre = "O", contact = "N", on = "up", on_point = "B", axle_held = true }}
[[drivers]]
travel = {{ point = "A", v = {v}, angle = 0 }}
[[drivers]]
travel = {{ point = "B", v = {u}, angle = 0 }}
"""
    data = {
        "r": L(r), "d": L(2 * r), "far": L(0.5), "near": L(-0.5), "v": (low, "velocity"), "u": (up, "velocity"),
    }  # fmt: skip
    return OwnScene(text, data, {"v_O": (low + up) / 2, "omega_pinion": -(up - low) / (2 * r)})


def _scotch_yoke() -> OwnScene:
    """A crank pin in the upright slot of a yoke: x = r cos phi."""
    r, phi, w, e = 0.25, radians(40), 2.5, 1.0
    text = """
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
A = {{ polar = {{ origin = "O", distance = {OA}, angle = {phi} }} }}
S = {{ coordinates = {{ x = {x}, y = {low} }} }}
T = {{ coordinates = {{ x = {x}, y = {high} }} }}
[bodies]
OA = ["O", "A"]
yoke = ["S", "T"]
[[joints]]
pivot = {{ point = "O" }}
[[joints]]
guide = {{ point = "S", angle = 0 }}
[[joints]]
translation = {{ body = "yoke" }}
[[joints]]
slot = {{ point = "A", body = "yoke", along = ["S", "T"] }}
[[drivers]]
rotation = {{ body = "OA", omega = {w}, epsilon = {e} }}
"""
    data = {
        "OA": L(r), "phi": (40.0, "angle"), "x": L(r * cos(phi)), "low": L(-0.4), "high": L(0.4),
        "w": (w, "omega"), "e": (e, "epsilon"),
    }  # fmt: skip
    return OwnScene(
        text,
        data,
        {"v_S.x": -r * w * sin(phi), "a_S.x": -r * (e * sin(phi) + w**2 * cos(phi)), "v_rel_A": r * w * cos(phi)},
    )


def _arc_guide() -> OwnScene:
    """A rod AB, A on the floor at speed v, B on an arc about C: B's velocity is across CB."""
    v, rod, radius = 0.3, 0.5, 0.4
    b, c = rod * exp(1j * radians(50)), rod * exp(1j * radians(50)) - radius * exp(1j * radians(100))
    way = 1j * (b - c)
    # v + i w (b) = s way: two real equations.
    w, s = np.linalg.solve([[(1j * b).real, -way.real], [(1j * b).imag, -way.imag]], [-v, 0.0])
    right = w**2 * b - s**2 * (b - c)
    e, g = np.linalg.solve([[(1j * b).real, -way.real], [(1j * b).imag, -way.imag]], [right.real, right.imag])
    text = """
[points]
A = {{ coordinates = {{ x = 0, y = 0 }} }}
B = {{ polar = {{ origin = "A", distance = {AB}, angle = 50 }} }}
C = {{ polar = {{ origin = "B", distance = {BC}, angle = -80 }} }}
[bodies]
AB = ["A", "B"]
[[joints]]
arc_slot = {{ point = "B", centre = "C" }}
[[drivers]]
vector_motion = {{ point = "A", v = {v}, angle = 0 }}
"""
    data = {"AB": L(rod), "BC": L(radius), "v": (v, "velocity")}
    return OwnScene(
        text, data, {"omega_AB": w, "v_B": abs(s) * radius, "epsilon_AB": e, "a_B": radius * hypot(s**2, g)}
    )


def _expressions() -> OwnScene:
    """Lengths by formulas, with units and without: a crank of 2 OK and a point at 0.5 of it."""
    half, w, e = 0.11, 3.0, 1.2
    text = """
[points]
O = {{ coordinates = {{ x = 0, y = 0 }} }}
K = {{ polar = {{ origin = "O", distance = {OK}, angle = {phi} }} }}
A = {{ polar = {{ origin = "O", distance = "0.22 * m", angle = {phi} }} }}
B = {{ polar = {{ origin = "A", distance = "2 * (5 * cm + 30 * mm)", angle = "pi / 2 + 20 * deg" }} }}
[bodies]
plate = ["O", "K", "A", "B"]
[[joints]]
pivot = {{ point = "O" }}
[[drivers]]
rotation = {{ body = "plate", omega = {w}, epsilon = {e} }}
"""
    data = {"OK": L(half), "phi": (20.0, "angle"), "w": (w, "omega"), "e": (e, "epsilon")}
    # B stands at a right angle on OA: 0.22 along, 0.16 across.
    return OwnScene(
        text, data, {"v_K": half * w, "v_B": w * hypot(0.22, 0.16), "a_B": hypot(0.22, 0.16) * hypot(w**2, e)}
    )


SCENES: dict[str, Callable[[], OwnScene]] = {
    "crank and slider": _crank_slider,
    "wheel and rod": _wheel_and_rod,
    "four bar": _four_bar,
    "ladder": _ladder,
    "gear pair": _gear_pair,
    "planet": _planet,
    "roller in a ring": _inner_roller,
    "slotted rocker": _rocker,
    "cylinder": _cylinder,
    "spool": _spool,
    "movable pulley": _movable_pulley,
    "ring on a rod": _slider_on_rod,
    "bead on a disc": _bead_on_disc,
    "plate": _plate,
    "rack and pinion": _rack_and_pinion,
    "scotch yoke": _scotch_yoke,
    "arc guide": _arc_guide,
    "formulas": _expressions,
}
