"""Ordinary proportions, from which the classes of cases depart."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.random import Generator

from variantgen.accuracy.computed import CaseGroup, Textbook
from variantgen.accuracy.textbook.four_bar import FourBar
from variantgen.accuracy.textbook.slider_crank import SliderCrank

# Between coupler and rocker, rod and guide's normal: sines below this are for the class of dead points.
_OPEN = 0.35


def grouped(label: str, textbook: Textbook, size: int, **notes: float) -> CaseGroup:
    """A group of a textbook mechanism."""
    return CaseGroup(label, textbook.scene(), size, textbook, notes)


def sides(rng: Generator, count: int) -> Any:
    """+1 and -1 at random."""
    return rng.choice([-1.0, 1.0], count)


def rates(rng: Generator, count: int) -> tuple[Any, Any]:
    """Omega of 1 to 5 rad/s of either sense, epsilon of 1 to 10 rad/s^2 of either sense."""
    return rng.uniform(1, 5, count) * sides(rng, count), rng.uniform(1, 10, count) * sides(rng, count)


def four_bars(rng: Generator, count: int) -> FourBar:
    """Four-bars with lengths of 0.1 to 1 m whose coupler and rocker make an angle of a sine above 0.35."""

    def drawn() -> tuple[Any, ...]:
        a, b, c, d = rng.uniform(0.1, 1.0, 4)
        return a, b, c, d, rng.uniform(0, 2 * np.pi)

    def fits(a: float, b: float, c: float, d: float, phi: float) -> bool:
        square = a * a + d * d - 2 * a * d * np.cos(phi)
        cosine = (b * b + c * c - square) / (2 * b * c)
        return bool(abs(cosine) < np.sqrt(1 - _OPEN**2))

    a, b, c, d, phi = chosen(drawn, fits, count)
    return FourBar(a, b, c, d, phi, *rates(rng, count), sides(rng, count))


def slider_cranks(rng: Generator, count: int) -> SliderCrank:
    """Slider-cranks whose rod makes an angle with the normal of the guide of a sine above 0.35."""

    def drawn() -> tuple[Any, ...]:
        a, b = rng.uniform(0.1, 1.0, 2)
        return a, b, rng.uniform(-0.3, 0.3), rng.uniform(0, 2 * np.pi)

    def fits(a: float, b: float, height: float, phi: float) -> bool:
        return bool(abs(height - a * np.sin(phi)) / b < np.sqrt(1 - _OPEN**2))

    a, b, height, phi = chosen(drawn, fits, count)
    return SliderCrank(a, b, height, phi, *rates(rng, count))


def chosen(drawn: Callable[[], tuple[Any, ...]], fits: Callable[..., bool], count: int) -> list[Any]:
    """So many draws that fit, as columns."""
    found: list[tuple[Any, ...]] = []
    while len(found) < count:
        draw = drawn()
        if fits(*draw):
            found.append(draw)
    return [np.array(column) for column in zip(*found, strict=True)]
