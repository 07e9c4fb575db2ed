"""Which of the interchangeable methods a solution uses where several apply."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class MethodStyle:
    """The choice of methods for bodies in plane motion, by their names: for velocities and for accelerations.

    What the chosen method does not solve is left to the vector equation, with equal projections also to the velocity
    centre. A ``strict`` choice is a wished one: no shorter way takes its place.
    """

    velocities: str = "velocity_centre"
    accelerations: str = "acceleration_pole"
    strict: bool = False

    def at(self, order: int) -> str:
        """The method for velocities (1) or accelerations (2)."""
        return self.velocities if order == 1 else self.accelerations
