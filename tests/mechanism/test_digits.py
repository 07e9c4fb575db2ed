"""Near dead and change points: what doubles can tell is told, what the last bits decide is refused, at any scale."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from variantgen.mechanism.motion import Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.solving.solve import solve
from variantgen.testing.linkages import four_bar, slider_crank


def parallelogram(angle: float, scale: float = 1.0) -> Motion:
    """Cranks of 0.3, rod and base of 0.8; its coupler keeps its direction, so that all is known by hand."""
    return solve(four_bar(0.3 * scale, 0.8 * scale, 0.3 * scale, 0.8 * scale, angle, 2.0, 1.0, 1.0))


@pytest.mark.parametrize("angle", [1.0, 1e-1, 1e-2, 1e-3])
@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_a_parallelogram_that_is_not_too_flat_is_solved(angle: float, scale: float) -> None:
    motion = parallelogram(angle, scale)
    assert motion.outcome[0] == Outcome.SOLVED
    assert motion.omega["BC"][0] == pytest.approx(2.0, rel=1e-7)
    assert abs(motion.omega["AB"][0]) < 1e-7
    assert motion.epsilon["BC"][0] == pytest.approx(1.0, rel=1e-4)


@pytest.mark.parametrize("angle", [1e-6, 1e-7, 1e-8, 1e-12, 0.0])
@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_one_that_is_flat_but_for_the_last_digits_is_refused(angle: float, scale: float) -> None:
    # The accelerations lose eps / angle^3: at 1e-6 rad nothing is left of them, though velocities have four digits.
    # Folded all but exactly, rounding may also say that it does not assemble.
    allowed = {Outcome.DEAD_POINT} if angle > 1e-8 else {Outcome.DEAD_POINT, Outcome.NOT_ASSEMBLED}
    assert parallelogram(angle, scale).outcome[0] in allowed


def test_velocities_alone_go_further() -> None:
    scene = four_bar(0.3, 0.8, 0.3, 0.8, 1e-5, 2.0, 1.0, 1.0)
    motion = solve(scene, 1)
    assert motion.outcome[0] == Outcome.SOLVED
    assert motion.omega["BC"][0] == pytest.approx(2.0, rel=1e-4)
    assert solve(scene, 2).outcome[0] == Outcome.DEAD_POINT


def test_an_exact_special_position_is_none() -> None:
    """Perpendicular links and an instantaneous translation are computed to the last digit."""
    motion = solve(slider_crank(0.3, 0.8, 0.0, math.pi / 2, 3.0))
    assert motion.outcome[0] == Outcome.SOLVED
    assert motion.omega["AB"][0] == 0.0


def test_a_bad_variant_does_not_touch_its_neighbours() -> None:
    angles = np.array([1.0, 1e-9, 0.4, 1e-4, 0.0])
    together = solve(four_bar(0.3, 0.8, 0.3, 0.8, angles, 2.0, 1.0, 1.0))
    assert (together.outcome == 0).tolist() == [True, False, True, True, False]
    for i, angle in enumerate(angles):
        alone = parallelogram(float(angle))
        assert alone.outcome[0] == together.outcome[i]
        assert alone.omega["AB"][0] == together.omega["AB"][i]
    assert all(np.all(np.isfinite(x)) for table in (together.v, together.a, together.omega) for x in table.values())


@given(st.floats(-12, 0), st.floats(-9, 9), st.floats(-6, 6))
def test_nothing_is_ever_not_a_number(exponent: float, scale: float, rate: float) -> None:
    size = 10.0**scale
    motion = solve(
        four_bar(0.3 * size, 0.8 * size, 0.31 * size, 0.8 * size, 10.0**exponent, 10.0**rate, -(10.0**rate), 1.0)
    )
    assert all(
        np.all(np.isfinite(x))
        for table in (motion.z, motion.v, motion.a, motion.omega, motion.epsilon)
        for x in table.values()
    )
