"""Which of the interchangeable methods a solution uses where several apply."""

from __future__ import annotations

from msgspec import Struct


class MethodStyle(Struct, frozen=True):
    """The choice of methods for bodies in plane motion, by their names: for velocities and for accelerations.

    What the chosen method does not solve is left to the vector equation, with equal projections also to the velocity
    centre. A ``strict`` choice is a wished one: no shorter way takes its place. Without ``shortcuts`` none does either:
    the tolerance of answers is that of the usual, longer way, which a student may go.
    """

    velocities: str = "velocity_centre"
    accelerations: str = "acceleration_pole"
    strict: bool = False
    shortcuts: bool = True

    @property
    def is_free(self) -> bool:
        """Whether a shorter way that only some mechanisms allow may take the place of the usual one."""
        return self.shortcuts and not self.strict

    def at(self, order: int) -> str:
        """The method for velocities (1) or accelerations (2)."""
        return self.velocities if order == 1 else self.accelerations
