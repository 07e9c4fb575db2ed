"""A point at given distances from two points: closes a dyad of two links."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np
from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Flags, Real, unit_towards
from variantgen.mechanism.component import PointName, Side, Size
from variantgen.mechanism.outcome import Outcome


def sixteen_area_squared(a: Real, b: Real, c: Real) -> Real:
    """``16 S^2`` of the triangle with sides a, b, c (m^4); negative when there is no such triangle.

    Kahan's form ``(a+(b+c)) (c-(a-b)) (c+(a-b)) (a+(b-c))`` with a >= b >= c loses no digits to cancellation even for
    needle triangles (W. Kahan, "Miscalculating Area and Angles of a Needle-like Triangle", 2014).
    """
    high, low = np.maximum(a, b), np.minimum(a, b)
    top, rest = np.maximum(high, c), np.minimum(high, c)
    middle, bottom = np.maximum(rest, low), np.minimum(rest, low)
    result: Real = (
        (top + (middle + bottom)) * (bottom - (top - middle)) * (bottom + (top - middle)) * (top + (middle - bottom))
    )
    return result


class CircleCircle(Struct, frozen=True):
    """The point at ``first_distance`` from ``first`` and ``second_distance`` from ``second``.

    With d the distance of the centres and u the unit vector first -> second::

        z = z_first + (x + i*side*h) u,   x = (d + (r1 - r2)(r1 + r2)/d) / 2,   h = 2 S / d

    where S is the area of the triangle (r1, r2, d). ``side`` is left (+1) or right (-1) of the way first -> second.
    """

    first: PointName
    first_distance: Size
    second: PointName
    second_distance: Size
    side: Side
    failure: ClassVar[Outcome] = Outcome.NOT_ASSEMBLED
    chooses: ClassVar[str] = "side"  # which number, 1 or -1, chooses between its two solutions

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """Position (m) and whether the circles meet."""
        start, r1, r2 = at[self.first], self.first_distance, self.second_distance
        step = at[self.second] - start
        d = np.abs(step)
        ray, apart = unit_towards(start, at[self.second])
        area = sixteen_area_squared(r1, r2, d)
        meets = apart & (area >= 0)
        safe = np.where(apart, d, 1.0)
        x = 0.5 * (d + (r1 - r2) * (r1 + r2) / safe)
        h = 0.5 * np.sqrt(np.where(meets, area, 0.0)) / safe
        return start + (x + 1j * self.side * h) * ray, meets
