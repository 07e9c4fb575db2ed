"""Joints and drivers against formulas that are not the program's: closed forms differentiated with mpmath."""

from __future__ import annotations

import math
from collections.abc import Callable

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.joint_scenes import (
    SCENES,
    arc_yoke,
    bead_on_rod,
    crossed_belt,
    disc_on_circle,
    epicyclic,
    hydraulic_boom,
    plate,
    point_in_groove,
    pulleys,
    wheel_between_racks,
)
from variantgen.families.quantities import parse_quantity, quantity_names
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.drivers.travel import Travel
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.rope import Bend, Rope
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.verification.verify import invariants, recompute

RATES = st.floats(-5, 5).filter(lambda x: abs(x) > 0.01)


def rates(position: Callable[[mpmath.mpf], mpmath.mpc]) -> tuple[complex, complex]:
    """First and second derivative of a motion at t = 0, with 40 digits."""
    with mpmath.workdps(40):
        return complex(mpmath.diff(position, 0, 1)), complex(mpmath.diff(position, 0, 2))


def agree(motion_value: np.ndarray, expected: complex) -> None:
    assert motion_value[0] == pytest.approx(expected, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("frame", [Frame(), Frame(1j, -1.0), Frame(-1.0, 1.0)])
def test_solver_and_independent_computation_agree(name: str, frame: Frame) -> None:
    scene = SCENES[name]
    motion = solve(Scene(scene.points, scene.bodies, scene.joints, scene.drivers, frame, conditions=scene.conditions))
    assert motion.solved.all()
    again = recompute(motion)
    assert again.velocity_error.max() < 1e-10
    assert again.acceleration_error.max() < 1e-8
    assert invariants(motion).max() < 1e-13


@given(RATES, RATES, RATES, RATES)
def test_wheel_between_racks(v: float, w: float, a: float, b: float) -> None:
    motion = solve(wheel_between_racks(0.3, v, a, w, b))
    agree(motion.omega["wheel"], (v - w) / 0.6)
    agree(motion.v["O"], (v + w) / 2)
    agree(motion.a["O"], (a + b) / 2)
    # The points of the wheel at the racks have the accelerations of the racks along them.
    assert motion.a["K"].real == pytest.approx(a)
    assert motion.a["L"].real == pytest.approx(b)


@given(RATES, RATES, st.booleans(), st.floats(0.05, 0.3))
def test_disc_on_a_fixed_circle(omega: float, epsilon: float, inside: bool, radius: float) -> None:
    distance = 0.7
    motion = solve(disc_on_circle(distance, radius, omega, epsilon, inside))
    k = (-radius if inside else radius) / distance

    def centre(t: mpmath.mpf) -> mpmath.mpc:
        return distance * mpmath.expj(-1 + k * (omega * t + epsilon * t**2 / 2))

    v, a = rates(centre)
    agree(motion.v["O"], v)
    agree(motion.a["O"], a)


@given(RATES, RATES, RATES, RATES)
def test_disc_on_a_turning_drum(omega: float, epsilon: float, drum: float, drum_epsilon: float) -> None:
    # Equal ways of the rims past the line of centres, which turns at W: r (omega - W) = -R (Omega - W).
    small, large = 0.3, 0.4
    motion = solve(disc_on_circle(small + large, small, omega, epsilon, False, (drum, drum_epsilon)))
    line = (small * omega + large * drum) / (small + large)
    slope = (small * epsilon + large * drum_epsilon) / (small + large)
    d = 0.7 * np.exp(-1j)
    agree(motion.v["O"], 1j * line * d)
    agree(motion.a["O"], (1j * slope - line**2) * d)


@given(RATES, RATES, st.floats(0.02, 0.09))
def test_epicyclic_train_by_willis(omega: float, epsilon: float, planet: float) -> None:
    arm = 0.2
    motion = solve(epicyclic(arm, planet, omega, epsilon))
    ring, sun = arm + planet, arm - planet
    agree(motion.omega["sun"], omega * (1 + ring / sun))
    agree(motion.epsilon["sun"], epsilon * (1 + ring / sun))
    agree(motion.omega["planet"], omega * (1 - ring / planet))


@given(RATES, RATES, st.floats(0.2, 2.9))
def test_yoke_with_a_circular_slot(omega: float, epsilon: float, phi: float) -> None:
    crank, radius = 0.2, 0.6
    motion = solve(arc_yoke(crank, radius, phi, omega, epsilon))

    def yoke(t: mpmath.mpf) -> mpmath.mpf:
        angle = phi + omega * t + epsilon * t**2 / 2
        return crank * mpmath.cos(angle) - mpmath.sqrt(radius**2 - (crank * mpmath.sin(angle)) ** 2)

    v, a = rates(yoke)
    agree(motion.v["E"], v)
    agree(motion.a["E"], a)


@given(RATES, RATES, RATES, RATES)
def test_point_in_a_groove_of_a_disc(omega: float, epsilon: float, u: float, w: float) -> None:
    motion = solve(point_in_groove(omega, epsilon, u, w))

    def point(t: mpmath.mpf) -> mpmath.mpc:
        turned = mpmath.expj(omega * t + epsilon * t**2 / 2)
        return turned * (mpmath.mpf(0.3) + mpmath.mpf(0.2) * mpmath.expj(1.2 + (u * t + w * t**2 / 2) / 0.2))

    v, a = rates(point)
    agree(motion.v["M"], v)
    agree(motion.a["M"], a)


@given(RATES, RATES, RATES, RATES, st.floats(-0.5, 0.5))
def test_bead_on_a_turning_line(omega: float, epsilon: float, u: float, w: float, offset: float) -> None:
    motion = solve(bead_on_rod(0.6, offset, omega, epsilon, u, w))

    def point(t: mpmath.mpf) -> mpmath.mpc:
        turned = mpmath.expj(mpmath.mpf(0.7) + omega * t + epsilon * t**2 / 2)
        return turned * (mpmath.mpc(0.6, offset) + u * t + w * t**2 / 2)

    v, a = rates(point)
    agree(motion.v["M"], v)
    agree(motion.a["M"], a)


@given(RATES, RATES)
def test_boom_by_the_law_of_cosines(u: float, w: float) -> None:
    boom, base, length = 1.0, 0.7, 0.9
    motion = solve(hydraulic_boom(boom, base, length, u, w))

    def angle(t: mpmath.mpf) -> mpmath.mpf:
        s = length + u * t + w * t**2 / 2
        return mpmath.acos((mpmath.mpf(boom) ** 2 + mpmath.mpf(base) ** 2 - s**2) / (2 * boom * base))

    omega, epsilon = rates(angle)
    # B lies to the left of the way O -> F (side = left), so the boom turns counter-clockwise as the cylinder grows.
    agree(motion.omega["OB"], omega.real)
    agree(motion.epsilon["OB"], epsilon.real)


@given(RATES, RATES)
def test_triangle_with_given_pole(omega: float, epsilon: float) -> None:
    v, a = 0.3 + 0.1j, 2.0 - 1.0j
    motion = solve(plate(omega, epsilon, v, a))
    for name, z in (("B", 1.0), ("D", 0.5 + 0.8j)):
        agree(motion.v[name], v + 1j * omega * z)
        agree(motion.a[name], a + (1j * epsilon - omega**2) * z)


@given(RATES, RATES, RATES, RATES)
def test_pulley_hanging_in_a_rope(v_a: float, v_b: float, a_a: float, a_b: float) -> None:
    # The guide, example 29: the hanging sides move up with the speeds of the loads, the pulley by their mean.
    motion = solve(pulleys(v_a, v_b, a_a, a_b))
    agree(motion.v["C"], 1j * (v_a + v_b) / 2)
    agree(motion.omega["pulley"], (v_b - v_a) / 0.2)
    agree(motion.a["C"], 1j * (a_a + a_b) / 2)
    agree(motion.epsilon["pulley"], (a_b - a_a) / 0.2)


def test_belt_with_fixed_axes_gives_the_ratio_of_the_radii() -> None:
    motion = solve(crossed_belt((0.0, 0.0), (3.0, 2.0)))
    agree(motion.omega["second"], -3.0 * 0.12 / 0.2)
    agree(motion.epsilon["second"], -2.0 * 0.12 / 0.2)


def test_rope_over_a_free_pulley_halves_the_speed() -> None:
    # Both pieces at the pulley are vertical, so it rises by half of what the rope is hauled in.
    scene = Scene(
        {
            "A": Coordinates(-0.3, 0.2),
            "K": Coordinates(-0.2, 1.0),
            "L": Coordinates(0.0, 0.0),
            "F": Coordinates(0.1, 1.0),
        },
        {},
        (
            Guide("A", math.pi / 2),
            Guide("L", math.pi / 2),
            Rope((Bend("A"), Bend("K", 0.1, 1.0, fixed=True), Bend("L", 0.1, -1.0), Bend("F", fixed=True))),
        ),
        (Travel("A", -2.0, -3.0, math.pi / 2),),
    )
    motion = solve(scene)
    agree(motion.v["L"], 1.0j)
    agree(motion.a["L"], 1.5j)


def test_quantities_of_every_scene_have_values() -> None:
    for scene in SCENES.values():
        motion = solve(scene)
        for name in quantity_names(scene):
            value = parse_quantity(name, scene).value(motion)
            assert value.shape == (1,)
            assert not np.isnan(value).any(), name


def test_a_slot_beside_the_line_of_its_points() -> None:
    """A bar AB leans on a fixed disc (r = 0.05 m): its end A runs along the floor, x_A = r / sin(alpha)."""
    radius, alpha, speed = 0.05, math.pi / 6, -2.0
    end = radius / math.sin(alpha)
    far = end - 0.2 * math.cos(alpha) + 0.2j * math.sin(alpha)
    joints = (Pivot("O"), Guide("A"), Slot("O", "AB", ("A", "B")))
    placed = {"O": 0j, "A": complex(end), "B": far}
    points = {name: Coordinates(z.real, z.imag) for name, z in placed.items()}
    motion = solve(Scene(points, {"AB": ("A", "B")}, joints, (Travel("A", speed, 0.0),)))
    # x_A' = -r cos alpha / sin^2 alpha * alpha'; the inclination alpha counts clockwise.
    rate = -speed * math.sin(alpha) ** 2 / (radius * math.cos(alpha))
    agree(motion.omega["AB"], -rate)
    agree(motion.epsilon["AB"], -(rate**2) * (2 / math.tan(alpha) + math.tan(alpha)))
