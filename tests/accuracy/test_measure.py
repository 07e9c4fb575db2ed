"""Classes of cases, ways to compute, and how results are judged."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest

from variantgen.accuracy.cases import cancellation, dead_points, far_centres
from variantgen.accuracy.cases._shapes import four_bars, grouped, slider_cranks
from variantgen.accuracy.computed import CaseGroup, Computed
from variantgen.accuracy.measure import FAILURES, Errors, discovered, measure, part, reference_cases
from variantgen.accuracy.run import case_modules
from variantgen.accuracy.textbook.four_bar import FourBar
from variantgen.mechanism.solving.solve import solve
from variantgen.testing.linkages import wheel


@pytest.fixture(scope="module")
def group() -> CaseGroup:
    return grouped("four-bar", four_bars(np.random.default_rng(3), 3), 3)


@pytest.fixture(scope="module")
def known(group: CaseGroup) -> list:
    return reference_cases(group)[1]


# By way: what the largest error of velocities and of accelerations is below, on ordinary four-bars.
LEAST = {
    "production": (1e-14, 1e-14),
    "extended": (1e-17, 1e-17),
    "dense": (1e-14, 1e-14),
    "newton": (1e-13, 1e-13),
    "central_two": (1e-6, 1e-5),
    "central_six": (1e-9, 1e-7),
    "closed_form": (1e-14, 1e-13),
    "complex_step": (1e-14, 1e-5),
}


@pytest.mark.parametrize("way", discovered())
def test_every_way_computes_the_motion(way: str, group: CaseGroup, known: list) -> None:
    found = measure(way, group, known, 0)
    assert len(found.rows) + sum(found.failures.values()) == 3
    if way != "newton":
        assert not any(found.failures.values())
    errors = np.array(found.rows)
    assert errors[:, 1].max() < LEAST[way][0]
    assert errors[:, 2].max() < LEAST[way][1]


def test_slider_crank_by_textbook_and_by_complex_step() -> None:
    group, known = reference_cases(grouped("slider-crank", slider_cranks(np.random.default_rng(5), 3), 3))
    for way in ("closed_form", "complex_step"):
        found = np.array(measure(way, group, known, 0).rows)
        assert found[:, 1].max() < 1e-14
        assert found[:, 2].max() < LEAST[way][1]


def test_time_is_taken_for_a_whole_batch(group: CaseGroup, known: list) -> None:
    found = measure("production", group, known, 1)
    assert found.batch == discovered()["production"].BATCH
    assert 0 < found.seconds < 1


def test_only_variants_with_a_result_are_timed() -> None:
    # A parallelogram exactly folded has no velocities: its dense system is singular.
    bars = FourBar(*(np.array(x) for x in ((0.3, 0.3), (0.8, 0.8), (0.3, 0.3), (0.8, 0.8), (0.0, 1.0))),
                   np.ones(2), np.ones(2), np.ones(2))  # fmt: skip
    group = grouped("parallelograms", bars, 2)
    sound, known = reference_cases(part(group, [1]))
    found = measure("dense", group, [known[0], known[0]], 1)
    assert found.failures["exception"] + found.failures["wrong branch"] + found.failures["refused"] == 1
    assert sound.size == 1
    assert found.seconds > 0


def test_ways_that_do_not_apply_say_so() -> None:
    motion = solve(wheel(0.3, 1.0, 2.0))
    group = CaseGroup("wheel", motion.scene, 1)
    assert "closed form" in measure("closed_form", group, [], 0).absent


class _Failing(ModuleType):
    """A way that goes wrong in a different manner for each variant."""

    BATCH = 1

    def applies(self, group: CaseGroup) -> str:
        return ""

    def prepare(self, group: CaseGroup) -> object:
        right = discovered()["production"].prepare(group)()
        flags = np.zeros(group.size, bool)

        def spoilt() -> Computed:
            if group.size == 1 and group.scene.points["C"].x[0] == self.singular:
                raise np.linalg.LinAlgError
            if self.singular in group.scene.points["C"].x:
                raise ZeroDivisionError
            return Computed(*self.change(group, right), refused=flags, lost=flags)

        return spoilt

    def change(self, group: CaseGroup, right: Computed) -> tuple:
        base = group.scene.points["C"].x
        wrong = np.where(base == self.mirrored, np.conj(right.z["B"]), right.z["B"])
        v = np.where(base == self.nan, np.nan, right.v["B"])
        return {**right.z, "B": wrong}, {**right.v, "B": v}, right.a, right.omega, right.epsilon


def test_failures_are_counted_and_not_averaged(monkeypatch: pytest.MonkeyPatch) -> None:
    group = grouped("four-bar", four_bars(np.random.default_rng(4), 4), 4)
    group, known = reference_cases(group)
    way = _Failing("failing")
    way.singular, way.mirrored, way.nan = group.scene.points["C"].x[:3]
    every = {**discovered(), "failing": way}
    monkeypatch.setattr("variantgen.accuracy.measure.discovered", lambda: every)
    found = measure("failing", group, known, 0)
    assert found.failures == {**dict.fromkeys(FAILURES, 0), "exception": 1, "wrong branch": 1, "not a number": 1}
    assert len(found.rows) == 1
    assert found.rows[0][2] < 1e-13


# Drawing from the catalogue (place 0) takes its time, and has tests of its own.
MADE = [module for module in case_modules() if module.PLACE > 0]


@pytest.mark.parametrize("module", MADE, ids=lambda module: module.TITLE)
def test_cases_depend_on_the_seed_only(module: ModuleType) -> None:
    first, second = (module.groups(8, np.random.default_rng(1)) for _ in range(2))
    assert [g.label for g in first] == [g.label for g in second]
    for one, other in zip(first, second, strict=True):
        a, b = solve(one.scene), solve(other.scene)
        assert all(np.array_equal(a.z[name], b.z[name]) for name in a.z)
        assert one.size == a.size >= 1


def test_angles_near_dead_points_are_what_they_are_called() -> None:
    for group in dead_points.groups(16, np.random.default_rng(2)):
        angle = group.notes["angle"]
        if angle >= 1e-6:
            motion = solve(group.scene)
            assert np.all(np.abs(motion.transmission / angle - 1) < 0.4)


def test_far_centres_are_far() -> None:
    for group in far_centres.groups(8, np.random.default_rng(2)):
        angle = group.notes["angle"]
        motion = solve(group.scene)
        assert np.all(np.abs(motion.omega["AB"]) < 100 * angle * np.abs(motion.omega["OA"]) + 1e-14)


def test_accelerations_cancel() -> None:
    for group in cancellation.groups(5, np.random.default_rng(2)):
        motion, remainder = solve(group.scene), group.notes["remainder"]
        value = motion.epsilon["BC"] if "BC" in motion.epsilon else motion.a["B"]
        scale = np.max([np.abs(x) for x in motion.a.values()], axis=0)
        assert np.all(np.abs(value) < 1e3 * (remainder + 1e-14) * scale)


def test_part_of_a_group_may_repeat(group: CaseGroup) -> None:
    several = part(group, [2, 0, 2])
    assert several.size == 3
    z, whole = solve(several.scene).z["B"], solve(group.scene).z["B"]
    assert np.array_equal(z, whole[[2, 0, 2]])
    assert np.array_equal(several.textbook.a, group.textbook.a[[2, 0, 2]])


def test_errors_start_empty() -> None:
    assert Errors("production", "").failures == dict.fromkeys(FAILURES, 0)
