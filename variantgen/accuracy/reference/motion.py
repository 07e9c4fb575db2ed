"""Velocities and accelerations of one variant to many digits: the coefficients of the displacements as power series.

The linear systems for q1 and q2 have the Jacobian of the residuals, found by differences with a step of 1e-30; repeated
until what is left of each order vanishes to all digits, so the step has no influence on the result.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from msgspec import Struct

from variantgen.accuracy.precise import mpmath
from variantgen.accuracy.reference.checked_positions import check_substituted, on_paper, positions
from variantgen.accuracy.reference.closure_equations import ClosureEquations
from variantgen.accuracy.reference.linear import Factors
from variantgen.accuracy.reference.series import Series, series
from variantgen.mechanism.scene import Scene

_STEP = 30  # decimal places of the step of differences
_LEFT = 1e-50  # of the largest rate: what the residuals of each order may leave open
_ROUNDS = 12


class ExactMotion(Struct, frozen=True):
    """The motion of one variant in numbers of mpmath; units and signs as in :class:`~..mechanism.motion.Motion`.

    ``size`` is the largest distance of a point from the middle of all points (m); ``places`` are in the scene's frame.
    """

    places: Mapping[str, Any]
    z: Mapping[str, Any]
    v: Mapping[str, Any]
    a: Mapping[str, Any]
    omega: Mapping[str, Any]
    epsilon: Mapping[str, Any]
    size: Any


class ExactSolution(Struct, frozen=True):
    """The exact motion with what it takes to find that of a neighbouring scene: unknowns and factors."""

    exact: ExactMotion
    terms: tuple[list[Any], list[Any]]
    factors: Factors


def solve_exactly(
    scene: Scene, near: ExactSolution | None = None, guess: Mapping[str, Any] | None = None
) -> ExactSolution:
    """The motion of an exact scene (see :func:`~.exact_scene.exact_scene`).

    ``near``: the solution of a scene that differs very little, from which this one is found by corrections. Raises
    NoSuchPointError where it does not assemble, ZeroDivisionError at a dead point, ArithmeticError where the residuals
    do not vanish.
    """
    at = positions(scene, near.exact.places if near else None)
    z = on_paper(scene, at)
    if near is None:
        check_substituted(scene, at)
        closing = ClosureEquations(scene, z, _size(z))
        factors = Factors(_jacobian(closing))
        zero = [mpmath().mpf(0)] * closing.unknowns
        first, second = zero, zero
    else:
        factors, (first, second) = near.factors, near.terms
        closing = ClosureEquations(scene, z, near.exact.size)
    rounds = 1 if near else _ROUNDS
    q1 = _corrected(closing, factors, [first], rounds)
    q2 = _corrected(closing, factors, [q1, second], rounds)
    return ExactSolution(_exact(closing, at, z, q1, q2), (q1, q2), factors)


def _corrected(closing: ClosureEquations, factors: Factors, terms: Sequence[list[Any]], rounds: int) -> list[Any]:
    """The last of the terms such that the residual of its order vanishes; with one round only corrected."""
    order = len(terms)
    time = Series((mpmath().mpf(0), mpmath().mpf(1), *[mpmath().mpf(0)] * (order - 1)))
    q = list(terms[-1])
    for _ in range(rounds):
        known = zip(*terms[:-1], q, strict=True)
        left = [r.term(order) for r in closing.residual([Series((mpmath().mpf(0), *group)) for group in known], time)]
        change = factors.solve(left)
        q = [x - d for x, d in zip(q, change, strict=True)]
        most = max((abs(x) for x in q), default=0)
        if max((abs(d) for d in change), default=0) <= _LEFT * most:
            return q
    if rounds > 1:
        raise ArithmeticError("the residuals of the reference do not vanish")
    return q


def _jacobian(closing: ClosureEquations) -> list[list[Any]]:
    """Derivatives of the residuals by the displacements, by differences."""
    mp = mpmath()
    step = mp.mpf(10) ** -_STEP
    still = series(0)
    zero = [still] * closing.unknowns
    base = closing.residual(zero, still)
    columns = []
    for k in range(closing.unknowns):
        moved = closing.residual([*zero[:k], series(step), *zero[k + 1 :]], still)
        columns.append([(after.value - before.value) / step for after, before in zip(moved, base, strict=True)])
    return [list(row) for row in zip(*columns, strict=True)]


def _exact(
    closing: ClosureEquations, at: Mapping[str, Any], z: Mapping[str, Any], q1: Sequence[Any], q2: Sequence[Any]
) -> ExactMotion:
    zero = mpmath().mpf(0)
    moved = closing.placement([Series((zero, x, y)) for x, y in zip(q1, q2, strict=True)])
    material = [*closing.home, *closing.single]
    return ExactMotion(
        at,
        z,
        {name: moved.z[name].term(1) for name in material},
        {name: 2 * moved.z[name].term(2) for name in material},
        {body: turn.term(1) for body, turn in moved.turned.items()},
        {body: 2 * turn.term(2) for body, turn in moved.turned.items()},
        closing.size,
    )


def _size(z: Mapping[str, Any]) -> Any:
    middle = sum(z.values()) / len(z)
    return max(abs(place - middle) for place in z.values())
