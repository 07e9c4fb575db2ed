"""Condition numbers: how much more the result changes, relatively, than the numbers that the scene is given by."""

from __future__ import annotations

from typing import Any

from msgspec import Struct

from variantgen.accuracy.norms import deviation
from variantgen.accuracy.precise import mpmath
from variantgen.accuracy.reference.exact_scene import data, perturbed
from variantgen.accuracy.reference.motion import ExactSolution, solve_exactly
from variantgen.mechanism.scene import Scene

_CHANGE = 25  # decimal places of the relative change of a number


class ConditionNumbers(Struct, frozen=True):
    """``kappa = sum over the data d of |d| |dy/dd| / |y|`` for positions, velocities, accelerations; at least 1."""

    position: float
    velocity: float
    acceleration: float


def condition(scene: Scene, solution: ExactSolution) -> ConditionNumbers:
    """Condition numbers of the solution of an exact scene.

    Each length, angle, ratio and rate is changed by 1e-25 of itself and the scene solved again, to many digits.
    """
    change = mpmath().mpf(10) ** -_CHANGE
    totals: list[Any] = [0, 0, 0]
    for datum in data(scene):
        moved = solve_exactly(perturbed(scene, datum, 1 + change), near=solution).exact
        for k, gap in enumerate(deviation(moved, solution.exact)):
            totals[k] += gap / change
    return ConditionNumbers(*(max(1.0, float(total)) for total in totals))
