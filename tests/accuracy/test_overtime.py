"""Passages: integration of the velocity equations against direct evaluation and the reference."""

from __future__ import annotations

import math

import numpy as np
import pytest

from variantgen.accuracy.integration.compare import DIRECT, follow
from variantgen.accuracy.integration.integrate import METHODS, integrate, possible
from variantgen.accuracy.integration.passage import Passage, passing, turning


@pytest.fixture(scope="module")
def turn() -> Passage:
    return turning(1, 5)


def test_rates_are_those_of_the_reference(turn: Passage) -> None:
    exact, t = turn.exact[0], turn.instants[0]
    tip, end = complex(exact.z["A"]), complex(exact.z["B"])
    state = np.angle(end - tip), np.angle(end - turn.bar.d)
    assert abs(turn.gap(t, state)) < 1e-15
    assert turn.rates(t, state) == pytest.approx((float(exact.omega["AB"]), float(exact.omega["BC"])))


def test_projection_closes_the_chain(turn: Passage) -> None:
    theta, psi = turn.start
    state = turn.projected(0.0, (theta + 1e-4, psi - 2e-4))
    assert abs(turn.gap(0.0, state)) < 1e-12


@pytest.mark.parametrize("method", METHODS)
def test_integration_converges_to_direct_evaluation(method: str, turn: Passage) -> None:
    results = {r.tolerance: r for r in follow(turn, (1e-4, 1e-8), 5_000, 1) if r.method in (method, DIRECT)
               and r.stabilisation == "none"}  # fmt: skip
    assert results[0.0].velocity < 1e-14
    assert not results[1e-8].failed
    assert results[1e-8].velocity < 1e-5
    assert results[1e-8].velocity < 0.1 * results[1e-4].velocity


def test_stabilised_chains_stay_closed(turn: Passage) -> None:
    drift = {kind: integrate(turn, "RK45", 1e-6, kind, 5_000).drift for kind in ("none", "Baumgarte", "projection")}
    assert drift["projection"] < 1e-14 < drift["Baumgarte"] < drift["none"]
    assert not possible("BDF", "projection")


def test_integration_stops_when_it_takes_too_long(turn: Passage) -> None:
    assert integrate(turn, "RK45", 1e-12, "none", 50).failed == "too long"


def test_passing_the_pivot_is_as_fast_as_the_gap_is_small() -> None:
    passage = passing(1e-3, 8)
    fastest = max(abs(float(exact.omega["BC"])) for exact in passage.exact)
    assert fastest == pytest.approx(passage.bar.omega / 1e-3, rel=0.01)
    assert math.log10(passage.stiffness()) > 2
