"""Prescribed rotation of a body."""

from __future__ import annotations

from dataclasses import dataclass

from variantgen.mechanism.arithmetic import Complex, Real
from variantgen.mechanism.component import AngularAcceleration, AngularVelocity, BodyName
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


@dataclass(frozen=True)
class Rotation:
    """``omega_body = omega``, ``epsilon_body = epsilon`` (scene frame; a mirrored scene turns the other way)."""

    body: BodyName
    omega: AngularVelocity
    epsilon: AngularAcceleration = 0.0

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the body."""
        return (Shape(bodies=(self.body,)),)

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """``sense * omega_body = omega`` with the sense of the frame."""
        return (ScalarRow({}, {self.body: at.frame.sense}),)

    def rates(self, order: int) -> tuple[Real, ...]:
        """Omega (rad/s) or epsilon (rad/s^2)."""
        return (self.omega if order == 1 else self.epsilon,)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Nothing."""
        return (0.0,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Rotation less ``omega t + epsilon t^2 / 2`` (rad)."""
        wanted = (self.omega + 0.5 * self.epsilon * time) * time
        return (start.frame.sense * moved.turned[self.body] - wanted,)
