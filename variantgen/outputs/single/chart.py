"""Curves over one abscissa as plain SVG, one panel below the other: for the display of a motion in a notebook."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from html import escape

import numpy as np

from variantgen.mechanism.motion import Field

# Pixels: the whole width, margins to the left and right of the curves, height of a panel, gap below it.
_WIDTH, _LEFT, _RIGHT, _HEIGHT, _GAP = 640.0, 70.0, 16.0, 96.0, 34.0
_MARKS = 5  # about so many numbers on an axis


@dataclass(frozen=True)
class ChartCurve:
    """A curve: its title with the unit, and its values, shape (K,); NaN where there is none."""

    title: str
    values: Field


def chart(abscissa: Field, title: str, curves: Sequence[ChartCurve], instant: float) -> str:
    """The curves over an abscissa of the shape (K,) with its ``title``, and a dashed line at one place of it."""
    height = len(curves) * (_HEIGHT + _GAP) + _GAP
    low, high = float(np.min(abscissa)), float(np.max(abscissa))
    across = _Axis(low, high, _LEFT, _WIDTH - _RIGHT)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH:g} {height:g}" width="{_WIDTH:g}" role="img">',
        f"<title>{escape(', '.join(curve.title for curve in curves))} over {escape(title)}</title>",
        f'<rect width="{_WIDTH:g}" height="{height:g}" fill="#fff"/>',
        '<g font-family="serif" font-size="12" fill="#1a1a1a" stroke="none">',
    ]
    for number, curve in enumerate(curves):
        parts += _panel(abscissa, curve, across, number * (_HEIGHT + _GAP) + 22, instant)
    bottom = height - 6
    parts.append(f'<text x="{_WIDTH - _RIGHT:g}" y="{bottom:g}" text-anchor="end">{escape(title)}</text></g></svg>')
    return "\n".join(parts)


@dataclass(frozen=True)
class _Axis:
    """Numbers from ``low`` to ``high`` between two places in pixels."""

    low: float
    high: float
    start: float
    end: float

    def at(self, value: float) -> float:
        return self.start + (value - self.low) / (self.high - self.low) * (self.end - self.start)

    def marks(self) -> list[float]:
        """Round numbers on the axis: of a full turn in degrees its quarters."""
        rough = (self.high - self.low) / _MARKS
        power = 10.0 ** np.floor(np.log10(rough))
        steps = [90.0] if 300 < self.high - self.low <= 400 else [k * power for k in (1, 2, 5, 10)]
        step = next((step for step in steps if step >= rough), steps[-1])
        first = np.ceil(self.low / step - 1e-9) * step
        return [float(value) + 0.0 for value in np.arange(first, self.high + 1e-9 * step, step)]


def _panel(abscissa: Field, curve: ChartCurve, across: _Axis, top: float, instant: float) -> Iterator[str]:
    known = curve.values[np.isfinite(curve.values)]
    least, most = (float(np.min(known)), float(np.max(known))) if known.size else (0.0, 0.0)
    least, most = min(least, 0.0), max(most, 0.0)
    room = 0.05 * (most - least) or 1.0
    up = _Axis(least - room, most + room, top + _HEIGHT, top)
    yield f'<text x="{_LEFT:g}" y="{top - 7:g}">{escape(curve.title)}</text>'
    yield (
        f'<rect x="{_LEFT:g}" y="{top:g}" width="{across.end - across.start:g}" height="{_HEIGHT:g}" fill="none"'
        ' stroke="#767676"/>'
    )
    for mark in across.marks():
        x, base = across.at(mark), top + _HEIGHT
        yield f'<path d="M{x:.1f} {base:g}v-4" stroke="#767676"/>'
        yield f'<text x="{x:.1f}" y="{base + 13:g}" text-anchor="middle" font-size="10">{mark:g}</text>'
    for mark in up.marks():
        y = up.at(mark)
        yield f'<path d="M{_LEFT:g} {y:.1f}h4" stroke="#767676"/>'
        yield f'<text x="{_LEFT - 5:g}" y="{y + 3.5:.1f}" text-anchor="end" font-size="10">{mark:g}</text>'
    zero, now = up.at(0.0), across.at(instant)
    yield f'<path d="M{across.start:g} {zero:.1f}H{across.end:g}" stroke="#cfcfcf"/>'
    yield f'<path d="M{now:.1f} {top:g}v{_HEIGHT:g}" stroke="#595959" stroke-dasharray="4 3"/>'
    drawn = " ".join(_steps(abscissa, curve.values, across, up))
    yield f'<path d="{drawn}" fill="none" stroke="#0b57a4" stroke-width="1.6"/>'


def _steps(abscissa: Field, values: Field, across: _Axis, up: _Axis) -> Iterator[str]:
    """The steps of a path; it is interrupted where there is no value."""
    moving = False
    for x, y in zip(abscissa.tolist(), values.tolist(), strict=True):
        if not np.isfinite(y):
            moving = False
            continue
        yield f"{'L' if moving else 'M'}{across.at(x):.1f} {up.at(y):.1f}"
        moving = True
