"""Blocks, reports of indeterminate scenes, outcomes as values, orders on demand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components, maximum_bipartite_matching

from variantgen.errors import InputError
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.constructions.polar import Polar
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.drivers.travel import Travel
from variantgen.mechanism.joints.guide import Guide
from variantgen.mechanism.joints.pivot import Pivot
from variantgen.mechanism.joints.slot import Slot
from variantgen.mechanism.joints.translation import Translation
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.blocks import triangular_blocks
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.solving.structure import analyse
from variantgen.mechanism.verification.verify import recompute
from variantgen.testing.linkages import four_bar, sleeve_on_crank, slider_crank, spool, wheel

FOUR_BAR = four_bar(0.2, 0.6, 0.5, 0.7, 1.0, 2.0, 3.0)


@pytest.mark.parametrize(
    ("scene", "sizes"),
    [
        (FOUR_BAR, [1, 2]),
        (slider_crank(0.2, 0.6, 0.1, 1.0, 2.0), [1, 1]),
        (sleeve_on_crank(0.4, 0.2, 0.6, 0.3, 1.0, 2.0), [1, 1, 1]),
        (wheel(0.5, 1.0), [1]),
        (spool(0.2, 0.5, 1.0), [1, 1]),
    ],
)
def test_blocks_are_the_groups_of_the_textbook(scene: Scene, sizes: list[int]) -> None:
    assert [len(block.unknowns) for block in analyse(scene).blocks] == sizes


def test_blocks_of_a_mixed_system() -> None:
    # Unknown 2 from equation 0 alone; unknowns 0 and 1 together from equations 1, 2; unknown 3 last.
    blocks, free, surplus = triangular_blocks([{2}, {0, 1, 2}, {0, 1}, {0, 3}], 4)
    assert blocks == [((0,), (2,)), ((1, 2), (0, 1)), ((3,), (3,))]
    assert not free
    assert not surplus


@given(st.integers(1, 9), st.integers(1, 9), st.booleans(), st.integers(0, 2**32 - 1))
def test_blocks_are_those_of_a_library(equations: int, unknowns: int, sound: bool, seed: int) -> None:
    rng = np.random.default_rng(seed)
    if sound:
        unknowns = equations
    matrix = rng.random((equations, unknowns)) < rng.uniform(0.1, 0.5)
    if sound:
        matrix[np.arange(equations), rng.permutation(equations)] = True
    depends = [set(np.flatnonzero(row).tolist()) for row in matrix]
    blocks, free, surplus = triangular_blocks(depends, unknowns)
    partner = maximum_bipartite_matching(csr_array(matrix), perm_type="column")
    pairs = int(np.sum(partner >= 0))
    assert bool(free) == (pairs < unknowns)
    assert bool(surplus) == (pairs < equations)
    if free or surplus:
        assert not blocks
        return
    order = matrix[:, partner]
    count, label = connected_components(csr_array(order), directed=True, connection="strong")
    wanted = [np.flatnonzero(label == number) for number in range(count)]
    assert {(tuple(group), tuple(sorted(partner[group]))) for group in wanted} == set(blocks)
    known: set[int] = set()
    for rows, columns in blocks:
        known |= set(columns)
        assert all(depends[row] <= known for row in rows)


def test_a_scene_without_sleeve_has_no_relative_unknowns() -> None:
    assert all(name.startswith("omega") for name in analyse(FOUR_BAR).unknowns)


def test_missing_driver_names_what_is_free() -> None:
    with pytest.raises(InputError, match="not determined") as caught:
        analyse(replace(FOUR_BAR, drivers=()))
    assert "omega of AB" in str(caught.value)


def test_second_driver_names_what_contradicts() -> None:
    doubled = replace(FOUR_BAR, drivers=(*FOUR_BAR.drivers, Rotation("BC", 1.0)))
    with pytest.raises(InputError, match="repeat or contradict") as caught:
        analyse(doubled)
    assert "rotation of OA" in str(caught.value)
    assert "rotation of BC" in str(caught.value)


def test_points_in_a_circle() -> None:
    scene = Scene({"A": Polar("B", 1.0, 0.0), "B": Polar("A", 1.0, 0.0)}, {"AB": ("A", "B")})
    with pytest.raises(InputError, match="in a circle"):
        analyse(scene)


def test_unknown_names_are_reported_together_with_the_nearest() -> None:
    # Like every other mistake of a scene, they are found when it is analysed or solved.
    scene = Scene({"O": Coordinates(0.0, 0.0)}, {"OA": ("O", "A"), "X": ()}, (Pivot("0"),))
    for use in (analyse, solve):
        with pytest.raises(InputError):
            use(scene)
    with pytest.raises(InputError) as caught:
        analyse(scene)
    text = str(caught.value)
    assert "unknown point (got A)" in text
    assert "at least one point" in text
    assert "pivot of 0" in text


def test_two_degrees_of_freedom_with_two_drivers() -> None:
    # Double pendulum: the velocities add.
    scene = Scene(
        {"O": Coordinates(0.0, 0.0), "A": Coordinates(1.0, 0.0), "B": Coordinates(1.0, 1.0)},
        {"OA": ("O", "A"), "AB": ("A", "B")},
        (Pivot("O"),),
        (Rotation("OA", 2.0, 1.0), Rotation("AB", 3.0, -1.0)),
    )
    motion = solve(scene)
    assert motion.v["B"][0] == pytest.approx(2j - 3)
    assert motion.a["B"][0] == pytest.approx((1j - 4) + (1 - 9j))


def test_falling_rod_with_three_drivers() -> None:
    scene = Scene(
        {"C": Coordinates(0.0, 0.0), "A": Coordinates(1.0, 0.0)},
        {"rod": ("C", "A")},
        (),
        (Travel("C", 0.0, 0.0, 0.0), Travel("C", 19.6, 9.8, -np.pi / 2), Rotation("rod", 0.5)),
    )
    motion = solve(scene)
    assert motion.v["A"][0] == pytest.approx(-19.1j)
    assert motion.a["C"][0] == pytest.approx(-9.8j)


def test_body_in_translation_and_sleeve_that_does_not_swivel() -> None:
    # Scotch yoke in disguise: the crank pin A slides in a slot of the yoke, which moves in translation along x.
    scene = Scene(
        {
            "O": Coordinates(0.0, 0.0), "A": Polar("O", 0.5, 0.7), "S": Coordinates(0.5 * np.cos(0.7), -1.0),
            "T": Coordinates(0.5 * np.cos(0.7), 1.0),
        },
        {"OA": ("O", "A"), "yoke": ("S", "T")},
        (Pivot("O"), Guide("S"), Translation("yoke"), Slot("A", "yoke", ("S", "T"))),
        (Rotation("OA", 3.0, 2.0),),
    )  # fmt: skip
    motion = solve(scene)
    assert motion.omega["yoke"][0] == 0.0
    # x = 0.5 cos(phi), differentiated.
    assert motion.v["S"][0] == pytest.approx(-0.5 * np.sin(0.7) * 3)
    assert motion.a["S"][0] == pytest.approx(-0.5 * (np.cos(0.7) * 9 + np.sin(0.7) * 2))
    assert recompute(motion).acceleration_error[0] < 1e-8


def test_rigid_sleeve_shares_the_rotation_of_its_rod() -> None:
    # A block AB slides along the rod OD without turning relative to it (polar motion r(t), phi(t)).
    scene = Scene(
        {
            "O": Coordinates(0.0, 0.0), "D": Coordinates(2.0, 0.0), "A": Coordinates(1.0, 0.0),
            "B": Coordinates(1.0, 0.5),
        },
        {"OD": ("O", "D"), "AB": ("A", "B")},
        (Pivot("O"), Slot("A", "OD", ("O", "D"), sleeve="AB")),
        (Rotation("OD", 2.0, 0.5), Travel("A", 0.3, 0.1, 0.0)),
    )  # fmt: skip
    motion = solve(scene)
    assert motion.omega["AB"][0] == pytest.approx(2.0)
    assert motion.epsilon["AB"][0] == pytest.approx(0.5)
    # a_phi = r phi'' + 2 r' phi'
    assert motion.a["A"][0].imag == pytest.approx(1.0 * 0.5 + 2 * 0.3 * 2.0)
    assert recompute(motion).acceleration_error[0] < 1e-7


def test_outcomes_are_values_and_nothing_is_nan() -> None:
    # Not assembled, dead point (A, B, C in line), ordinary.
    lengths = np.array([0.125, 0.5, 0.75])
    scene = four_bar(0.25, lengths, 0.25, 1.0, 0.0, 1.0, 1.0)
    motion = solve(scene)
    assert [Outcome(int(o)) for o in motion.outcome] == [Outcome.NOT_ASSEMBLED, Outcome.DEAD_POINT, Outcome.SOLVED]
    tables: tuple[Any, ...] = (motion.z, motion.v, motion.a, motion.omega, motion.epsilon)
    assert all(np.all(np.isfinite(values)) for table in tables for values in table.values())
    assert all(len(outcome.text) > 5 for outcome in Outcome)


def test_one_bad_variant_does_not_touch_the_others() -> None:
    lengths = np.array([0.6, 0.05, 0.61])
    together = solve(four_bar(0.2, lengths, 0.5, 0.7, 1.0, 2.0, 3.0))
    for i in (0, 2):
        alone = solve(four_bar(0.2, float(lengths[i]), 0.5, 0.7, 1.0, 2.0, 3.0))
        # Up to the last bit of a sine, which vector instructions round differently from scalar ones.
        assert together.a["B"][i] == pytest.approx(alone.a["B"][0], rel=1e-14)


def test_orders_on_demand(monkeypatch: pytest.MonkeyPatch) -> None:
    motion = solve(FOUR_BAR, order=0)
    assert not motion.v
    assert not motion.omega
    # A velocity problem evaluates no term quadratic in the velocities.
    monkeypatch.setattr(Pivot, "quadratic", None)
    monkeypatch.setattr(Rotation, "quadratic", None)
    motion = solve(FOUR_BAR, order=1)
    assert motion.v
    assert not motion.a
    assert not motion.epsilon


def test_take_keeps_scene_and_numbers_together() -> None:
    motion = solve(four_bar(np.array([0.2, 0.21, 0.22]), 0.6, 0.5, 0.7, 1.0, 2.0, 3.0))
    part = motion.take(np.array([2, 0]))
    assert part.size == 2
    again = solve(part.scene)
    assert np.array_equal(again.v["B"], part.v["B"])


def test_verification_notices_a_wrong_joint(monkeypatch: pytest.MonkeyPatch) -> None:
    # Forget the Coriolis term: the independent computation must disagree.
    monkeypatch.setattr(Slot, "quadratic", lambda self, at, speeds: (0.0,))
    motion = solve(sleeve_on_crank(0.4, 0.2, 0.6, 0.3, 1.0, 2.0))
    assert recompute(motion).acceleration_error[0] > 1e-3


def test_verification_notices_a_wrong_number() -> None:
    motion = solve(FOUR_BAR)
    wrong = replace(motion, omega={**motion.omega, "BC": motion.omega["BC"] * (1 + 1e-5)})
    assert recompute(wrong).velocity_error[0] > 1e-6


def test_verification_of_a_batch_with_unsolvable_variants() -> None:
    # A dead point has a singular Jacobian; the ordinary variant beside it is verified all the same.
    motion = solve(four_bar(0.25, np.array([0.5, 0.75]), 0.25, 1.0, 0.0, 1.0, 1.0))
    again = recompute(motion)
    assert again.acceleration_error[1] < 1e-7
