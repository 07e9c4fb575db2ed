"""The way of a mechanism against closed forms written here."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.solving.structure import analyse
from variantgen.mechanism.turn.sweep import Sweep, SweepEnd, sweep
from variantgen.testing.linkages import four_bar, slider_crank, wheel


def swept(scene: Scene, **options: Any) -> Sweep:
    return sweep(solve(scene), analyse(scene), **options)


def test_slider_crank_over_a_turn() -> None:
    a, b, e, phi0, omega, epsilon = 0.2, 0.6, 0.05, 0.7, 3.0, -2.0
    found = swept(slider_crank(a, b, e, phi0, omega, epsilon), before=phi0)
    phi = phi0 + found.way
    assert phi[0] == pytest.approx(0.0, abs=1e-15)
    assert phi[-1] == pytest.approx(2 * math.pi)
    root = np.sqrt(b**2 - (a * np.sin(phi) - e) ** 2)
    x = a * np.cos(phi) + root
    slope = -a * np.sin(phi) - (a * np.sin(phi) - e) * a * np.cos(phi) / root
    # Second derivative: of -g g'/root with g = a sin(phi) - e.
    g, g1, g2 = a * np.sin(phi) - e, a * np.cos(phi), -a * np.sin(phi)
    bend = -a * np.cos(phi) - (g1**2 + g * g2) / root - (g * g1) ** 2 / root**3
    motion = found.motion
    assert np.max(np.abs(motion.z["B"] - (x + 1j * e))) < 1e-12
    assert np.max(np.abs(motion.v["B"] - slope * omega)) < 1e-11
    assert np.max(np.abs(motion.a["B"] - (slope * epsilon + bend * omega**2))) < 1e-10
    assert found.closed
    assert found.ends == (SweepEnd.TURN, SweepEnd.TURN)


def test_crank_rocker_by_circles_that_meet() -> None:
    a, b, c, d, phi0, omega = 0.2, 0.5, 0.4, 0.6, 1.1, 2.0
    found = swept(four_bar(a, b, c, d, phi0, omega, 1.5))
    assert found.closed
    assert found.way[-1] - found.way[0] == pytest.approx(2 * math.pi)
    crank = a * np.exp(1j * (phi0 + found.way))
    # Triangle A, B, C by the cosine theorem; B on the left of A -> C as it is drawn.
    diagonal = d - crank
    length = np.abs(diagonal)
    cosine = (b**2 + length**2 - c**2) / (2 * b * length)
    place = crank + b * diagonal / length * (cosine + 1j * np.sqrt(1 - cosine**2))
    motion = found.motion
    assert np.max(np.abs(motion.z["B"] - place)) < 1e-12
    # omega of the rocker: both ends of the coupler have equal velocities along it.
    rod, rocker = place - crank, place - d
    along_rod = np.real(np.conj(rod) * 1j * omega * crank)
    expected = along_rod / np.real(np.conj(rod) * 1j * rocker)
    assert np.max(np.abs(motion.omega["BC"] - expected)) < 1e-11


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_double_rocker_ends_at_its_dead_points(side: float) -> None:
    a, b, c, d = 0.5, 0.3, 0.4, 0.7  # a + d > b + c: the longest diagonal is b + c
    found = swept(four_bar(a, b, c, d, 0.5, 2.0, side=side))
    limit = math.acos((a**2 + d**2 - (b + c) ** 2) / (2 * a * d))
    assert found.ends == (SweepEnd.DEAD_POINT, SweepEnd.DEAD_POINT)
    assert 0.5 + found.way[-1] == pytest.approx(limit, abs=3e-7)
    assert 0.5 + found.way[0] == pytest.approx(-limit, abs=3e-7)
    # The diagonal is straight at the ends, and B never changes its side of A -> C before.
    z = found.motion.z
    sides = np.imag(np.conj(0.7 - z["A"]) * (z["B"] - z["A"]))
    assert np.all(side * sides[1:-1] > 0)
    assert abs(sides[0]) + abs(sides[-1]) < 1e-3


def test_a_rolling_wheel_draws_cycloids() -> None:
    radius, v, a = 0.4, -1.5, 0.8
    found = swept(wheel(radius, v, a))
    way = -found.way  # the given motion is to the left
    assert found.ends == (SweepEnd.LENGTH, SweepEnd.LENGTH)
    assert found.way[-1] == pytest.approx(math.pi * radius, rel=1e-6)
    turn = np.exp(-1j * way / radius)
    centre = way + 1j * radius
    assert np.max(np.abs(found.motion.z["A"] - (centre - radius * turn))) < 1e-12
    assert np.max(np.abs(found.turned["wheel"] + way / radius)) < 1e-12
    expected = v - 1j * (v / radius) * (-radius * turn)
    assert np.max(np.abs(found.motion.v["A"] - expected)) < 1e-11
    # The name of the contact stays with the contact.
    assert np.max(np.abs(found.motion.z["P"] - way)) < 1e-12


def test_the_instant_is_the_solved_motion() -> None:
    scene = four_bar(0.3, 0.5, 0.4, 0.6, 1.0, -2.0, 3.0)
    motion, found = solve(scene), swept(scene, before=1.0)
    assert found.way[found.instant] == 0.0
    for table, again in ((motion.z, found.motion.z), (motion.v, found.motion.v), (motion.a, found.motion.a)):
        for name, values in table.items():
            assert again[name][found.instant] == pytest.approx(values[0], rel=1e-12, abs=1e-15)


def test_a_parallelogram_goes_straight_through_its_change_points() -> None:
    found = swept(four_bar(0.3, 0.8, 0.3, 0.8, 1.0, 2.0, side=1.0), before=1.0)
    assert found.closed
    z = found.motion.z
    assert np.max(np.abs(z["B"] - z["A"] - 0.8)) < 1e-9
    # There the crank does not determine the rocker.
    assert not np.all(found.clear)
    assert np.all(np.abs(found.motion.omega["BC"][found.clear] - 2.0) < 1e-6)


def test_a_point_stays_between_the_ends_of_its_rod() -> None:
    scene = Scene(
        {
            "O": Coordinates(0.0, 0.0),
            "C": Coordinates(0.5, 0.0),
            "A": Polar("O", 0.2, 1.2),
            "B": Polar("C", 0.6, towards="A"),
        },
        {"OA": ("O", "A"), "CB": ("C", "B")},
        (Pivot("O"), Pivot("C"), Slot("A", "CB", ("C", "B"))),
        (Rotation("OA", 1.0),),
    )
    free, held = swept(scene), swept(scene, limits=[("A", "B", "C")])
    assert free.closed
    assert held.ends == (SweepEnd.JOINT, SweepEnd.JOINT)
    # Where the distance from C is 0.6: 0.25 + 0.04 - 0.2 cos(phi) = 0.36.
    limit = math.acos((0.29 - 0.36) / 0.2)
    assert 1.2 + held.way[-1] == pytest.approx(limit, abs=1e-6)
    assert 1.2 + held.way[0] == pytest.approx(-limit, abs=1e-6)


def test_from_rest_the_accelerations_lead() -> None:
    found = swept(slider_crank(0.2, 0.6, 0.0, 0.7, 0.0, 2.0))
    assert found.closed
    assert np.max(np.abs(found.motion.v["B"])) == 0.0


def test_more_samples_are_the_same_curve() -> None:
    scene = four_bar(0.2, 0.5, 0.4, 0.6, 1.1, 2.0)
    coarse, fine = swept(scene, samples=91), swept(scene, samples=361)
    assert np.max(np.abs(coarse.motion.z["B"] - fine.motion.z["B"][::4])) < 1e-12


def test_nothing_to_sweep() -> None:
    with pytest.raises(ValueError, match="no driver moves"):
        swept(slider_crank(0.2, 0.6, 0.0, 0.7, 0.0, 0.0))
    with pytest.raises(ValueError, match="one solved variant"):
        swept(slider_crank(0.2, 0.1, 0.0, 1.5, 1.0))
