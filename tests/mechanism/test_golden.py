"""Worked systems of the sources, solved from scenes written out here; exact values as the sources' data give them.

K = Kirsanov, section 2.5; M = the guide to kinematics. Expected numbers were computed independently of the program
(hand calculation or an 80-digit linear solution of the constraint equations).
"""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest

from variantgen.mechanism.centres import acceleration_centre, velocity_centre
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.relative import relative_motion
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.testing.linkages import four_bar, sleeve_on_crank, slider_crank, spool, wheel


def by_coordinates(points: dict[str, complex], omega: float, epsilon: float) -> Scene:
    """A four-bar O A B C by the coordinates of its hinges."""
    return Scene(
        {name: Coordinates(z.real, z.imag) for name, z in points.items()},
        {"OA": ("O", "A"), "AB": ("A", "B"), "BC": ("C", "B")},
        (Pivot("O"), Pivot("C")),
        (Rotation("OA", omega, epsilon),),
    )


def test_k26_three_angular_velocities_and_accelerations() -> None:
    motion = solve(by_coordinates({"O": 0j, "A": 4 + 3j, "B": 4 - 1j, "C": 8 - 1j}, 4.0, 0.0))
    assert motion.omega["AB"][0] == pytest.approx(3, rel=1e-14)
    assert motion.omega["BC"][0] == pytest.approx(-4, rel=1e-14)
    assert motion.epsilon["AB"][0] == pytest.approx(32, rel=1e-14)
    assert motion.epsilon["BC"][0] == pytest.approx(3, rel=1e-13)


def test_k27_sleeve_on_the_crank() -> None:
    motion = solve(sleeve_on_crank(2.0, 1.0, 2.0, 2.0, pi / 2, -1.0))
    parts = relative_motion(motion, "C", "BD")
    assert parts.acceleration is not None
    assert abs(parts.velocity[0]) == pytest.approx(2 / sqrt(5), rel=1e-14)
    assert abs(parts.acceleration[0]) == pytest.approx(6 * sqrt(5) / 25, rel=1e-13)
    assert abs(motion.omega["BD"][0]) == pytest.approx(1 / 5, rel=1e-14)
    assert motion.v["B"][0] == pytest.approx(2)
    # Instantaneous translation is exact: no 1e-17, and the centre is reported as infinite.
    assert motion.omega["AB"][0] == 0.0
    assert motion.a["B"][0] == 0.0
    assert not velocity_centre(motion, "AB").finite[0]


def test_m24_wheel_on_a_rail() -> None:
    motion = solve(wheel(0.5, 2.0), order=1)
    assert abs(motion.omega["wheel"][0]) == pytest.approx(4)
    assert abs(motion.v["T"][0]) == pytest.approx(4)
    assert abs(motion.v["A"][0]) == pytest.approx(2 * sqrt(2))
    assert motion.v["P"][0] == 0
    assert velocity_centre(motion, "wheel").z[0] == pytest.approx(0)


def test_m31_wheel_with_accelerated_centre() -> None:
    motion = solve(wheel(0.5, 1.0, 2.0))
    assert motion.a["A"][0] == pytest.approx(4 + 2j)
    assert abs(motion.epsilon["wheel"][0]) == pytest.approx(4)


@pytest.mark.parametrize("branch", [1, -1])
def test_m26_equilateral_velocity_centre(branch: int) -> None:
    # P = 0, A = 40, B = 40 at 60 degrees; O on the line PA beyond A, C on the line PB beyond B.
    turn = complex(0.5, sqrt(3) / 2) if branch > 0 else complex(0.5, -sqrt(3) / 2)
    motion = solve(by_coordinates({"O": 60 + 0j, "A": 40 + 0j, "B": 40 * turn, "C": 80 * turn}, 2.0, 0.0), order=1)
    assert abs(motion.omega["AB"][0]) == pytest.approx(1)
    assert abs(motion.omega["BC"][0]) == pytest.approx(1)
    assert abs(motion.v["B"][0]) == pytest.approx(40)
    assert velocity_centre(motion, "AB").z[0] == pytest.approx(0, abs=1e-13)


def test_m34_spool() -> None:
    motion = solve(spool(0.3, 0.5, 0.8, 1.6))
    assert abs(motion.omega["spool"][0]) == pytest.approx(1)
    assert motion.v["O"][0] == pytest.approx(0.5)
    assert abs(motion.epsilon["spool"][0]) == pytest.approx(2)
    assert motion.a["A"][0] == pytest.approx(1.5 + 1j)


def test_m35_four_bar_with_accelerations() -> None:
    # The source has a sign error in one projection; these are the right values (its epsilon_BO1, a_B, a_C are wrong).
    motion = solve(four_bar(10.0, 20.0, 20.0, 30.0, 0.0, -2.0, -2 * sqrt(3)))
    assert abs(motion.omega["AB"][0]) == pytest.approx(1)
    assert abs(motion.omega["BC"][0]) == pytest.approx(1)
    assert motion.epsilon["AB"][0] == 0.0
    assert abs(motion.epsilon["BC"][0]) == pytest.approx(2 * sqrt(3))
    assert abs(motion.a["B"][0]) == pytest.approx(20 * sqrt(13))
    assert abs(motion.a["M"][0]) == pytest.approx(10 * sqrt(39))


def test_slider_crank_against_the_formula_of_the_textbooks() -> None:
    # x = a cos(phi) + sqrt(b^2 - (a sin(phi) - e)^2), differentiated by hand.
    a, b, e, phi, omega, epsilon = 0.3, 0.9, 0.12, 1.1, 2.5, -4.0
    motion = solve(slider_crank(a, b, e, phi, omega, epsilon))
    y, root = a * np.sin(phi) - e, np.sqrt(b**2 - (a * np.sin(phi) - e) ** 2)
    first = -a * np.sin(phi) - y * a * np.cos(phi) / root
    slope_of_y, second_y = a * np.cos(phi), -a * np.sin(phi)
    second = -a * np.cos(phi) - (slope_of_y**2 + y * second_y) / root - (y * slope_of_y) ** 2 / root**3
    assert motion.v["B"][0] == pytest.approx(first * omega, rel=1e-13)
    assert motion.a["B"][0] == pytest.approx(second * omega**2 + first * epsilon, rel=1e-12)


def test_acceleration_centre_of_a_wheel_that_rolls_uniformly_is_its_centre() -> None:
    motion = solve(wheel(0.5, 2.0, 0.0))
    assert acceleration_centre(motion, "wheel").z[0] == pytest.approx(0.5j)


def test_accelerations_are_distributed_about_the_acceleration_centre() -> None:
    motion = solve(four_bar(0.3, 0.8, 0.7, 0.9, 1.0, 1.5, 2.0))
    centre = acceleration_centre(motion, "AB")
    omega, epsilon = motion.omega["AB"][0], motion.epsilon["AB"][0]
    at_centre = motion.a["A"][0] + (1j * epsilon - omega**2) * (centre.z[0] - motion.z["A"][0])
    assert at_centre == pytest.approx(0, abs=1e-12)
    assert abs(motion.a["B"][0]) == pytest.approx(
        abs(motion.z["B"][0] - centre.z[0]) * np.hypot(epsilon, omega**2), rel=1e-12
    )
