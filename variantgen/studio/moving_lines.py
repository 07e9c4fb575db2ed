"""Lines and places of a film as data for the page Play: paths of SVG with their pens.

Places are in figure units (u), x to the right and y down, as SVG counts.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from variantgen.figure.curves import curves
from variantgen.figure.drawing import Line
from variantgen.mechanism.motion import ComplexField
from variantgen.outputs.figures.svg import path_data

_MARGIN = 8.0  # about the picture, u


def _xy(z: complex) -> list[float]:
    return [round(z.real, 2) + 0.0, round(-z.imag, 2) + 0.0]


def places(z: ComplexField) -> list[list[float] | None]:
    """Places of the shape (K,) by x and y; None for one that is not finite."""
    return [_xy(place) if np.isfinite(place) else None for place in z.tolist()]


def polyline(z: ComplexField) -> str:
    """A path through places of the shape (K,); it begins anew after one that is not finite."""
    parts, begun = [], False
    for place in z.tolist():
        if np.isfinite(place):
            x, y = _xy(place)
            parts.append(f"{'L' if begun else 'M'}{x} {y}")
        begun = bool(np.isfinite(place))
    return "".join(parts)


def pen(data: str, weight: float = 0.45, fill: str = "", dash: str = "") -> dict[str, Any]:
    """The data of a path with its pen."""
    return {"d": data, "weight": weight, "fill": fill, "dash": dash}


def drawn(lines: Iterable[Line]) -> list[dict[str, Any]]:
    """Lines as paths with their pens, back to front."""
    return [pen(path_data(c), c.weight, c.fill, c.dash) for c in curves(sorted(lines, key=lambda line: line.layer))]


def frames_of(frames: Sequence[Sequence[Line]]) -> dict[str, Any]:
    """The pens of all positions, back to front, and for each position the path of each pen."""
    joined = [curves(sorted(lines, key=lambda line: line.layer)) for lines in frames]
    pens = list(dict.fromkeys(curve[:4] for lines in joined for curve in lines))
    pens.sort(key=lambda key: key[0])
    found = []
    for lines in joined:
        data = {curve[:4]: path_data(curve) for curve in lines}
        found.append([data.get(key, "") for key in pens])
    named = [{"layer": int(layer), "weight": weight, "fill": fill, "dash": dash} for layer, weight, fill, dash in pens]
    return {"pens": named, "frames": found}


def box_about(lines: Iterable[Line], others: Sequence[ComplexField]) -> list[float]:
    """Left, top, width and height of a picture with these lines and places, of the shape (K,) each."""
    own = [p for curve in curves(lines) for _, points in curve.steps for p in points]
    every = np.concatenate([np.array(own, dtype=np.complex128), *others])
    left, right = float(every.real.min()) - _MARGIN, float(every.real.max()) + _MARGIN
    low, high = float(every.imag.min()) - _MARGIN, float(every.imag.max()) + _MARGIN
    return [round(value, 2) for value in (left, -high, right - left, high - low)]
