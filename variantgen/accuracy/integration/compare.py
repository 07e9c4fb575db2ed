"""Errors and times of all ways to follow a passage: direct evaluation at the instants, integration to each of them."""

from __future__ import annotations

import math
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from msgspec import Struct

from variantgen.accuracy.computed import Computed
from variantgen.accuracy.integration.integrate import METHODS, STABILISATIONS, Trajectory, integrate, possible
from variantgen.accuracy.integration.passage import Passage
from variantgen.accuracy.norms import deviation
from variantgen.accuracy.precise import exact_number, many_digits
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.solving.structure import analyse

DIRECT = "direct evaluation"
_SHORT = 0.1  # seconds
_LEAST = 1e-14  # scipy takes no smaller tolerances than about a hundred roundings


class PassageErrors(Struct, frozen=True):
    """How well a passage was followed: largest relative errors at its instants, seconds for the whole.

    ``tolerance`` and ``evaluations`` are zero for direct evaluation. ``drift``: largest gap of the closed chain, of
    the size of the mechanism. ``failed``: empty, or why there is no result.
    """

    passage: str
    method: str
    stabilisation: str
    tolerance: float
    seconds: float
    evaluations: int
    position: float
    velocity: float
    drift: float
    failed: str


def follow(passage: Passage, tolerances: Sequence[float], most: int, rounds: int) -> Iterator[PassageErrors]:
    """Every way; integrations of at most so many evaluations. Direct evaluation is timed in so many rounds."""
    yield _direct(passage, rounds)
    for method in METHODS:
        for stabilisation in STABILISATIONS:
            if not possible(method, stabilisation):
                continue
            for tolerance in tolerances:
                with warnings.catch_warnings(), np.errstate(all="ignore"):
                    warnings.simplefilter("ignore")
                    trajectory, seconds = _timed(passage, method, max(tolerance, _LEAST), stabilisation, most)
                yield _assessed(passage, method, stabilisation, tolerance, trajectory, seconds)
                if trajectory.failed == "too long":
                    break


def _timed(passage: Passage, method: str, tolerance: float, stabilisation: str, most: int) -> tuple[Trajectory, float]:
    """The integration and its seconds; short ones are repeated, the least time counts."""
    times: list[float] = []
    while True:
        start = time.perf_counter()
        trajectory = integrate(passage, method, tolerance, stabilisation, most)
        times.append(time.perf_counter() - start)
        if sum(times) > _SHORT or len(times) == 3:
            return trajectory, min(times)


def _direct(passage: Passage, rounds: int) -> PassageErrors:
    """All instants as one batch of the solver."""
    plan = analyse(passage.bar.scene())
    action: Callable[[], Any] = lambda: solve(passage.scene(), 1, plan)  # noqa: E731
    motion = action()
    times = []
    for _ in range(max(1, rounds)):
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    every = Computed(motion.z, motion.v, {}, motion.omega, {})
    found = [every.one(i) for i in range(motion.size)]
    position, velocity = _errors(passage, found)
    failed = "" if motion.solved.all() else "refused"
    return PassageErrors(passage.title, DIRECT, "none", 0.0, min(times), 0, position, velocity, 0.0, failed)


def _assessed(
    passage: Passage, method: str, stabilisation: str, tolerance: float, trajectory: Trajectory, seconds: float
) -> PassageErrors:
    failed = trajectory.failed
    if not failed and not np.all(np.isfinite(trajectory.states)):
        failed = "not a number"
    if not failed and len(trajectory.states) < len(passage.instants):
        failed = "no convergence"
    if not failed and any(math.sin(psi - theta) * passage.bar.side < 0 for theta, psi in trajectory.states):
        failed = "wrong branch"
    position, velocity = (math.nan, math.nan)
    if not failed:
        at = zip(passage.instants, trajectory.states, strict=True)
        position, velocity = _errors(passage, [_of_state(passage, t, y) for t, y in at])
    size = float(passage.exact[0].size)
    return PassageErrors(
        passage.title, method, stabilisation, tolerance, seconds, trajectory.evaluations, position, velocity,
        trajectory.drift / size, failed,
    )  # fmt: skip


def _of_state(passage: Passage, t: float, state: Any) -> Computed:
    """Places and velocities of a state: B by the crank and the coupler."""
    bar, (theta, psi) = passage.bar, state
    tip = bar.a * np.exp(1j * (bar.phi + bar.omega * t))
    w2, w3 = passage.rates(t, state)
    rocker = bar.c * np.exp(1j * psi)
    return Computed(
        {"A": tip, "B": tip + bar.b * np.exp(1j * theta)},
        {"A": 1j * bar.omega * tip, "B": 1j * w3 * rocker},
        {},
        {"OA": bar.omega, "AB": w2, "BC": w3},
        {},
    )


def _errors(passage: Passage, found: Sequence[Computed]) -> tuple[float, float]:
    """Largest relative errors of positions and velocities at the instants."""
    worst = [0.0, 0.0]
    with many_digits():
        for result, exact in zip(found, passage.exact, strict=True):
            gaps = deviation(result.each(exact_number), exact)
            worst = [max(w, float(g)) for w, g in zip(worst, gaps[:2], strict=True)]
    return worst[0], worst[1]
