"""Near dead points: coupler and rocker, or rod and normal of the guide, nearly in line."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator

from variantgen.accuracy.cases._shapes import chosen, grouped, rates, sides
from variantgen.accuracy.computed import CaseGroup
from variantgen.accuracy.textbook.four_bar import FourBar
from variantgen.accuracy.textbook.slider_crank import SliderCrank

TITLE = "near dead points"
ABOUT = "The angle between coupler and rocker (rod and normal of the guide) is 1e-1 to 1e-8 rad, within a third."
PLACE = 1

_ANGLES = tuple(10.0**-k for k in range(1, 9))


def groups(count: int, rng: Generator) -> list[CaseGroup]:
    """A group per angle and mechanism."""
    each = max(1, count // len(_ANGLES))
    found = []
    for angle in _ANGLES:
        found.append(grouped(f"four-bar, {angle:.0e} rad", toggling(rng, angle, each), each, angle=angle))
        found.append(grouped(f"slider-crank, {angle:.0e} rad", _upright(rng, angle, each), each, angle=angle))
    return found


def toggling(rng: Generator, angle: float, count: int) -> FourBar:
    """Four-bars with that angle between coupler and rocker, folded or stretched; rounding of d shifts it."""

    def drawn() -> tuple[Any, ...]:
        a, b, c = rng.uniform(0.1, 1.0, 3)
        phi = rng.uniform(0.3, np.pi - 0.3) * rng.choice([-1, 1])
        folded = rng.choice([-1.0, 1.0])
        half = np.sin(0.5 * angle)
        # Law of cosines in the form (b -+ c)^2 +- 4 b c sin^2(angle/2), which does not cancel.
        square = (b - folded * c) ** 2 + folded * 4 * b * c * half * half
        room = square - (a * np.sin(phi)) ** 2
        return a, b, c, a * np.cos(phi) + np.sqrt(max(room, 0.0)), phi

    def fits(a: float, b: float, c: float, d: float, phi: float) -> bool:
        sine = _sine_exactly(a, b, c, d, phi)
        return d > 0.05 and 0.7 * angle < sine < 1.3 * angle

    a, b, c, d, phi = chosen(drawn, fits, count)
    return FourBar(a, b, c, d, phi, *rates(rng, count), sides(rng, count))


def _sine_exactly(a: float, b: float, c: float, d: float, phi: float) -> float:
    """Sine of the angle between coupler and rocker, to many digits before it is rounded; -1 if there is none."""
    from variantgen.accuracy.precise import many_digits

    with many_digits(50) as mp:
        p, q, r, s = (mp.mpf(float(x)) for x in (a, b, c, d))
        cosine = (q**2 + r**2 - (p**2 + s**2 - 2 * p * s * mp.cos(mp.mpf(float(phi))))) / (2 * q * r)
        return float(mp.sqrt(1 - cosine**2)) if abs(cosine) < 1 else -1.0


def _upright(rng: Generator, angle: float, count: int) -> SliderCrank:
    """Slider-cranks with that angle between rod and normal of the guide."""

    def drawn() -> tuple[Any, ...]:
        a, b = rng.uniform(0.1, 1.0, 2)
        phi = rng.uniform(0.3, 1.2) + rng.integers(4) * np.pi / 2
        return a, b, a * np.sin(phi) + rng.choice([-1.0, 1.0]) * b * np.cos(angle), phi

    def fits(a: float, b: float, height: float, phi: float) -> bool:
        from variantgen.accuracy.precise import many_digits

        with many_digits(50) as mp:
            p, q, h, f = (mp.mpf(float(x)) for x in (a, b, height, phi))
            sine = (h - p * mp.sin(f)) / q
            cosine = float(mp.sqrt(1 - sine**2)) if abs(sine) < 1 else -1.0
        return 0.7 * angle < cosine < 1.3 * angle

    a, b, height, phi = chosen(drawn, fits, count)
    return SliderCrank(a, b, height, phi, *rates(rng, count))
