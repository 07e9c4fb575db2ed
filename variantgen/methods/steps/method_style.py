"""Which of the interchangeable methods a solution uses where several apply."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Velocities = Literal["velocity_centre", "projections", "pole", "three_rates"]
Accelerations = Literal["pole", "acceleration_centre", "three_rates"]


@dataclass(frozen=True, slots=True)
class MethodStyle:
    """The choice of methods for bodies in plane motion.

    ``velocities``: by the velocity centre, by equal projections (and what these do not give by the velocity centre), or
    by the vector equation with a pole. ``accelerations`` of points of a body whose rates are known: by the vector
    equation with a pole, or by the acceleration centre. ``three_rates``, for both, solves the chains of three links
    between fixed pivots in coordinates and the rest by the vector equation.
    """

    velocities: Velocities = "velocity_centre"
    accelerations: Accelerations = "pole"
