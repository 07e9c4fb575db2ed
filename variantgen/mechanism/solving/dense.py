"""The whole mechanism as one linear system per variant: all constraint equations differentiated, solved at once.

This is the coordinate method in numbers. The unknowns are the velocities of all material points and the angular
velocities of all bodies; the equations are that bodies are rigid and that the rows of joints and drivers hold.
Nothing of the solver's order, poles and blocks is used.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from msgspec import Struct

from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.mechanism.rows import Placement, ScalarRow, Speeds, VectorRow
from variantgen.mechanism.scene import Scene


class Rates(Struct, frozen=True):
    """Velocities or accelerations of points (complex) and bodies, shape (N,) each."""

    points: Mapping[str, ComplexField]
    bodies: Mapping[str, Field]


class DenseSystem:
    """The equations of a placed batch; ``solve(1)`` gives velocities, ``solve(2)`` accelerations.

    Lengths are in units of the mechanism's size, so that all unknowns are angular. Raises numpy.linalg.LinAlgError
    where a variant is exactly at a dead point.
    """

    def __init__(self, motion: Motion) -> None:
        self.motion = motion
        scene = motion.scene
        self.length = motion.length_scale()
        self.points = material_points(scene)
        self.columns = {name: 2 * i for i, name in enumerate(self.points)}
        self.turns = {body: 2 * len(self.points) + i for i, body in enumerate(scene.bodies)}
        self.size = 2 * len(self.points) + len(scene.bodies)
        self._equations: list[dict[int, Any]] = []
        self._collect()
        self._matrix = np.zeros((motion.size, self.size, self.size))
        for number, equation in enumerate(self._equations):
            for column, value in equation.items():
                self._matrix[:, number, column] = value

    def _collect(self) -> None:
        scene, z = self.motion.scene, self.motion.z
        for body, members in scene.bodies.items():
            for point in members[1:]:
                arm = (z[point] - z[members[0]]) / self.length
                for part, turned in enumerate((arm.imag, -arm.real)):
                    equation: dict[int, Any] = {self.columns[point] + part: 1.0, self.columns[members[0]] + part: -1.0}
                    equation[self.turns[body]] = turned
                    self._equations.append(equation)
        at = Placement(z, scene.frame)
        for constraint in scene.constraints:
            for row, shape in zip(constraint.rows(at), constraint.shapes(), strict=True):
                if isinstance(row, ScalarRow):
                    self._equations.append(self._scalar(row))
                else:
                    self._equations += self._vector(row, shape.pole)

    def _scalar(self, row: ScalarRow) -> dict[int, Any]:
        equation: dict[int, Any] = {}
        for point, weight in row.points.items():
            column = self.columns[point]
            equation[column] = equation.get(column, 0.0) + weight.real
            equation[column + 1] = equation.get(column + 1, 0.0) + weight.imag
        # Of a row of angles alone nothing is divided; in the others the arms are in units of the size.
        scale = self.length if row.points else 1.0
        for body, weight in row.bodies.items():
            equation[self.turns[body]] = weight / scale
        return equation

    def _vector(self, row: VectorRow, pole: str | None) -> list[dict[int, Any]]:
        found = []
        for part in (0, 1):
            equation: dict[int, Any] = {self.columns[row.point] + part: 1.0}
            if pole is not None:
                equation[self.columns[pole] + part] = -1.0
            for body, weight in row.bodies.items():
                equation[self.turns[body]] = -(weight.imag if part else weight.real) / self.length
            found.append(equation)
        return found

    def solve(self, order: int, speeds: Rates | None = None) -> Rates:
        """Velocities (order 1), or accelerations (2) from the velocities ``speeds`` of an earlier solution."""
        right = np.zeros((self.motion.size, self.size, 1))
        for number, value in enumerate(self._sides(order, speeds)):
            right[:, number, 0] = value
        found = np.linalg.solve(self._matrix, right)[:, :, 0]
        last = 2 * len(self.points)
        vectors = self.length[:, None] * (found[:, 0:last:2] + 1j * found[:, 1:last:2])
        return Rates(
            dict(zip(self.points, vectors.T, strict=True)), dict(zip(self.turns, found[:, last:].T, strict=True))
        )

    def _sides(self, order: int, speeds: Rates | None) -> list[Any]:
        """Right-hand sides in the order of the equations, velocities of points in units of the size."""
        scene, z = self.motion.scene, self.motion.z
        sides: list[Any] = []
        for body, members in scene.bodies.items():
            for point in members[1:]:
                arm = (z[point] - z[members[0]]) / self.length
                drift = -(speeds.bodies[body] ** 2) * arm if speeds else np.zeros_like(arm)
                sides += [drift.real, drift.imag]
        at = Placement(z, scene.frame)
        known = Speeds(speeds.points, speeds.bodies) if speeds else None
        for constraint in scene.constraints:
            extra = constraint.quadratic(at, known) if known else tuple(0.0 for _ in constraint.shapes())
            for row, rate, term in zip(constraint.rows(at), constraint.rates(order), extra, strict=True):
                if isinstance(row, ScalarRow):
                    sides.append((rate - term.real) / (self.length if row.points else 1.0))
                else:
                    sides += [term.real / self.length, term.imag / self.length]
        return sides


def material_points(scene: Scene) -> list[str]:
    """Points of bodies and points that a joint or driver acts on, in the order of the scene."""
    named = {point for members in scene.bodies.values() for point in members}
    named |= {point for c in scene.constraints for shape in c.shapes() for point in shape.points}
    return [point for point in scene.points if point in named]
