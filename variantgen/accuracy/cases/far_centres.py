"""The velocity centre of the coupler goes to infinity: crank and rocker nearly parallel."""

from __future__ import annotations

from typing import Any

import numpy as np
from msgspec.structs import astuple
from numpy.random import Generator

from variantgen.accuracy.cases._shapes import chosen, grouped, rates
from variantgen.accuracy.computed import CaseGroup
from variantgen.accuracy.textbook.four_bar import FourBar
from variantgen.accuracy.textbook.slider_crank import SliderCrank

TITLE = "velocity centre to infinity"
ABOUT = "Crank and rocker 1e-1 to 1e-14 rad from parallel (crank and normal of the guide of a slider-crank)."
PLACE = 3


def groups(count: int, rng: Generator) -> list[CaseGroup]:
    """A group per angle and mechanism."""
    angles = [10.0**-k for k in (1, 2, 4, 6, 8, 10, 12, 14)]
    each = max(1, count // len(angles))
    found = []
    for angle in angles:
        found.append(grouped(f"four-bar, {angle:.0e} rad", _parallel(rng, angle, each), each, angle=angle))
        a, b = rng.uniform(0.1, 0.4, each), rng.uniform(0.5, 1.0, each)
        upright = SliderCrank(a, b, rng.uniform(-0.2, 0.2, each), 0.5 * np.pi - angle, *rates(rng, each))
        upright = SliderCrank(*(np.broadcast_to(x, each) for x in astuple(upright)))
        found.append(grouped(f"slider-crank, {angle:.0e} rad", upright, each, angle=angle))
    return found


def _parallel(rng: Generator, angle: float, count: int) -> FourBar:
    """Four-bars whose rocker makes that angle with the crank."""

    def drawn() -> tuple[Any, ...]:
        a, c = rng.uniform(0.1, 0.5, 2)
        d = rng.uniform(0.8, 1.5)
        phi = rng.uniform(0.5, 2.6)
        end = d + c * np.exp(1j * (phi + angle))
        return a, abs(end - a * np.exp(1j * phi)), c, d, phi, _side(a * np.exp(1j * phi), end, d)

    def fits(a: float, b: float, c: float, d: float, phi: float, _: float) -> bool:
        tip, end = a * np.exp(1j * phi), d + c * np.exp(1j * (phi + angle))
        sine = np.imag(np.conj(end - tip) * (end - d)) / (b * c)
        return bool(abs(sine) > 0.3)

    a, b, c, d, phi, side = chosen(drawn, fits, count)
    return FourBar(a, b, c, d, phi, *rates(rng, count), side)


def _side(tip: complex, end: complex, base: float) -> float:
    return float(np.sign(np.imag(np.conj(base - tip) * (end - tip))))
