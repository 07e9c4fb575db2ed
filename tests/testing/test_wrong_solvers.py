"""Solvers of others: right ones pass, and deliberately wrong ones are caught by the theorem that they break."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import Phase, given, settings

from tests.testing.own_solvers import four_bar, slotted_arm
from variantgen.mechanism.motion import Field, Motion
from variantgen.testing import (
    centre_consistent,
    coriolis_direction,
    equal_projections,
    mirror,
    parameters,
    power_balance_of_constraints,
    scaling,
    time_reversal,
    variants,
)
from variantgen.variants.variant import Variant

SLOTTED = variants("slotted_rocker", form="swinging")
FOUR_BARS = variants("four_bar", form="crank")
OF_ONE = (equal_projections, centre_consistent, coriolis_direction, power_balance_of_constraints)

Solver = Callable[[dict[str, float]], Motion]
Check = Callable[[Solver, Variant], Field]


def of_one(theorem: Callable[[Motion], Field]) -> Check:
    return lambda solver, variant: theorem(solver(parameters(variant)))


def of_scaling(solver: Solver, variant: Variant) -> Field:
    one, other = (solver(parameters(variant, length, time)) for length, time in ((1.0, 1.0), (30.0, 0.2)))
    return scaling(one, other, 30.0, 0.2)


def of_reversal(solver: Solver, variant: Variant) -> Field:
    # A variant's omega is positive with a sense of its own: backwards in time that is the other sense.
    there = parameters(variant)
    return time_reversal(solver(there), solver({**there, "sense": -there["sense"]}))


def mirrored(p: dict[str, float]) -> dict[str, float]:
    """The data of a four-bar seen in a mirror along its base."""
    return {**p, "phi": -p["phi"], "sense": -p["sense"], "epsilon_OA": -p["epsilon_OA"], "side": -p["side"]}


def of_mirror(solver: Solver, variant: Variant) -> Field:
    there = parameters(variant)
    return mirror(solver(there), solver(mirrored(there)))


def breaks(check: Check, solver: Solver, strategy: object) -> bool:
    """Whether Hypothesis finds a variant on which a check fails."""

    @settings(phases=[Phase.generate], max_examples=30)  # the simplest such variant is not looked for
    @given(strategy)  # type: ignore[arg-type]
    def holds(variant: Variant) -> None:
        assert check(solver, variant).max() < 1e-7

    try:
        holds()
    except AssertionError:
        return True
    return False


@given(SLOTTED)
def test_the_right_solver_of_the_slotted_arm(variant: Variant) -> None:
    own, program = slotted_arm(parameters(variant)), variant.motion()
    assert all(theorem(own).max() < 1e-8 for theorem in OF_ONE)
    assert of_scaling(slotted_arm, variant).max() < 1e-9
    assert of_reversal(slotted_arm, variant).max() < 1e-9
    assert abs(own.epsilon["CB"][0]) == pytest.approx(abs(program.epsilon["CB"][0]))
    assert abs(own.a["B"][0]) == pytest.approx(abs(program.a["B"][0]))


@given(FOUR_BARS)
def test_the_right_solver_of_the_four_bar(variant: Variant) -> None:
    own, program = four_bar(parameters(variant)), variant.motion()
    assert all(theorem(own).max() < 1e-8 for theorem in OF_ONE)
    assert max(check(four_bar, variant).max() for check in (of_scaling, of_reversal, of_mirror)) < 1e-9
    assert abs(own.a["B"][0]) == pytest.approx(abs(program.a["B"][0]))


@pytest.mark.parametrize("factor", [0.0, 0.5, -1.0])
def test_coriolis_forgotten_halved_or_turned_the_other_way_is_caught(factor: float) -> None:
    def wrong(p: dict[str, float]) -> Motion:
        return slotted_arm(p, factor)

    assert breaks(of_one(coriolis_direction), wrong, SLOTTED)
    # Velocities are right, and what is proportional stays so: no other theorem sees it.
    for check in (*map(of_one, (equal_projections, centre_consistent)), of_scaling, of_reversal):
        assert not breaks(check, wrong, SLOTTED)


def test_a_branch_that_is_always_the_same_is_caught_in_the_mirror() -> None:
    def wrong(p: dict[str, float]) -> Motion:
        return four_bar(p, "always")

    assert breaks(of_mirror, wrong, FOUR_BARS)
    assert not breaks(of_one(equal_projections), wrong, FOUR_BARS)


def test_velocities_of_the_other_branch_are_caught() -> None:
    def wrong(p: dict[str, float]) -> Motion:
        return four_bar(p, "velocities")

    for theorem in (equal_projections, centre_consistent, power_balance_of_constraints):
        assert breaks(of_one(theorem), wrong, FOUR_BARS)


def test_a_batch_goes_through_at_once() -> None:
    """Arrays of many variants, of which one is wrong."""
    import variantgen

    found = variantgen.batch("slotted_rocker", 50, form="swinging")
    right = found.motion
    assert coriolis_direction(right).max() < 1e-12
    assert coriolis_direction(right).shape == (50,)
    right.a["A"][17] += 3j * right.v["A"][17]
    assert np.flatnonzero(coriolis_direction(right) > 1e-6).tolist() == [17]
