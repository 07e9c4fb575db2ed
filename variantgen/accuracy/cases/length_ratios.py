"""Length ratios of 1e-6 to 1e6 between any two links of a mechanism.

Where the two fixed pivots nearly coincide and one link is much shorter than the other two, the whole turns almost as
one body: the rates are well conditioned, but the closing equation is a small difference of large terms, and every way
that solves it for the rates loses digits. The largest error over (kappa eps) seen among 2000 four-bars was 43, the
median is below 0.1.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.random import Generator

from variantgen.accuracy.cases._shapes import chosen, grouped, rates, sides
from variantgen.accuracy.computed import CaseGroup
from variantgen.accuracy.textbook.four_bar import FourBar
from variantgen.accuracy.textbook.slider_crank import SliderCrank

TITLE = "length ratios"
ABOUT = "Lengths drawn evenly by their logarithm over a range of 1e2 to 1e6, sine of the angle > 0.05."
PLACE = 5


def groups(count: int, rng: Generator) -> list[CaseGroup]:
    """A group per range and mechanism."""
    return spanned(count, rng, (1.0, 1.5, 2.0, 2.5, 3.0))


def spanned(count: int, rng: Generator, spans: Sequence[float]) -> list[CaseGroup]:
    """A group per mechanism and ``span``: lengths of ``10**-span`` to ``10**span`` m."""
    each = max(1, count // len(spans))
    found = []
    for span in spans:
        label = f"ratios up to 1e{2 * span:.0f}"
        found.append(grouped(f"four-bar, {label}", _four_bars(rng, span, each), each, span=span))
        found.append(grouped(f"slider-crank, {label}", _slider_cranks(rng, span, each), each, span=span))
    return found


def _four_bars(rng: Generator, span: float, count: int) -> FourBar:
    def drawn() -> tuple[Any, ...]:
        phi = rng.uniform(0, 2 * np.pi)
        lengths = list(10 ** rng.uniform(-span, span, 4))
        lengths[rng.integers(4)] = 10.0**-span
        # Only a chain with two long links closes: one of the others is made about as long as the longest.
        order = np.argsort(lengths)
        lengths[order[-2]] = lengths[order[-1]] * rng.uniform(0.5, 1.5)
        return (*lengths, phi)

    def fits(a: float, b: float, c: float, d: float, phi: float) -> bool:
        f = abs(d - a * np.exp(1j * phi))
        high, low = max(b, c), min(b, c)
        area = (f + (high + low)) * (low - (f - high)) * (low + (f - high)) * (f + (high - low))
        return area > 0 and bool(np.sqrt(area) / (2 * b * c) > 0.05)

    a, b, c, d, phi = chosen(drawn, fits, count)
    return FourBar(a, b, c, d, phi, *rates(rng, count), sides(rng, count))


def _slider_cranks(rng: Generator, span: float, count: int) -> SliderCrank:
    def drawn() -> tuple[Any, ...]:
        a, b, height = 10 ** rng.uniform(-span, span, 3)
        return a, b, height * rng.choice([-1, 1]), rng.uniform(0, 2 * np.pi)

    def fits(a: float, b: float, height: float, phi: float) -> bool:
        return bool(abs(height - a * np.sin(phi)) / b < 0.998)

    a, b, height, phi = chosen(drawn, fits, count)
    return SliderCrank(a, b, height, phi, *rates(rng, count))
