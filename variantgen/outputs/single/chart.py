"""Curves over one abscissa as plain SVG, one panel below the other: for the display of a motion in a notebook."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape

import numpy as np
from msgspec import Struct

from variantgen.mechanism.motion import Field
from variantgen.outputs.motion.ranges import round_ticks, tick_texts, visible_range
from variantgen.wording.language import Language

# Pixels: the whole width, margins to the left and right of the curves, height of a panel, gap below it.
_WIDTH, _LEFT, _RIGHT, _HEIGHT, _GAP = 640.0, 70.0, 16.0, 96.0, 34.0
_MARKS_ACROSS, _MARKS_UP = 9, 5  # at most so many numbers on an axis


class ChartCurve(Struct, frozen=True):
    """A curve: its title with the unit, and its values, shape (K,); NaN where there is none."""

    title: str
    values: Field


class Abscissa(Struct, frozen=True):
    """What curves are drawn over: values of the shape (K,), a title, the index of the value that a line marks.

    ``angles``: degrees; ``bounded``: whether something stops the motion at the beginning and at the end, where values
    of curves may grow beyond all bounds.
    """

    values: Field
    title: str
    at: int
    angles: bool = False
    bounded: tuple[bool, bool] = (False, False)


def chart(abscissa: Abscissa, curves: Sequence[ChartCurve], language: Language) -> str:
    """The curves, each in a panel of its own; very large values near the ends are cut off."""
    height = len(curves) * (_HEIGHT + _GAP) + _GAP
    across = _Axis(float(np.min(abscissa.values)), float(np.max(abscissa.values)), _LEFT, _WIDTH - _RIGHT)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH:g} {height:g}" width="{_WIDTH:g}" role="img">',
        f"<title>{escape(', '.join(curve.title for curve in curves))} over {escape(abscissa.title)}</title>",
        f'<rect width="{_WIDTH:g}" height="{height:g}" fill="#fff"/>',
        '<g font-family="serif" font-size="12" fill="#1a1a1a" stroke="none">',
    ]
    for number, curve in enumerate(curves):
        low, high = _limits(curve.values, abscissa)
        top = number * (_HEIGHT + _GAP) + 22
        parts += _panel(abscissa, curve, across, _Axis(low, high, top + _HEIGHT, top), language)
    bottom = height - 6
    parts.append(
        f'<text x="{_WIDTH - _RIGHT:g}" y="{bottom:g}" text-anchor="end">{escape(abscissa.title)}</text></g></svg>'
    )
    return "\n".join(parts)


class _Axis(Struct, frozen=True):
    """Numbers from ``low`` to ``high`` between two places in pixels."""

    low: float
    high: float
    start: float
    end: float

    def at(self, value: float) -> float:
        return self.start + (value - self.low) / (self.high - self.low) * (self.end - self.start)

    def marks(self, most: int, language: Language, angles: bool = False) -> list[tuple[float, str]]:
        """Round numbers on the axis: where they are, and as they are written."""
        ticks = round_ticks(self.low, self.high, most, angles)
        return [(self.at(float(tick)), text) for tick, text in zip(ticks, tick_texts(ticks, language), strict=True)]


def _limits(values: Field, abscissa: Abscissa) -> tuple[float, float]:
    """What is shown of a curve: zero is always inside."""
    if not np.isfinite(values[abscissa.at]):
        return -1.0, 1.0
    low, high, _ = visible_range([values], abscissa.at, abscissa.bounded)
    low, high = min(low, 0.0), max(high, 0.0)
    room = 0.05 * (high - low) or 1.0  # a constant is not the edge of its panel
    return low - room, high + room


def _panel(abscissa: Abscissa, curve: ChartCurve, across: _Axis, up: _Axis, language: Language) -> Iterator[str]:
    top, base, width = up.end, up.start, across.end - across.start
    yield f'<text x="{_LEFT:g}" y="{top - 7:g}">{escape(curve.title)}</text>'
    yield f'<rect x="{_LEFT:g}" y="{top:g}" width="{width:g}" height="{_HEIGHT:g}" fill="none" stroke="#767676"/>'
    for x, text in across.marks(_MARKS_ACROSS, language, abscissa.angles):
        yield f'<path d="M{x:.1f} {base:g}v-4" stroke="#767676"/>'
        yield f'<text x="{x:.1f}" y="{base + 13:g}" text-anchor="middle" font-size="10">{text}</text>'
    for y, text in up.marks(_MARKS_UP, language):
        yield f'<path d="M{_LEFT:g} {y:.1f}h4" stroke="#767676"/>'
        yield f'<text x="{_LEFT - 5:g}" y="{y + 3.5:.1f}" text-anchor="end" font-size="10">{text}</text>'
    zero, now = up.at(0.0), across.at(float(abscissa.values[abscissa.at]))
    yield f'<path d="M{across.start:g} {zero:.1f}H{across.end:g}" stroke="#cfcfcf"/>'
    yield f'<path d="M{now:.1f} {top:g}v{_HEIGHT:g}" stroke="#595959" stroke-dasharray="4 3"/>'
    # A picture inside the picture cuts off what is beyond the panel.
    box = f"{_LEFT:g} {top:g} {width:g} {_HEIGHT:g}"
    yield f'<svg x="{_LEFT:g}" y="{top:g}" width="{width:g}" height="{_HEIGHT:g}" viewBox="{box}">'
    span = up.high - up.low
    drawn = " ".join(_steps(abscissa.values, np.clip(curve.values, up.low - span, up.high + span), across, up))
    yield f'<path d="{drawn}" fill="none" stroke="#0b57a4" stroke-width="1.6"/></svg>'


def _steps(abscissa: Field, values: Field, across: _Axis, up: _Axis) -> Iterator[str]:
    """The steps of a path; it is interrupted where there is no value."""
    moving = False
    for x, y in zip(abscissa.tolist(), values.tolist(), strict=True):
        if not np.isfinite(y):
            moving = False
            continue
        yield f"{'L' if moving else 'M'}{across.at(x):.1f} {up.at(y):.1f}"
        moving = True
