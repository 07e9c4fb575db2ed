"""The point where a straight piece of thread leaves a drum."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Flags
from variantgen.mechanism.component import Length, PointName, Radius, Side
from variantgen.mechanism.outcome import Outcome


def thread_direction(
    start: Complex, radius: Length, side: Side, end: Complex, end_radius: Length, end_side: Side
) -> tuple[Complex, Length, Flags]:
    """Unit vector, length (m) and existence of the straight piece of thread between two drums.

    The thread touches each drum on the given side of its way start -> end (left +1, right -1). With d the step
    between the centres, ``sin(turn) = (side*radius - end_side*end_radius) / |d|`` turns the line of centres into the
    thread; a point is a drum of radius zero.
    """
    step = end - start
    gap = np.abs(step)
    offset = side * radius - end_side * end_radius
    exists = gap > np.abs(offset)
    safe = np.where(exists, gap, 1.0)
    sine = np.where(exists, offset, 0.0) / safe
    cosine = np.sqrt((1.0 - sine) * (1.0 + sine))
    ray = np.where(exists, step, 1.0) / safe * (cosine - 1j * sine)
    return ray, safe * cosine, exists


class Tangent(Struct, frozen=True):
    """The tangent point on the drum (centre, radius) of a thread that runs to the drum (to, to_radius).

    ``z = z_centre + i * side * radius * u`` with u the direction of the thread, centre -> to; the sides count
    along that way. The tangent point at the far end is the same construction with the drums exchanged and both
    sides negated.
    """

    centre: PointName
    radius: Radius
    side: Side
    to: PointName
    to_radius: Radius = 0.0
    to_side: Side = 1.0
    failure: ClassVar[Outcome] = Outcome.DEGENERATE

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """Position (m) and whether the drums are far enough apart for a thread."""
        ray, _, exists = thread_direction(
            at[self.centre], self.radius, self.side, at[self.to], self.to_radius, self.to_side
        )
        return at[self.centre] + 1j * self.side * self.radius * ray, exists
