"""Groups of links that need more than a pole: steps of solutions against numbers worked out by hand."""

from __future__ import annotations

import math

import pytest

from tests.methods.given_data import results


def test_boom_on_a_cylinder() -> None:
    # O at the origin, F at (1, 0), B at (0, 1): the cylinder is at 45 degrees to the path of B, v_B = 0.5 sqrt 2 to the
    # left. Along the cylinder e = (-1, 1) / sqrt 2: e.a_B + v_tr^2 / FB = 0 with a_B = (-epsilon, -omega^2),
    # v_tr = 0.5, FB = sqrt 2: epsilon = omega^2 - v_tr^2.
    found = results(
        "hydraulic_hoist", "boom", "omega_OT epsilon_OT v_T",
        OF=1, OB=1, OT=2, phi=90, u=0.5, w=0, motion=1,
    )  # fmt: skip
    assert found == pytest.approx({"omega_OT": math.sqrt(0.5), "epsilon_OT": 0.25, "v_T": math.sqrt(2)})


def test_growing_extension_adds_along_the_cylinder() -> None:
    # As above, with w: epsilon grows by w sqrt 2.
    found = results(
        "hydraulic_hoist", "boom", "epsilon_OT",
        OF=1, OB=1, OT=2, phi=90, u=0.5, w=0.2, motion=1,
    )  # fmt: skip
    assert found == pytest.approx({"epsilon_OT": 0.25 + 0.2 * math.sqrt(2)})


def test_falling_rod_by_laws_of_time() -> None:
    # v_C = 9.8 * 0.5; phi = pi / 3 needs t = pi / (3 omega): not on the grid, so omega t = 1 rad instead.
    found = results("falling_rod", "", "v_A.x v_A.y a_A.x a_A.y", AB=2, omega=2, t=0.5, sense=1)
    # A is at 180 degrees + 1 rad from C: v_A = (0, -4.9) + 2 (sin 1, -cos 1), a_A = (0, -9.8) + 4 (cos 1, sin 1).
    assert found["v_A.x"] == pytest.approx(2 * math.sin(1))
    assert found["v_A.y"] == pytest.approx(-4.9 - 2 * math.cos(1))
    assert found["a_A.x"] == pytest.approx(4 * math.cos(1))
    assert found["a_A.y"] == pytest.approx(-9.8 + 4 * math.sin(1))


def test_disc_driven_at_its_centre_in_a_cylinder() -> None:
    # v_O = 60 on a circle of radius 40 - 10: omega = 6, a_O = (60^2 / 30, 50), epsilon = 5; the contact has
    # a_P = omega^2 r - v_O^2 / 30 away from the cylinder: 360 - 120 along the radius, no tangential part.
    found = results(
        "disc_in_cylinder", "by_centre", "omega_disc.abs a_O epsilon_disc.abs",
        R=40, r=10, v_O=60, a_tau=50, sense=1,
    )  # fmt: skip
    assert found == pytest.approx({"omega_disc.abs": 6, "a_O": math.hypot(120, 50), "epsilon_disc.abs": 5})


def test_disc_on_a_crank_that_turns_relative_to_it() -> None:
    # omega = 2 + 3, epsilon = 4 - 6; M across OA: v_M = (crank 2 * 20 and 5 * 10 at right angles).
    found = results(
        "crank_and_disc", "relative", "omega_disc1 epsilon_disc1 v_M",
        OA=20, r=10, alpha=90, omega_OA=2, epsilon_OA=4, omega_r=3, epsilon_r=-6, sense=1, turning=1,
    )  # fmt: skip
    assert found["omega_disc1"] == pytest.approx(5)
    assert found["epsilon_disc1"] == pytest.approx(-2)
    assert found["v_M"] == pytest.approx(math.hypot(40, 50))


def test_wheel_driven_through_its_rod() -> None:
    # alpha = 90 degrees: A on top, v_A = 2 v_O = v_B (the rod translates): v_O = 30, omega = 1 clockwise.
    found = results(
        "wheel_with_rod", "driven_by_slider", "v_O omega_wheel omega_AB a_O",
        R=30, AB=90, alpha=90, v_B=60, a_B=0, way=1, side=1,
    )  # fmt: skip
    # a_O = 30 epsilon, a_A = (2 a_O, -30); the rod makes the angle -asin(1/3): its projection of a_A is zero.
    slope = (1 / 3) / math.sqrt(1 - 1 / 9)
    assert found["v_O"] == pytest.approx(30)
    assert found["omega_wheel"] == pytest.approx(-1)
    assert found["omega_AB"] == pytest.approx(0, abs=1e-12)
    assert found["a_O"] == pytest.approx(30 * slope / 2)
