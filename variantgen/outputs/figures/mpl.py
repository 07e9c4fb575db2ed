"""The figure on the axes of matplotlib, for notebooks and plots; letters are the same outlines as everywhere."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from variantgen.errors import ToolMissingError
from variantgen.figure.curves import Step, curves
from variantgen.figure.drawing import LETTER, Drawing, Layer
from variantgen.figure.lettering import letters_of
from variantgen.outputs.figures import MILLIMETRES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_FILLS = {"": "none", "ink": "black", "paper": "white", "shade": "0.92"}
_DASHES = {"": "solid", "dashed": (0, (6, 3.6)), "dashdot": (0, (8, 2.4, 1.2, 2.4))}
_POINTS = 72 / 25.4


def need_matplotlib() -> None:
    """Raise ToolMissingError where matplotlib is not installed."""
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        raise ToolMissingError(
            "plots need the package matplotlib: install it with  pip install 'variantgen[plots]'"
        ) from None


def figure(drawing: Drawing) -> Figure:
    """A figure of matplotlib of the size of the drawing. Raises ToolMissingError without matplotlib."""
    need_matplotlib()
    from matplotlib.figure import Figure

    made = Figure(figsize=(MILLIMETRES * drawing.width / 25.4, MILLIMETRES * drawing.height / 25.4), dpi=150)
    draw_on(made.add_axes((0.0, 0.0, 1.0, 1.0)), drawing)
    return made


def draw_on(axes: Axes, drawing: Drawing, labels: bool = True) -> None:
    """Draw on axes, which get the extent of the drawing (u), equal scales and no frame."""
    from matplotlib.patches import PathPatch, Rectangle

    axes.set_xlim(0, drawing.width)
    axes.set_ylim(0, drawing.height)
    axes.set_aspect("equal")
    axes.set_axis_off()
    pen = MILLIMETRES * _POINTS
    for curve in curves(drawing):
        axes.add_patch(
            PathPatch(
                _path(curve.steps),
                facecolor=_FILLS[curve.fill],
                edgecolor="black" if curve.weight else "none",
                linewidth=curve.weight * pen,
                linestyle=_DASHES[curve.dash],
                capstyle="round",
                joinstyle="round",
                zorder=2 + curve.layer,
            )
        )
    for label in drawing.labels if labels else ():
        corner = label.at - complex(*label.size) / 2
        paper = Rectangle((corner.real, corner.imag), *label.size, facecolor="white", edgecolor="none")
        paper.set_zorder(2 + Layer.LABEL)
        axes.add_patch(paper)
        for glyph, at in letters_of(label):
            steps = [(kind, tuple(at + LETTER * point for point in points)) for kind, points in glyph.steps]
            axes.add_patch(PathPatch(_path(steps), facecolor="black", edgecolor="none", zorder=3 + Layer.LABEL))


def _path(steps: Any) -> Any:
    """Steps as a path of matplotlib."""
    from matplotlib.path import Path

    codes, places = [], []
    step: Step
    for step in steps:
        kind, points = step
        codes += {"M": [Path.MOVETO], "L": [Path.LINETO], "C": [Path.CURVE4] * 3, "Z": [Path.CLOSEPOLY]}[kind]
        places += [(p.real, p.imag) for p in points] or [(0.0, 0.0)]
    return Path(places, codes)
