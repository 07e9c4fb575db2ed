"""The curves of a figure for the typesetting engine: for PDF one image, elsewhere one by one.

Each curve by itself would take the engine three times as long as an image with all of them. Places x, y in whole
hundredths of a figure unit u, y down; the paper under labels comes last.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import islice
from typing import Any

import numpy as np

from variantgen.figure.curves import DASHES, Curve, curves, papers
from variantgen.figure.drawing import Drawing

_STEPS = {"M": "M%d %d", "L": "L%d %d", "C": "C%d %d %d %d %d %d", "Z": "Z"}
_INKS = {"ink": "#000000", "paper": "#ffffff", "shade": "#ebebeb"}
_BEYOND = 2  # u; figure.typ says the same


class FigureCurves:
    """The curves of a drawing."""

    def __init__(self, drawing: Drawing) -> None:
        self._width, self._height = round(drawing.width, 2), round(drawing.height, 2)
        drawn = [*curves(drawing.lines), *papers(drawing.labels)]
        points = [point for curve in drawn for _, ends in curve.steps for point in ends]
        places = iter(_hundredths(points, drawing.height))
        self._paths = [(curve, _path(curve, places)) for curve in drawn]

    def one_by_one(self) -> list[Any]:
        """Weight, fill, dashes and the path of each curve, as SVG writes it."""
        return [[curve.weight, curve.fill, DASHES[curve.dash], path] for curve, path in self._paths]

    @cached_property
    def image(self) -> str:
        """An image with all curves, as SVG. It reaches a little beyond the figure, so that nothing is cut off."""
        width, height = self._width + 2 * _BEYOND, self._height + 2 * _BEYOND
        found = [
            f"<svg xmlns='http://www.w3.org/2000/svg' width='{width:.10g}' height='{height:.10g}' viewBox="
            f"'-{100 * _BEYOND} -{100 * _BEYOND} {100 * width:.10g} {100 * height:.10g}'>"
            "<g fill='none' stroke='#000' stroke-linecap='round' stroke-linejoin='round'>"
        ]
        for curve, path in self._paths:
            fill = f"' fill='{_INKS[curve.fill]}" if curve.fill else ""
            stroke = f"-width='{100 * curve.weight:.10g}" if curve.weight else "='none"
            dash = (
                "' stroke-dasharray='" + " ".join([f"{100 * d:.10g}" for d in DASHES[curve.dash]]) if curve.dash else ""
            )
            found.append(f"<path d='{path}{fill}' stroke{stroke}{dash}'/>")
        return "".join([*found, "</g></svg>"])


def _path(curve: Curve, places: Iterator[int]) -> str:
    """The steps of a curve with the next places."""
    form = "".join([_STEPS[kind] for kind, _ in curve.steps])
    return form % tuple(islice(places, form.count("%")))


def _hundredths(points: Sequence[complex], height: float) -> list[int]:
    """Coordinates in turn, y down from a height."""
    at = np.array(points, dtype=complex)
    found: list[int] = np.rint(100 * np.stack((at.real, height - at.imag), axis=-1)).astype(int).ravel().tolist()
    return found
