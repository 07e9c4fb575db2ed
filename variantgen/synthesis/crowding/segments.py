"""Distances and crossings of points and bars, by the places of points: complex numbers, or arrays of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np

Bar: TypeAlias = tuple[str, str]  # a segment by its ends


def off(z: Mapping[str, Any], name: str, bar: Bar) -> Any:
    """How far a point is from a segment; numbers or arrays."""
    start, step = z[bar[0]], z[bar[1]] - z[bar[0]]
    part = ((z[name] - start) / step).real
    part = min(max(part, 0.0), 1.0) if isinstance(part, float) else np.clip(part, 0.0, 1.0)
    return abs(z[name] - start - part * step)


def cross(z: Mapping[str, Any], one: Bar, other: Bar) -> Any:
    """Whether two segments cross; numbers or arrays."""
    a, b, c, d = (z[name] for name in (*one, *other))

    def side(p: Any, q: Any, r: Any) -> Any:
        return ((q - p).conjugate() * (r - p)).imag

    return (side(a, b, c) * side(a, b, d) < 0) & (side(c, d, a) * side(c, d, b) < 0)
