"""Theorems of the chapter as properties of the solved motion, over ordinary and awkward mechanisms."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from variantgen.mechanism.motion import Motion
from variantgen.mechanism.relative import relative_motion
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.verification.verify import invariants, recompute
from variantgen.testing import (
    centre_consistent,
    coriolis_direction,
    equal_projections,
    mechanisms,
    mirror,
    mirrored,
    power_balance_of_constraints,
    rescaled,
    rolling_contact_at_rest,
    scaling,
    scenes,
    time_reversal,
)
from variantgen.testing.linkages import four_bar, sleeve_on_crank, spool

RATE = st.floats(-8, 8).filter(lambda x: abs(x) > 0.1)
LENGTHS = st.tuples(st.floats(0.1, 0.6), st.floats(0.3, 1.2), st.floats(0.3, 1.2), st.floats(0.3, 1.2))


def solved(scene: Scene) -> Motion:
    motion = solve(scene)
    assume(bool(motion.solved[0]) and float(motion.transmission[0]) > 0.2)
    return motion


@given(st.one_of(mechanisms(), scenes()))
def test_theorems_of_one_motion(scene: Scene) -> None:
    motion = solve(scene)
    assert motion.solved.all()
    assert equal_projections(motion)[0] < 1e-12
    assert centre_consistent(motion)[0] < 1e-11
    assert coriolis_direction(motion)[0] < 1e-10
    assert rolling_contact_at_rest(motion)[0] < 1e-12
    assert power_balance_of_constraints(motion)[0] < 1e-7


@given(st.floats(0.3, 0.6), st.floats(0.1, 0.25), st.floats(0.4, 0.9), st.floats(0.3, 2.8), RATE, RATE)
def test_coriolis_is_the_relative_velocity_turned_with_the_carrier(
    oa: float, oc: float, ab: float, phi: float, omega: float, epsilon: float
) -> None:
    motion = solved(sleeve_on_crank(oa, oc, ab, 0.3, phi, omega, epsilon))
    parts = relative_motion(motion, "C", "BD")
    assert parts.coriolis is not None
    carrier, v, c = motion.omega["BD"][0], parts.velocity[0], parts.coriolis[0]
    turned = v * (1j if carrier > 0 else -1j)
    assert c == pytest.approx(2 * abs(carrier) * turned, rel=1e-12)


@given(st.one_of(mechanisms(), scenes()))
def test_independent_computation_agrees(scene: Scene) -> None:
    motion = solve(scene)
    again = recompute(motion)
    assert again.velocity_error[0] < 1e-8
    assert again.acceleration_error[0] < 1e-6
    assert invariants(motion)[0] < 1e-10


@given(st.one_of(mechanisms(), scenes()), st.floats(-6, 6), st.floats(-3, 3))
def test_scale(scene: Scene, length: float, time: float) -> None:
    k, t = 10.0**length, 10.0**time
    assert scaling(solve(scene), solve(rescaled(scene, k, t)), k, t)[0] < 1e-9


@given(st.one_of(mechanisms(), scenes()))
def test_time_reversal(scene: Scene) -> None:
    assert time_reversal(solve(scene), solve(rescaled(scene, time=-1.0)))[0] < 1e-10


@given(st.one_of(mechanisms(), scenes()))
def test_mirror(scene: Scene) -> None:
    assert mirror(solve(scene), solve(mirrored(scene)))[0] < 1e-9


@given(LENGTHS, st.floats(-3, 3), RATE, RATE, st.floats(-3, 3), st.sampled_from([1.0, -1.0]))
def test_rotation_and_mirror_on_paper(
    lengths: tuple[float, ...], phi: float, omega: float, epsilon: float, turn: float, sense: float
) -> None:
    frame = Frame(np.exp(1j * turn), sense)
    one = solved(four_bar(*lengths, phi, omega, epsilon))
    other = solved(four_bar(*lengths, phi, omega, epsilon, frame=frame))
    for name in one.z:
        for table, again in ((one.z, other.z), (one.v, other.v), (one.a, other.a)):
            size = max(1.0, *(abs(x[0]) for x in table.values()))
            assert again[name][0] == pytest.approx(frame.place(table[name][0]), abs=1e-9 * size)
    for body in one.omega:
        assert other.omega[body][0] == pytest.approx(sense * one.omega[body][0], rel=1e-9, abs=1e-9)
        assert other.epsilon[body][0] == pytest.approx(sense * one.epsilon[body][0], rel=1e-9, abs=1e-8)


@given(st.floats(0.1, 0.4), RATE, RATE, st.sampled_from([1.0, -1.0]))
def test_the_thread_keeps_its_length(r: float, v: float, a: float, side: float) -> None:
    motion = solved(spool(r, 0.5, v, a, side))
    # The point of the drum where the thread leaves moves along the thread as fast as the load falls.
    leaves = motion.z["O"][0] + 1j * side * r
    along = (motion.v["O"][0] + 1j * motion.omega["spool"][0] * (leaves - motion.z["O"][0])).real
    assert along == pytest.approx(v, rel=1e-10)
