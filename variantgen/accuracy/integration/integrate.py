"""Integration of the velocity equations by the solvers of scipy, with or without stabilisation of the closure."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.accuracy.integration.passage import Passage

METHODS = ("RK45", "DOP853", "Radau", "BDF", "LSODA")
IMPLICIT = ("Radau", "BDF")
STABILISATIONS = ("none", "Baumgarte", "projection")
# Multistep methods keep their history, which a projection would contradict.
_ONE_STEP = ("RK45", "DOP853", "Radau")
_PULL = 20.0  # of the crank's rate: how fast Baumgarte's term closes a gap


class TooLongError(ArithmeticError):
    """The integration needs more evaluations than it is given."""


class Trajectory(Struct, frozen=True):
    """States at the instants of a passage, shape (K, 2); ``evaluations`` of the velocity equations, ``drift`` of the
    closure (m): the largest gap at an instant; ``failed``: why it ends early, empty if it does not.
    """

    states: NDArray[np.float64]
    evaluations: int
    drift: float
    failed: str = ""


def possible(method: str, stabilisation: str) -> bool:
    """Whether a method can be stabilised in that way."""
    return stabilisation != "projection" or method in _ONE_STEP


def integrate(passage: Passage, method: str, tolerance: float, stabilisation: str, most: int) -> Trajectory:
    """From the start of a passage to its end with a relative and absolute tolerance of each step, by so many
    evaluations at most.
    """
    pull = _PULL * abs(passage.bar.omega) if stabilisation == "Baumgarte" else 0.0
    count = 0

    def slope(t: float, state: Any) -> NDArray[np.float64]:
        nonlocal count
        count += 1
        if count > most:
            raise TooLongError
        return np.array(passage.rates(t, state.tolist(), pull))

    project = passage.projected if stabilisation == "projection" else None
    try:
        states, failed = _stepped(passage, method, tolerance, slope, project)
    except TooLongError:
        return Trajectory(np.zeros((0, 2)), count, np.inf, "too long")
    except (ZeroDivisionError, ValueError, OverflowError, np.linalg.LinAlgError):
        return Trajectory(np.zeros((0, 2)), count, np.inf, "exception")
    drift = max((abs(passage.gap(t, y)) for t, y in zip(passage.instants, states, strict=False)), default=np.inf)
    return Trajectory(states, count, float(drift), failed)


def _stepped(
    passage: Passage,
    method: str,
    tolerance: float,
    slope: Callable[[float, Any], NDArray[np.float64]],
    project: Callable[[float, Any], Any] | None,
) -> tuple[NDArray[np.float64], str]:
    """States at the instants, by the interpolation of each step."""
    kind = getattr(importlib.import_module("scipy.integrate"), method)
    solver = kind(slope, 0.0, np.array(passage.start), passage.duration, rtol=tolerance, atol=tolerance)
    found: list[Any] = []
    while solver.status == "running":
        solver.step()
        if solver.status == "failed":
            return np.array(found).reshape(-1, 2), "no convergence"
        trajectory = solver.dense_output()
        while len(found) < len(passage.instants) and passage.instants[len(found)] <= solver.t:
            t = float(passage.instants[len(found)])
            found.append(project(t, trajectory(t)) if project else trajectory(t))
        if project:
            solver.y = np.array(project(solver.t, solver.y))
            solver.f = slope(solver.t, solver.y)
    return np.array(found).reshape(-1, 2), ""
