"""Non-rotating body: it moves in translation."""

from __future__ import annotations

from variantgen.mechanism.arithmetic import Complex, Real
from variantgen.mechanism.component import BodyName
from variantgen.mechanism.joint import Joint
from variantgen.mechanism.rows import Placement, ScalarRow, Shape, Speeds


class Translation(Joint, frozen=True):
    """``phi = const``, ``omega = 0``, ``epsilon = 0``."""

    body: BodyName

    def shapes(self) -> tuple[Shape, ...]:
        """One scalar row on the body."""
        return (Shape(bodies=(self.body,)),)

    def rows(self, at: Placement) -> tuple[ScalarRow, ...]:
        """``omega = 0``."""
        return (ScalarRow({}, {self.body: 1.0}),)

    def quadratic(self, at: Placement, speeds: Speeds) -> tuple[Complex, ...]:
        """Nothing."""
        return (0.0,)

    def residual(self, moved: Placement, start: Placement, time: Real) -> tuple[Real, ...]:
        """The rotation since the start (rad)."""
        return (moved.turned[self.body],)
