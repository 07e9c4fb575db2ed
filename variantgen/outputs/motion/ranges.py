"""Ranges and ticks of axes: what part of the values is shown, at which round numbers, how they are written."""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal

import numpy as np

from variantgen.mechanism.motion import Field
from variantgen.wording.language import Language

# Quantiles of the values, and how much taller than the span between them a curve may be to be shown whole; for ranges
# with an end, where values may grow without limit, the part of the range beside it that is not looked at.
_CORE, _TALL, _BEYOND, _NEAR_END = (0.03, 0.97), 5.0, 0.3, 0.07
_PAD = 0.07
_STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)
# Steps of angles (degrees) that divide a turn.
_ANGLE_STEPS = (1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0)


def visible_range(
    curves: Sequence[Field], at: int, bounded: tuple[bool, bool] = (False, False)
) -> tuple[float, float, bool]:
    """Lower and upper limit of an axis for some curves, shape (K,) each, and whether it cuts off very large values.

    The values at the index ``at`` are always inside. NaN counts as missing. ``bounded``: whether something
    stops the motion at the beginning and at the end, where the values may grow beyond all bounds.
    """
    ranges = [_range_of(curve, at, bounded) for curve in curves]
    low, high = min(r[0] for r in ranges), max(r[1] for r in ranges)
    whole_low, whole_high = min(float(np.nanmin(c)) for c in curves), max(float(np.nanmax(c)) for c in curves)
    pad = _PAD * (high - low)
    cut = whole_low < low - pad or whole_high > high + pad
    return low - pad, high + pad, cut


def _range_of(curve: Field, at: int, bounded: tuple[bool, bool]) -> tuple[float, float]:
    """What is shown of one curve."""
    trim = int(_NEAR_END * len(curve))
    middle = curve[trim * bounded[0] : len(curve) - trim * bounded[1]]
    whole, seen = curve[np.isfinite(curve)], middle[np.isfinite(middle)]
    low, high = (float(x) for x in ((seen.min(), seen.max()) if any(bounded) else np.quantile(seen, _CORE)))
    low, high = min(low, float(curve[at])), max(high, float(curve[at]))
    core, least, most = high - low, float(whole.min()), float(whole.max())
    if most - least <= (2.0 if any(bounded) else _TALL) * core:
        return least, most
    return max(least, low - _BEYOND * core), min(most, high + _BEYOND * core)


def round_ticks(low: float, high: float, most: int, angles: bool = False) -> list[Decimal]:
    """At most so many round numbers within the limits, evenly spaced; of angles (degrees) parts of a turn."""
    span = high - low
    power = math.floor(math.log10(span / most))
    steps = [Decimal(str(s)).scaleb(power + shift) for shift in (0, 1) for s in _STEPS]
    if angles and span > 8:
        steps = [Decimal(str(s)) for s in _ANGLE_STEPS] + [Decimal(180)]
    for step in steps:
        first, last = math.ceil(low / float(step) - 1e-9), math.floor(high / float(step) + 1e-9)
        if last - first < most:
            return [k * step for k in range(first, last + 1)]
    return []


def tick_texts(ticks: Sequence[Decimal], language: Language) -> list[str]:
    """The numbers at the ticks, all with the same number of decimals, with the decimal mark of the language."""
    places = max((-int(tick.normalize().as_tuple().exponent) for tick in ticks), default=0)
    texts = [f"{tick:.{max(places, 0)}f}" for tick in ticks]
    return [text.replace("-", "\N{MINUS SIGN}").replace(".", language.decimal_mark) for text in texts]
