"""One body over every form of the catalogue: the way of its driver, without jumps, velocities as slopes of places."""

from __future__ import annotations

import numpy as np
import pytest

from variantgen.families.reading.folders import family_names
from variantgen.families.reading.load import load_family
from variantgen.mechanism.rows import Placement
from variantgen.mechanism.turn.sweep import Sweep, SweepEnd
from variantgen.single import answers, asked_quantities, one_variant
from variantgen.variants.driver_sweep import DriverSweep, driver_sweep
from variantgen.variants.variant import Variant

FORMS = [(name, form) for name in family_names() for form in load_family(name).forms]
# Central differences of order six: weights of the places 1, 2, 3 steps ahead less those behind.
_WEIGHTS = (45 / 60, -9 / 60, 1 / 60)
_SAMPLES = 541


@pytest.fixture(scope="module", params=FORMS, ids="-".join)
def gone(request: pytest.FixtureRequest) -> tuple[Variant, DriverSweep]:
    name, form = request.param
    variant = one_variant(name, seed="course", form=form)
    return variant, driver_sweep(variant, asked_quantities(variant), _SAMPLES)


def marked(sweep: Sweep) -> set[str]:
    """Contacts: places that no body carries."""
    scene = sweep.motion.scene
    at = Placement(sweep.motion.z, scene.frame, sweep.turned)
    return {name for joint in scene.joints for name in joint.marked(at, at)}


def even_places(sweep: Sweep) -> np.ndarray:
    """Indices with three neighbours on each side at equal steps, well away from dead points."""
    wide = np.lib.stride_tricks.sliding_window_view(np.diff(sweep.way), 6)
    even = np.ptp(wide, axis=1) < 1e-9 * np.max(wide)
    # A scaled determinant may be small everywhere; what counts is whether it falls.
    far = 0.5 * float(np.max(sweep.motion.transmission))
    clear = np.lib.stride_tricks.sliding_window_view(sweep.motion.transmission, 7).min(axis=1) > far
    return np.flatnonzero(even & clear) + 3


def test_velocities_are_the_slopes_of_places(gone: tuple[Variant, DriverSweep]) -> None:
    _, found = gone
    sweep = found.sweep
    at = even_places(sweep)
    assert len(at) > 20
    time = (sweep.way[at + 1] - sweep.way[at]) / sweep.leading_driver.rate
    speed = max(float(np.max(np.abs(v[at]))) for v in sweep.motion.v.values())

    def slope(values: np.ndarray) -> np.ndarray:
        """Derivative by the time that the drivers would need at their given rates."""
        total = sum(w * (values[at + k] - values[at - k]) for k, w in enumerate(_WEIGHTS, 1))
        return np.asarray(total / time)

    for name in sweep.motion.v.keys() - marked(sweep):
        assert np.max(np.abs(slope(sweep.motion.z[name]) - sweep.motion.v[name][at])) < 1e-4 * speed, name
    fastest = max(float(np.max(np.abs(rate[at]))) for rate in sweep.motion.omega.values())
    for body, rate in sweep.motion.omega.items():
        assert np.max(np.abs(slope(sweep.turned[body]) - rate[at])) < 1e-4 * max(fastest, 1e-9), body


def test_the_instant_has_the_printed_answers(gone: tuple[Variant, DriverSweep]) -> None:
    variant, found = gone
    for answer in answers(variant):
        value = answer.unit.from_si(float(answer.quantity.value(found.sweep.motion)[found.sweep.instant]))
        assert value == pytest.approx(answer.value, rel=1e-7, abs=1e-9)  # answers have eight digits


def test_bodies_stay_rigid_and_joints_closed(gone: tuple[Variant, DriverSweep]) -> None:
    _, found = gone
    motion, start, contacts = found.sweep.motion, found.sweep.instant, marked(found.sweep)
    size = float(motion.length_scale()[start])
    for body, members in motion.scene.bodies.items():
        pole = members[0]
        for name in set(members) - contacts - {pole}:
            arm = (motion.z[name] - motion.z[pole]) * np.exp(-1j * found.sweep.turned[body])
            assert np.max(np.abs(arm - arm[start])) < 1e-9 * size, (body, name)
    # Each joint from each position to the next.
    places = {name: (z[:-1], z[1:]) for name, z in motion.z.items()}
    before = Placement({name: pair[0] for name, pair in places.items()}, motion.frame)
    turned = {body: np.diff(turn) for body, turn in found.sweep.turned.items()}
    after = Placement({name: pair[1] for name, pair in places.items()}, motion.frame, turned)
    for joint in motion.scene.joints:
        for residual in joint.residual(after, before, 0.0):
            assert np.max(np.abs(residual)) < 1e-9 * max(size, 1.0), joint


def test_ends_are_what_they_say(gone: tuple[Variant, DriverSweep]) -> None:
    _, found = gone
    sweep = found.sweep
    assert np.all(np.diff(sweep.way) > 0)
    for end, index in zip(sweep.ends, (0, -1), strict=True):
        transmission = float(sweep.motion.transmission[index])
        if end is SweepEnd.DEAD_POINT:
            assert transmission < 0.02
        if end is SweepEnd.JOINT:
            assert transmission > 1e-4
    if sweep.ends == (SweepEnd.TURN, SweepEnd.TURN):
        assert sweep.way[-1] - sweep.way[0] == pytest.approx(2 * np.pi)
    # Neighbouring positions are close: no jump to another branch.
    size = float(sweep.motion.length_scale()[sweep.instant])
    reach = max(float(np.max(np.abs(np.diff(z)))) for z in sweep.motion.z.values())
    assert reach < 0.35 * size


def test_a_printed_angle_stands_at_the_instant(gone: tuple[Variant, DriverSweep]) -> None:
    variant, found = gone
    at = found.values[found.sweep.instant]
    assert at == pytest.approx(float(variant.printed[found.given]) if found.given else 0.0)
