"""What the way is called on paper, and where rods, slots and walls end it."""

from __future__ import annotations

import numpy as np
import pytest

from variantgen.errors import InputError
from variantgen.mechanism.turn.sweep import SweepEnd
from variantgen.single import asked_quantities, one_variant
from variantgen.variants.driver_sweep import DriverSweep, driver_sweep


def of(family: str, form: str = "", **fixed: str) -> DriverSweep:
    variant = one_variant(family, fixed, "course", form)
    return driver_sweep(variant, asked_quantities(variant))


def test_a_printed_angle_runs_from_zero_to_a_turn() -> None:
    found = of("slider_crank", "central")
    assert found.given == "phi"
    assert sorted((found.values[0], found.values[-1])) == pytest.approx([0, 360], abs=1e-9)


def test_an_angle_that_falls_with_the_motion() -> None:
    left = of("four_bar", "crank", sense="counter_clockwise", phi="60")
    right = of("four_bar", "crank", sense="clockwise", phi="60")
    assert np.sign(left.values[-1] - left.values[0]) == -np.sign(right.values[-1] - right.values[0])


def test_without_a_printed_angle_the_instant_is_in_the_middle() -> None:
    found = of("planetary_train", "ring")
    assert found.given == ""
    assert found.target == ("OA",)
    assert found.values[[0, -1]] == pytest.approx([-180, 180])


def test_a_cylinder_is_measured_by_its_length() -> None:
    found = of("hydraulic_hoist", "boom")
    assert found.target == ("F", "B")
    assert found.sweep.ends == (SweepEnd.DEAD_POINT, SweepEnd.DEAD_POINT)
    z = found.sweep.motion.z
    length = np.abs(z["B"] - z["F"])
    way = found.values if found.sweep.motion.omega else -found.values
    assert np.ptp(np.abs(length - length[found.sweep.instant]) - np.abs(way)) < 1e-9


def test_a_ladder_stays_on_its_walls() -> None:
    found = of("ladder", "driven_at_wall")
    corner, foot, top = (found.sweep.motion.z[name] for name in ("O", "F", "A"))
    assert SweepEnd.JOINT in found.sweep.ends
    assert np.min(np.abs(top - corner)) < 1e-6 * np.max(np.abs(foot - corner))
    assert np.all(np.abs(np.angle((top - corner) / (foot - corner))[1:-1]) < 0.51 * np.pi)


def test_a_load_does_not_run_past_its_pulley() -> None:
    found = of("movable_pulley", "anchored")
    assert SweepEnd.JOINT in found.sweep.ends
    drop = found.sweep.motion.z["K"] - found.sweep.motion.z["A"]
    assert np.min(drop.imag) > 0


def test_nothing_moves() -> None:
    variant = one_variant("hydraulic_hoist", {"w": "0"}, "course", "boom")
    still = type(variant)(variant.family, variant.form, {**variant.printed, "u": variant.printed["w"]})
    with pytest.raises(InputError, match="nothing moves"):
        driver_sweep(still, asked_quantities(variant))
