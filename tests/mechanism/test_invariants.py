"""Theorems of the chapter as properties of the solved motion, over ordinary and awkward mechanisms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.mechanisms import four_bar, sleeve_on_crank, slider_crank, spool, wheel
from variantgen.mechanism.centres import velocity_centre
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.relative import relative_motion
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solve import solve
from variantgen.mechanism.verify import invariants, recompute

RATE = st.floats(-8, 8).filter(lambda x: abs(x) > 0.1)
LENGTHS = st.tuples(st.floats(0.1, 0.6), st.floats(0.3, 1.2), st.floats(0.3, 1.2), st.floats(0.3, 1.2))


def scenes() -> st.SearchStrategy[Scene]:
    four = st.builds(
        lambda sides, phi, w, e, side: four_bar(*sides, phi, w, e, side),
        LENGTHS, st.floats(-3.1, 3.1), RATE, RATE, st.sampled_from([1.0, -1.0]),
    )  # fmt: skip
    slider = st.builds(
        slider_crank, st.floats(0.1, 0.4), st.floats(0.5, 1.2), st.floats(-0.2, 0.2), st.floats(-3.1, 3.1), RATE, RATE,
        st.floats(-3, 3),
    )  # fmt: skip
    sleeve = st.builds(
        sleeve_on_crank, st.floats(0.3, 0.6), st.floats(0.1, 0.25), st.floats(0.4, 0.9), st.floats(0.1, 0.5),
        st.floats(0.3, 2.8), RATE, RATE,
    )  # fmt: skip
    rolling = st.builds(wheel, st.floats(0.1, 2), RATE, RATE)
    spools = st.builds(
        lambda r, v, a, side, x, y: spool(r, 0.5, v, a, side, Coordinates(x, y)),
        st.floats(0.1, 0.4), RATE, RATE, st.sampled_from([1.0, -1.0]), st.floats(1.5, 3), st.floats(0.2, 2.0),
    )  # fmt: skip
    return st.one_of(four, slider, sleeve, rolling, spools)


def solved(scene: Scene, order: int = 2) -> Motion:
    motion = solve(scene, order)
    assume(bool(motion.solved[0]) and float(motion.transmission[0]) > 0.2)
    return motion


@given(scenes())
def test_equal_projections_of_velocities(scene: Scene) -> None:
    motion = solved(scene)
    fastest = max(abs(v[0]) for v in motion.v.values())
    for members in scene.bodies.values():
        for first in members:
            for second in members:
                line = motion.z[second][0] - motion.z[first][0]
                if abs(line) < 1e-9:
                    continue
                difference = (np.conj(line / abs(line)) * (motion.v[second][0] - motion.v[first][0])).real
                assert abs(difference) <= 1e-12 * max(fastest, 1.0)


@given(scenes())
def test_velocities_are_perpendicular_to_the_rays_from_the_velocity_centre(scene: Scene) -> None:
    motion = solved(scene)
    for body, members in scene.bodies.items():
        centre = velocity_centre(motion, body)
        omega = motion.omega[body][0]
        if not centre.finite[0] or abs(centre.z[0]) > 1e3:
            continue
        for point in members:
            ray = motion.z[point][0] - centre.z[0]
            # v = i omega r says both: perpendicular, and the modulus omega * distance.
            assert motion.v[point][0] == pytest.approx(1j * omega * ray, abs=1e-9 * (1 + abs(omega)))


@given(st.floats(0.3, 0.6), st.floats(0.1, 0.25), st.floats(0.4, 0.9), st.floats(0.3, 2.8), RATE, RATE)
def test_coriolis_is_the_relative_velocity_turned_with_the_carrier(
    oa: float, oc: float, ab: float, phi: float, omega: float, epsilon: float
) -> None:
    motion = solved(sleeve_on_crank(oa, oc, ab, 0.3, phi, omega, epsilon))
    parts = relative_motion(motion, "C", "BD")
    assert parts.acceleration is not None
    assert parts.coriolis is not None
    carrier, v, c = motion.omega["BD"][0], parts.velocity[0], parts.coriolis[0]
    assert abs(c) == pytest.approx(2 * abs(carrier) * abs(v), rel=1e-12)
    turned = v * (1j if carrier > 0 else -1j)
    assert c == pytest.approx(2 * abs(carrier) * turned, rel=1e-12)
    # Relative velocity and relative acceleration lie along the rod.
    rod = motion.z["D"][0] - motion.z["B"][0]
    assert (np.conj(rod) * v).imag == pytest.approx(0, abs=1e-11 * abs(rod) * max(1, abs(v)))
    a = parts.acceleration[0]
    assert (np.conj(rod) * a).imag == pytest.approx(0, abs=1e-9 * abs(rod) * max(1, abs(a), abs(c)))


@given(scenes())
def test_independent_computation_agrees(scene: Scene) -> None:
    motion = solved(scene)
    again = recompute(motion)
    assert again.velocity_error[0] < 1e-8
    assert again.acceleration_error[0] < 1e-6
    assert invariants(motion)[0] < 1e-10


def all_rates(motion: Motion) -> dict[str, Any]:
    rates = {f"v_{k}": v[0] for k, v in motion.v.items()} | {f"a_{k}": v[0] for k, v in motion.a.items()}
    return (
        rates | {f"w_{k}": v[0] for k, v in motion.omega.items()} | {f"e_{k}": v[0] for k, v in motion.epsilon.items()}
    )


@given(LENGTHS, st.floats(-3, 3), RATE, RATE, st.floats(-6, 6))
def test_scale(lengths: tuple[float, ...], phi: float, omega: float, epsilon: float, exponent: float) -> None:
    k = 10.0**exponent
    one = all_rates(solved(four_bar(*lengths, phi, omega, epsilon)))
    other = all_rates(solved(four_bar(*(k * x for x in lengths), phi, omega, epsilon)))
    for name, value in one.items():
        factor = k if name[0] in "va" else 1.0
        assert other[name] == pytest.approx(factor * value, rel=1e-9, abs=1e-9 * factor)


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


@given(scenes())
def test_time_reversal(scene: Scene) -> None:
    motion = solved(scene)
    driver = scene.drivers[0]
    name = "omega" if hasattr(driver, "omega") else "v"
    from dataclasses import replace

    back = replace(scene, drivers=(replace(driver, **{name: -getattr(driver, name)}),))  # type: ignore[type-var]
    reversed_motion = solve(back)
    for point in motion.v:
        assert reversed_motion.v[point][0] == pytest.approx(-motion.v[point][0], rel=1e-9, abs=1e-12)
        size = max(1.0, *(abs(a[0]) for a in motion.a.values()))
        assert reversed_motion.a[point][0] == pytest.approx(motion.a[point][0], abs=1e-10 * size)


@given(st.floats(0.1, 0.4), RATE, RATE, st.sampled_from([1.0, -1.0]))
def test_rolling_contact_is_at_rest_and_the_thread_keeps_its_length(r: float, v: float, a: float, side: float) -> None:
    motion = solved(spool(r, 0.5, v, a, side))
    assert motion.v["P"][0] == pytest.approx(0, abs=1e-12 * abs(v) * 50)
    # The point of the drum where the thread leaves moves along the thread as fast as the load falls.
    leaves = motion.z["O"][0] + 1j * side * r
    along = (motion.v["O"][0] + 1j * motion.omega["spool"][0] * (leaves - motion.z["O"][0])).real
    assert along == pytest.approx(v, rel=1e-10)
