"""Gears, threads, racks, drums: steps of solutions against hand calculations (guide, section 4.1, examples)."""

from __future__ import annotations

import math

import pytest

from tests.methods.given_data import results


def test_planetary_gear_of_example_27() -> None:
    # R_2 = 15, R_1 = 5, omega_OA = 2.5: v_A = 50, omega_1 = 50 / 5; epsilon_OA = 2: a^tau_A = 40, epsilon_1 = 8.
    # alpha = 90 degrees: AB is across OA, so v_B = omega_1 * 5 sqrt 2.
    found = results(
        "planetary_pair", "outside", "v_A omega_gear1 v_B epsilon_gear1",
        r_1=5, r_2=15, omega_OA=2.5, epsilon_OA=2, alpha=90, sense=1,
    )  # fmt: skip
    assert found["v_A"] == pytest.approx(50)
    assert found["omega_gear1"] == pytest.approx(10)
    assert found["v_B"] == pytest.approx(50 * math.sqrt(2))
    assert found["epsilon_gear1"] == pytest.approx(8)


def test_gear_inside_a_ring_turns_against_the_crank() -> None:
    # OA = 15 - 5 = 10, v_A = 25, omega_1 = -25 / 5; a^tau_A = -20, epsilon_1 = 20 / 5.
    found = results(
        "planetary_pair", "inside", "omega_gear1 epsilon_gear1",
        r_1=5, r_2=15, omega_OA=2.5, epsilon_OA=-2, sense=1,
    )  # fmt: skip
    assert found == pytest.approx({"omega_gear1": -5.0, "epsilon_gear1": 4.0})


def test_both_gears_turn() -> None:
    # v_A = 2 * 30 = 60, v_K = 1 * 20 along it: v_A - 10 omega_2 = 20. In accelerations 3 * 30 - 10 epsilon_2 = 0.
    found = results(
        "gear_pair_with_crank", "outside", "omega_gear2 epsilon_gear2",
        r_1=20, r_2=10, omega_OA=2, epsilon_OA=3, omega_1=1, sense=1, sense_1=1,
    )  # fmt: skip
    assert found == pytest.approx({"omega_gear2": 4.0, "epsilon_gear2": 9.0})


def test_train_of_two_planets() -> None:
    # OB = 30, v_B = 30, omega_2 = 30 / 10 = 3; v_K = 30 + 3 * 10 = 60; OA = 20 + 20 + 15 = 55, v_A = 55;
    # v_K = v_A - 15 omega_3.
    found = results(
        "planetary_train", "two_planets", "omega_gear2 omega_gear3",
        r_1=20, r_2=10, r_3=15, omega_OA=1, epsilon_OA=0, sense=1,
    )  # fmt: skip
    assert found == pytest.approx({"omega_gear2": 3.0, "omega_gear3": -1 / 3})


def test_ring_gear_driven_by_a_planet() -> None:
    # v_A = 30, omega_2 = 3, opposite to the fixed gear v = 60, R_3 = 40, omega_3 = 60 / 40.
    found = results(
        "planetary_train", "ring", "omega_gear3 epsilon_gear3",
        r_1=20, r_2=10, omega_OA=1, epsilon_OA=-2, sense=1,
    )  # fmt: skip
    assert found == pytest.approx({"omega_gear3": 1.5, "epsilon_gear3": -3.0})


def test_movable_pulley_of_example_29() -> None:
    # Loads sink with 8 and 4 m/s, so D and E rise: v_C = (8 + 4) / 2, omega = (8 - 4) / 0.2 (D on the left is faster:
    # clockwise). Accelerations likewise: (3 + 1) / 2 and (3 - 1) / 0.2.
    found = results(
        "movable_pulley", "two_loads", "v_C v_C.y omega_pulley a_C epsilon_pulley",
        R=0.1, v_A=8, v_B=4, a_A=3, a_B=1, way_A=1, way_B=1,
    )  # fmt: skip
    assert found == pytest.approx({"v_C": 6, "v_C.y": 6, "omega_pulley": -20, "a_C": 2, "epsilon_pulley": -10})


def test_pulley_on_a_thread_tied_at_one_end() -> None:
    # The velocity centre is where the tied thread touches: v_C = v_A / 2, omega = v_A / 2R.
    found = results(
        "movable_pulley", "anchored", "v_C omega_pulley a_C epsilon_pulley",
        R=0.2, v_A=2, a_A=-1, way_A=1,
    )  # fmt: skip
    assert found == pytest.approx({"v_C": 1, "omega_pulley": -5, "a_C": 0.5, "epsilon_pulley": 2.5})


def test_load_found_from_the_axle_of_the_pulley() -> None:
    # v_D = 3 up, v_C = 1 up, so the other side goes 1 down and the load B rises with 1.
    found = results(
        "movable_pulley", "load_and_axle", "v_B.y omega_pulley a_B.y",
        R=0.2, v_A=3, v_E=1, a_A=2, a_E=-1, way_A=1, way_E=-1,
    )  # fmt: skip
    # a_D = 2 up; the axle: a_E = -1 along "down", so 1 up; the other side 0.
    assert found == pytest.approx({"v_B.y": 1, "omega_pulley": -10, "a_B.y": 0})


def test_spool_of_example_34() -> None:
    # omega = 80 / (50 + 30) = 1, v_O = 50, a_O = 50 / 80 * 160 = 100, epsilon = 2. A is behind the centre:
    # a_A = (100 + 1 * 50, 2 * 50), since the spool rolls faster and faster to the right.
    found = results(
        "spool", "", "omega_spool v_O a_O epsilon_spool a_A.x a_A.y",
        r=30, R=50, v_B=80, a_B=160, thread=1,
    )  # fmt: skip
    wanted = {"omega_spool": -1, "v_O": 50, "a_O": 100, "epsilon_spool": -2, "a_A.x": 150, "a_A.y": 100}
    assert found == pytest.approx(wanted)


def test_spool_with_the_thread_below() -> None:
    # The thread leaves 20 above the ground: omega = 80 / 20.
    found = results("spool", "", "omega_spool v_O", r=30, R=50, v_B=80, a_B=160, thread=-1)
    assert found == pytest.approx({"omega_spool": -4, "v_O": 200})


def test_wheel_between_a_moving_and_a_fixed_rack() -> None:
    # Section 4.1: v_O = v_1 / 2, a_O = a_1 / 2; the rack below goes to the right, so the wheel turns counter-clockwise.
    found = results(
        "wheel_between_racks", "one_fixed", "v_O omega_wheel a_O epsilon_wheel",
        R=20, v_1=80, a_1=-60, way_1=1,
    )  # fmt: skip
    assert found == pytest.approx({"v_O": 40, "omega_wheel": 2, "a_O": 30, "epsilon_wheel": -1.5})


def test_wheel_between_two_moving_racks() -> None:
    # Below 100 to the right, above 40 to the left: v_O = (100 - 40) / 2, omega = (100 + 40) / 40.
    found = results(
        "wheel_between_racks", "two_moving", "v_O.x omega_wheel a_O.x epsilon_wheel",
        R=20, v_1=100, v_2=40, a_1=60, a_2=100, way_1=1, way_2=-1,
    )  # fmt: skip
    assert found == pytest.approx({"v_O.x": 30, "omega_wheel": 3.5, "a_O.x": 80, "epsilon_wheel": -1})


def test_rack_moved_by_the_axle_of_the_wheel() -> None:
    found = results("wheel_between_racks", "driven_by_axle", "v_A a_A", R=20, v_O=30, a_O=50, way_O=1)
    assert found == pytest.approx({"v_A": 60, "a_A": 100})


def test_roller_outside_a_drum() -> None:
    # v_K = 2 * 20 = 40; seen from O it is v_O - 10 * 3, so v_O = 70; a_O: normal 70^2 / 30, tangential 20 * 1 + 10 * 2.
    found = results(
        "roller_on_drum", "outside", "v_O a_O",
        R=20, r=10, omega_1=2, epsilon_1=1, omega_2=3, epsilon_2=2, sense_1=1, sense_2=1,
    )  # fmt: skip
    assert found["v_O"] == pytest.approx(70)
    assert found["a_O"] == pytest.approx(math.hypot(70**2 / 30, 40))


def test_roller_inside_a_drum_turning_the_other_way() -> None:
    # v_K = 2 * 40 = 80 = v_O + 10 * (-3), so v_O = 110 on a circle of radius 30.
    found = results(
        "roller_on_drum", "inside", "v_O a_O",
        R=40, r=10, omega_1=2, epsilon_1=0, omega_2=3, epsilon_2=0, sense_1=1, sense_2=-1,
    )  # fmt: skip
    assert found == pytest.approx({"v_O": 110, "a_O": 110**2 / 30})


def test_differential_winch() -> None:
    # The threads run with 2 * 20 and 2 * 10 in opposite ways: v_C = (40 - 20) / 2, omega = (40 + 20) / 30.
    found = results(
        "winch_with_pulley", "differential", "v_C omega_pulley.abs a_C epsilon_pulley.abs",
        R=20, r=10, omega_1=2, epsilon_1=3, sense=1,
    )  # fmt: skip
    wanted = {"v_C": 10, "omega_pulley.abs": 2, "a_C": 15, "epsilon_pulley.abs": 3}
    assert found == pytest.approx(wanted)


def test_wheel_pulled_at_its_axle_over_a_stepped_pulley() -> None:
    # omega_2 = 60 / 40, the thread at the axle 1.5 * 20 = 30; accelerations in the same ratio.
    found = results(
        "pulley_and_wheel", "axle", "omega_pulley.abs v_C omega_wheel.abs a_C",
        R_1=30, R_2=40, r_2=20, v_B=60, a_B=-80,
    )  # fmt: skip
    assert found == pytest.approx({"omega_pulley.abs": 1.5, "v_C": 30, "omega_wheel.abs": 1, "a_C": 40})
