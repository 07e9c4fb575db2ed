"""Velocities of the points as linear forms in the unknowns, accelerations as the same forms with quadratic terms.

Every point is reached by a step from its pole; each step is worked out once and used for all equations and points.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Real
from variantgen.mechanism.rows import Row, ScalarRow, VectorRow
from variantgen.mechanism.solving.linear import ScaledEquation
from variantgen.mechanism.solving.structure import (
    Closure,
    Equation,
    FreePoint,
    GivenPoint,
    GuidedPoint,
    Plan,
    RigidPoint,
    Step,
)

LinearForm: TypeAlias = dict[int, Complex]
Rows: TypeAlias = list[tuple[Row, ...]]
RightHandSide: TypeAlias = tuple[Real, Real]


class _PoleStep(Struct, frozen=True):
    """What a step adds: ``form``, the velocity of its point less that of its pole by unknown; ``arm`` (m), from the
    pole to the point where both belong to a body.
    """

    form: LinearForm
    arm: Complex = 0.0


def _pole_step(step: Step, rows: Rows, z: Mapping[str, Complex], plan: Plan) -> _PoleStep:
    match step:
        case RigidPoint(point, body, pole):
            arm = z[point] - z[pole]
            return _PoleStep({plan.omega[body]: 1j * arm}, arm)
        case GivenPoint(_, constraint, number, _):
            row = rows[constraint][number]
            assert isinstance(row, VectorRow)
            return _PoleStep({plan.omega[body]: c for body, c in row.bodies.items()})
        case GuidedPoint(point, constraint, number, unknown, _):
            row = rows[constraint][number]
            assert isinstance(row, ScalarRow)
            return _PoleStep({unknown: -1j * row.points[point]})
        case FreePoint(_, x, y, _):
            return _PoleStep({x: 1.0, y: 1.0j})


class VelocityForms:
    """The velocities of the points of a placed scene as linear forms."""

    def __init__(self, plan: Plan, rows: Rows, z: Mapping[str, Complex]) -> None:
        self.plan, self._rows = plan, rows
        closures = [equation.step for equation in plan.equations if isinstance(equation, Closure)]
        self._reached = {step: _pole_step(step, rows, z, plan) for step in dict.fromkeys((*plan.steps, *closures))}
        self._forms: dict[str, LinearForm] = {}
        for step in plan.steps:
            self._forms[step.point] = self._form(step)
        self._closed: dict[Step, tuple[LinearForm, dict[int, Real]]] = {}

    def arm(self, step: Step) -> Complex:
        """From the pole to the point of a step along a body (m)."""
        return self._reached[step].arm

    def _form(self, step: Step) -> LinearForm:
        """The velocity of the point of a step, through its pole."""
        form = dict(self._forms[step.pole]) if step.pole else {}
        for unknown, coefficient in self._reached[step].form.items():
            form[unknown] = form[unknown] + coefficient if unknown in form else coefficient
        return form

    def _closing(self, step: GivenPoint | RigidPoint) -> tuple[LinearForm, dict[int, Real]]:
        """The first expression for the velocity of a point less the second one; sizes before cancellation."""
        if step not in self._closed:
            form = dict(self._forms[step.point])
            sizes = {unknown: np.abs(c) for unknown, c in form.items()}
            for unknown, c in self._form(step).items():
                form[unknown] = form[unknown] - c if unknown in form else -c
                sizes[unknown] = sizes[unknown] + np.abs(c) if unknown in sizes else np.abs(c)
            self._closed[step] = form, sizes
        return self._closed[step]

    def equation(self, equation: Equation) -> ScaledEquation:
        """Coefficients of one equation by unknown, and their size before cancellation."""
        if isinstance(equation, Closure):
            form, sizes = self._closing(equation.step)
            part = np.imag if equation.part else np.real
            return ScaledEquation({unknown: part(c) for unknown, c in form.items()}, sizes)
        coefficients: dict[int, Real] = {}
        magnitudes: dict[int, Real] = {}

        def add(unknown: int, value: Real, size: Real) -> None:
            coefficients[unknown] = coefficients[unknown] + value if unknown in coefficients else value
            magnitudes[unknown] = magnitudes[unknown] + size if unknown in magnitudes else size

        row = self._rows[equation.constraint][equation.row]
        assert isinstance(row, ScalarRow)
        for point, weight in row.points.items():
            for unknown, c in self._forms[point].items():
                product = np.conj(weight) * c
                add(unknown, np.real(product), np.abs(product))
        for body, k in row.bodies.items():
            add(self.plan.omega[body], k, np.abs(k))
        return ScaledEquation(coefficients, magnitudes)

    def points(self, values: Mapping[int, Real], drifts: QuadraticTerms | None = None) -> dict[str, Complex]:
        """Velocities (or, with the quadratic terms, accelerations) of the points, pole by pole."""
        found: dict[str, Complex] = {}
        for step in self.plan.steps:
            total: Complex = found[step.pole] if step.pole else 0.0
            for unknown, c in self._reached[step].form.items():
                total = total + c * values[unknown]
            found[step.point] = total + drifts.own(step) if drifts else total
        return found


class QuadraticTerms:
    """The quadratic parts of the accelerations, for known velocities: ``extra`` are the terms of the constraints."""

    def __init__(
        self, velocities: VelocityForms, rows: Rows, extra: list[tuple[Complex, ...]], omega: Mapping[str, Real]
    ) -> None:
        self._velocities, self._rows, self._extra = velocities, rows, extra
        self._squares = {body: -(rate**2) for body, rate in omega.items()}
        self._own: dict[Step, Complex] = {}
        self._whole: dict[str, Complex] = {}
        for step in velocities.plan.steps:
            self._whole[step.point] = self._through(step)
        self._closed: dict[Step, tuple[Complex, Real]] = {}

    def own(self, step: Step) -> Complex:
        """What a step adds: ``-omega^2 arm`` along a body, the term of the constraint where that leads the point.

        Of a point that slides on a curved guide: its normal acceleration ``-(v^2 / d) e``, from ``e.a + v^2 / d = 0``.
        """
        if step not in self._own:
            match step:
                case RigidPoint(_, body, _):
                    self._own[step] = self._squares[body] * self._velocities.arm(step)
                case GivenPoint(_, constraint, number, _):
                    self._own[step] = self._extra[constraint][number]
                case GuidedPoint(point, constraint, number, _, _) if np.any(self._extra[constraint][number]):
                    row = self._rows[constraint][number]
                    assert isinstance(row, ScalarRow)
                    self._own[step] = -np.real(self._extra[constraint][number]) * row.points[point]
                case _:
                    self._own[step] = 0.0
        return self._own[step]

    def _through(self, step: Step) -> Complex:
        """The whole quadratic part of the acceleration of the point of a step, through its pole."""
        return self.own(step) + self._whole[step.pole] if step.pole else self.own(step)

    def _closing(self, step: GivenPoint | RigidPoint) -> tuple[Complex, Real]:
        """The second expression for the quadratic part of a point less the first one; size before cancellation."""
        if step not in self._closed:
            again, known = self._through(step), self._whole[step.point]
            self._closed[step] = again - known, np.abs(again) + np.abs(known)
        return self._closed[step]

    def side(self, equation: Equation, rate: Real) -> RightHandSide:
        """Right-hand side of an equation for accelerations with its prescribed ``rate``, and the size of its terms."""
        if isinstance(equation, Closure):
            gap, size = self._closing(equation.step)
            return np.imag(gap) if equation.part else np.real(gap), size
        row = self._rows[equation.constraint][equation.row]
        assert isinstance(row, ScalarRow)
        term = np.real(self._extra[equation.constraint][equation.row])
        total, size = rate - term, np.abs(rate) + np.abs(term)
        for point, weight in row.points.items():
            product = np.conj(weight) * self._whole[point]
            total, size = total - np.real(product), size + np.abs(product)
        return total, size
