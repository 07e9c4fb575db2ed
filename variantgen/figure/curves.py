"""The lines of a drawing as curves for back ends: lines of one layer and one pen joined, arcs as Bezier pieces."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from variantgen.figure.drawing import Label, Layer, Line, Path, Strokes

Step = tuple[str, tuple[complex, ...]]

# Lengths of dashes and gaps in turn, u. Ends of lines are round, so dashes look longer by the weight of the pen.
DASHES: dict[str, tuple[float, ...]] = {"": (), "dashed": (3.0, 1.8), "dashdot": (4.0, 1.2, 0.6, 1.2)}
AROUND = 0.15  # of the paper behind a label beyond its box, u


class Curve(NamedTuple):
    """Steps M, L, C, Z (places in u) of one pen; see :class:`~variantgen.figure.drawing.Path` for fill and dash."""

    layer: Layer
    weight: float
    fill: str
    dash: str
    steps: tuple[Step, ...]


def curves(lines: Iterable[Line]) -> list[Curve]:
    """The curves of lines, in their order; few elements, because the time of every renderer goes by their number."""
    found: dict[tuple[Layer, float, str, str], list[Step]] = {}
    for line in lines:
        fill, dash = ("", "") if isinstance(line, Strokes) else (line.fill, line.dash)
        found.setdefault((line.layer, line.weight, fill, dash), []).extend(_steps(line))
    return [Curve(*style, tuple(steps)) for style, steps in found.items()]


def papers(labels: Iterable[Label]) -> list[Curve]:
    """The paper behind labels: a curve for each kind of it."""
    found: dict[str, list[Step]] = {}
    for label in labels:
        width, height = (0.5 * side + AROUND for side in label.size)
        corners = (complex(-width, -height), complex(width, -height), complex(width, height), complex(-width, height))
        steps: list[Step] = [("L" if i else "M", (label.at + corner,)) for i, corner in enumerate(corners)]
        found.setdefault(label.paper, []).extend([*steps, ("Z", ())])
    return [Curve(Layer.LABEL, 0.0, fill, "", tuple(steps)) for fill, steps in found.items()]


def _steps(line: Line) -> list[Step]:
    if isinstance(line, Strokes):
        return [step for start, end in line.segments for step in (("M", (start,)), ("L", (end,)))]
    if isinstance(line, Path):
        steps: list[Step] = [("L" if i else "M", (point,)) for i, point in enumerate(line.points)]
        return [*steps, ("Z", ())] if line.closed else steps
    steps = [("M", (line.at(0),)), *(("C", piece) for piece in line.cubics())]
    return [*steps, ("Z", ())] if line.full else steps
