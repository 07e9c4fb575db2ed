"""Prescribed rotation of a body, or of a body relative to another one."""

from __future__ import annotations

from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Real
from variantgen.mechanism.component import AngularAcceleration, AngularVelocity, BodyName
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


class Rotation(Struct, frozen=True):
    """``omega_body = omega``, ``epsilon_body = epsilon`` (scene frame; a mirrored scene turns the other way).

    With ``relative_to`` the difference to that body is prescribed: ``omega_body - omega_other = omega`` and so on.
    """

    body: BodyName
    omega: AngularVelocity
    epsilon: AngularAcceleration = 0.0
    relative_to: BodyName | None = None

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the body or the two bodies."""
        return (Shape(bodies=(self.body,) if self.relative_to is None else (self.body, self.relative_to)),)

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """``sense * omega_body = omega`` with the sense of the frame."""
        turning = {self.body: at.frame.sense}
        if self.relative_to is not None:
            turning[self.relative_to] = -at.frame.sense
        return (ScalarRow({}, turning),)

    def rates(self, order: int) -> tuple[Real, ...]:
        """Omega (rad/s) or epsilon (rad/s^2)."""
        return (self.omega if order == 1 else self.epsilon,)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Nothing."""
        return (0.0,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """Rotation less ``omega t + epsilon t^2 / 2`` (rad)."""
        wanted = (self.omega + 0.5 * self.epsilon * time) * time
        turned = moved.turned[self.body]
        if self.relative_to is not None:
            turned = turned - moved.turned[self.relative_to]
        return (start.frame.sense * turned - wanted,)
