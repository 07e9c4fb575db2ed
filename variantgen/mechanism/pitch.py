"""Two circles that touch: the geometry of gears and of rolling on a circle."""

from __future__ import annotations

import numpy as np

from variantgen.mechanism.arithmetic import Complex, Flags, Real
from variantgen.mechanism.component import Length


def line_of_centres(centre: Complex, around: Complex, radius: Length, inside: bool) -> tuple[Complex, Real]:
    """The vector d from the centre of the second circle to that of the first, and k of the contact ``centre - k d``.

    ``k = radius/|d|`` for circles that touch from outside, ``-radius/|d|`` for a first circle inside the second.
    """
    d = centre - around
    distance = np.abs(d)
    # Without a distance there is no contact: k = 0 is what no circle has.
    k = np.where(distance > 0, radius, 0.0) / np.where(distance > 0, distance, 1.0)
    return d, -k if inside else k


def can_touch(k: Real, inside: bool) -> Flags:
    """Whether two circles with the number k of their line of centres touch: apart, and outside each smaller than d."""
    return np.isfinite(k) & (np.abs(k) > 0) & (inside | (k < 1.0))


def other_radius(distance: Length, radius: Length, inside: bool) -> Length:
    """The radius of the second of two circles that touch, from the distance of the centres and the first radius."""
    result: Real = distance + radius if inside else distance - radius
    return result
