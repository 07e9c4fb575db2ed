"""Numerical differentiation: the chain is closed again a little earlier and later, and places are differentiated.

Places are those of the production; the chain is closed by Newton's method on the residuals (see verify.py).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from msgspec import Struct

from variantgen.accuracy.computed import CaseGroup, Computed
from variantgen.mechanism.motion import Motion
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.solving.structure import analyse
from variantgen.mechanism.verification.closure_residuals import ClosureResiduals

_ITERATIONS = 25


class Stencil(Struct, frozen=True):
    """Central differences: offsets in steps, weights for the first and the second derivative, the step (rad)."""

    offsets: tuple[float, ...]
    first: tuple[float, ...]
    second: tuple[float, ...]
    step: float


def differentiated(group: CaseGroup, stencil: Stencil) -> Callable[[], Computed]:
    """A function that differentiates a batch; the step of time takes a hint from the solution, as in verify.py."""
    plan = analyse(group.scene)
    solution = solve(group.scene, 2, plan)
    h = _time_step(solution, stencil.step)
    return lambda: _run(solve(group.scene, 0, plan), stencil, h)


def _run(motion: Motion, stencil: Stencil, h: Any) -> Computed:
    chain = ClosureResiduals(motion)
    inverse = np.linalg.inv(np.where(motion.solved[:, None, None], chain.jacobian(), np.eye(chain.unknowns)))
    q = np.zeros((len(stencil.offsets), motion.size, chain.unknowns))
    times = np.array(stencil.offsets)[:, None] * h
    last = np.zeros(motion.size)
    for _ in range(_ITERATIONS):
        change = np.einsum("nij,knj->kni", inverse, chain.residual(q, times))
        q = q - change
        last = np.max(np.abs(change), axis=(0, 2))
        if np.max(last) < 1e-15:
            break
    at = chain.placement(q)

    def derivative(values: Any, weights: tuple[float, ...], order: int) -> Any:
        return np.tensordot(np.array(weights), values, axes=1) / h**order

    places = {name: at.z[name] - motion.z[name] for name in chain.material}
    turns = {body: np.asarray(at.turned[body]) for body in motion.scene.bodies}
    return Computed(
        motion.z,
        {name: derivative(x, stencil.first, 1) for name, x in places.items()},
        {name: derivative(x, stencil.second, 2) for name, x in places.items()},
        {name: derivative(x, stencil.first, 1) for name, x in turns.items()},
        {name: derivative(x, stencil.second, 2) for name, x in turns.items()},
        refused=~motion.solved,
        lost=~(last < 1e-9),
    )


def _time_step(motion: Motion, angle: float) -> Any:
    """Time in which the fastest part turns by the angle, or moves by the like part of the mechanism's size."""
    length = motion.length_scale()
    rates = [np.abs(x) for x in motion.omega.values()] + [np.abs(v) / length for v in motion.v.values()]
    fastest = np.max(rates + [np.sqrt(np.abs(x)) for x in motion.epsilon.values()], axis=0)
    return angle / np.where(fastest > 0, fastest, 1.0)
