"""Lines of a drawing on axes of matplotlib whose coordinates are figure units."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from variantgen.figure.drawing import Arc, Line, Path, Strokes

_FILLS = {"": "none", "paper": "white", "ink": "black", "shade": "0.9"}
_DASHES: dict[str, Any] = {"": "-", "dashed": (0, (4, 2)), "dashdot": (0, (7, 2, 1, 2))}
_THINNEST, _LARGEST = 0.35, 2.6  # points; points per u from which on lines do not get thicker


def points_per_unit(axes: Any) -> float:
    """Printer's points per u."""
    box, (low, high) = axes.get_position(), axes.get_xlim()
    return float(72 * box.width * axes.figure.get_size_inches()[0] / (high - low))


def draw_lines(axes: Any, lines: Iterable[Line], above: float = 2.0) -> list[Any]:
    """Draw lines in their order of layers, with weights to scale; returns what was added, to be removed again.

    The limits of the axes must be set before.
    """
    points = min(_LARGEST, points_per_unit(axes))
    added = []
    for line in sorted(lines, key=lambda line: line.layer):
        weight = max(_THINNEST, line.weight * points) if line.weight else 0.0
        added.append(_draw(axes, line, weight, above + 0.5 * int(line.layer)))
    return added


def _draw(axes: Any, line: Line, width: float, order: float) -> Any:
    """One line of a width in points."""
    from matplotlib.collections import LineCollection
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path as Outline

    match line:
        case Strokes(segments):
            pairs = [[(a.real, a.imag), (b.real, b.imag)] for a, b in segments]
            return axes.add_collection(
                LineCollection(pairs, colors="black", linewidths=width, zorder=order), autolim=False
            )
        case Path(points):
            places = [*points, points[0]] if line.closed else list(points)
            codes = [Outline.MOVETO] + [Outline.LINETO] * (len(points) - 1) + [Outline.CLOSEPOLY] * line.closed
        case Arc():
            places = [line.at(0), *(place for piece in line.cubics() for place in piece)]
            codes = [Outline.MOVETO] + [Outline.CURVE4] * (len(places) - 1)
    patch = PathPatch(
        Outline([(place.real, place.imag) for place in places], codes),
        facecolor=_FILLS[line.fill],
        edgecolor="black" if width else "none",
        linewidth=width,
        linestyle=_DASHES[line.dash],
        capstyle="butt",
        joinstyle="miter",
        zorder=order,
    )
    return axes.add_artist(patch)
