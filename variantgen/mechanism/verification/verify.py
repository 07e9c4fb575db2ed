"""Independent check of a solved motion: Newton on the joint residuals, moved in time, differentiated numerically.

Nothing of the solver is used: no construction, no velocity row, no block. The unknowns are the displacements and
rotations of the rigid bodies since the instant of the problem; the equations are that shared points stay together
and that the residuals of joints and drivers vanish. The chain is closed again at times ``+-h, +-2h, +-3h`` and the
positions are differentiated by central differences of order six. Only the length of the step h takes a hint from the
solution (its fastest rotation), because it decides the accuracy of the check, not its result.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.mechanism.motion import ComplexField, Field, Motion, largest_change
from variantgen.mechanism.verification.closure_residuals import ClosureResiduals
from variantgen.mechanism.verification.invariants import (
    centre_consistent,
    coriolis_direction,
    equal_projections,
    rolling_contact_at_rest,
)

# Truncation grows as (h / R)^6 with R the way to the nearest dead point (about 0.3 rad in screened variants),
# rounding of the second derivative as eps / h^2; 0.004 rad balances them near 1e-10.
_STEP = 0.004
_OFFSETS = np.array([-3.0, -2.0, -1.0, 1.0, 2.0, 3.0])
_FIRST = np.array([-1.0, 9.0, -45.0, 45.0, -9.0, 1.0]) / 60.0
_SECOND = np.array([2.0, -27.0, 270.0, 270.0, -27.0, 2.0]) / 180.0
_ITERATIONS = 25
_NO_ACCELERATION = 0.01

Vector = NDArray[np.float64]


class Recomputed(Struct, frozen=True):
    """Velocities and accelerations by the independent way, and the difference from the solver's.

    ``velocity_error`` and ``acceleration_error``, shape (N,): the largest deviation of any point or body (rotations
    times the length of the mechanism), relative to the largest velocity or acceleration of the mechanism.
    """

    v: Mapping[str, ComplexField]
    a: Mapping[str, ComplexField]
    omega: Mapping[str, Field]
    epsilon: Mapping[str, Field]
    velocity_error: Field
    acceleration_error: Field


def recompute(motion: Motion) -> Recomputed:
    """Velocities and accelerations of a solved motion again, independently; all arrays of shape (N,).

    The entries of variants that are not solved have no meaning.
    """
    chain = ClosureResiduals(motion)
    h = _time_step(motion, chain.length)
    inverse = _inverse(np.where(motion.solved[:, None, None], chain.jacobian(), np.eye(chain.unknowns)))
    q = np.zeros((len(_OFFSETS), motion.size, chain.unknowns))
    times = _OFFSETS[:, None] * h
    size = np.inf
    for _ in range(_ITERATIONS):
        change = np.einsum("nij,knj->kni", inverse, chain.residual(q, times))
        q = q - change
        before, size = size, float(np.max(np.abs(change)))
        # Nothing is left but rounding: changes are within it, or no longer become less.
        if size < 1e-15 or (size < 1e-13 and size > 0.5 * before):
            break
    at = chain.placement(q)
    places = {name: at.z[name] - motion.z[name] for name in chain.material}
    turns = {body: np.asarray(at.turned[body]) for body in motion.scene.bodies}

    def derivative(table: Mapping[str, NDArray[Any]], weights: Vector, order: int) -> dict[str, NDArray[Any]]:
        return {name: np.tensordot(weights, values, axes=1) / h**order for name, values in table.items()}

    v, a = derivative(places, _FIRST, 1), derivative(places, _SECOND, 2)
    omega, epsilon = derivative(turns, _FIRST, 1), derivative(turns, _SECOND, 2)
    return Recomputed(
        v,
        a,
        omega,
        epsilon,
        largest_change(motion.v, v, motion.omega, omega, chain.length),
        largest_change(motion.a, a, motion.epsilon, epsilon, chain.length, _least_acceleration(motion, chain.length)),
    )


def _least_acceleration(motion: Motion, length: Field) -> Field:
    """What accelerations are compared with at least, a hundredth of ``v^2 / l``: a motion may have none at all."""
    speeds = [np.abs(v) for v in motion.v.values()] + [np.abs(x) * length for x in motion.omega.values()]
    fastest = np.max([np.zeros(motion.size), *speeds], axis=0)
    result: Field = _NO_ACCELERATION * fastest**2 / np.where(length > 0, length, 1.0)
    return result


def _inverse(matrices: Vector) -> Vector:
    """The inverses, shape (N, n, n); not numbers where a matrix is singular, so that nothing is confirmed by it."""
    try:
        return np.asarray(np.linalg.inv(matrices))
    except np.linalg.LinAlgError:
        regular = np.linalg.matrix_rank(matrices) == matrices.shape[-1]
        eye = np.eye(matrices.shape[-1])
        return np.where(regular[:, None, None], np.linalg.inv(np.where(regular[:, None, None], matrices, eye)), np.nan)


def _time_step(motion: Motion, length: Field) -> Field:
    """Time in which the fastest part turns by the step angle or moves by the like part of the mechanism's size."""
    rates = [np.abs(x) for x in motion.omega.values()] + [np.abs(v) / length for v in motion.v.values()]
    roots = [np.sqrt(np.abs(x)) for x in motion.epsilon.values()]
    fastest = np.max(rates + roots, axis=0)
    result: Field = _STEP / np.where(fastest > 0, fastest, 1.0)
    return result


def invariants(motion: Motion) -> Field:
    """Largest violation of the theorems that a student would use for a check, relative, shape (N,).

    Four of :mod:`variantgen.mechanism.verification.invariants`: equal projections, the velocity centre, the direction
    of Coriolis, no slip where bodies roll. They are exact but for rounding. The power balance is left out: it rests on
    the closing equations and on differences in time, as :func:`recompute` does, and would say less precisely what that
    says.
    """
    theorems = (equal_projections, centre_consistent, coriolis_direction, rolling_contact_at_rest)
    return np.asarray(np.max([theorem(motion) for theorem in theorems], axis=0))
