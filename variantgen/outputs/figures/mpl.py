"""The figure on the axes of matplotlib, for notebooks and plots; letters are the same outlines as everywhere."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from variantgen.errors import ToolMissingError
from variantgen.figure.curves import AROUND, DASHES, Curve, Step, curves
from variantgen.figure.drawing import LETTER, Drawing, Layer
from variantgen.figure.lettering import letters_of
from variantgen.outputs.figures import unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_FILLS = {"": "none", "ink": "black", "paper": "white", "shade": "0.92"}


def need_matplotlib() -> None:
    """Raise ToolMissingError where matplotlib is not installed."""
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        raise ToolMissingError(
            "plots need the package matplotlib: install it with  pip install 'variantgen[plots]'"
        ) from None


def figure(drawing: Drawing, width_mm: float | None = None) -> Figure:
    """A figure of matplotlib of the size of the drawing, or of a width. Raises ToolMissingError without matplotlib."""
    need_matplotlib()
    from matplotlib.figure import Figure

    inches = unit(drawing, width_mm) / 25.4
    made = Figure(figsize=(inches * drawing.width, inches * drawing.height), dpi=150)
    draw_on(made.add_axes((0.0, 0.0, 1.0, 1.0)), drawing)
    return made


def draw_on(axes: Axes, drawing: Drawing, labels: bool = True) -> None:
    """Draw on axes, which get the extent of the drawing (u), equal scales and no frame.

    Lines are as thick as the size of the axes asks for now; one that is resized later keeps them.
    """
    from matplotlib.patches import PathPatch, Rectangle

    axes.set_xlim(0, drawing.width)
    axes.set_ylim(0, drawing.height)
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.apply_aspect()
    pen = 72 / axes.figure.dpi * axes.get_window_extent().width / drawing.width  # points of one figure unit
    for curve in curves(drawing):
        axes.add_patch(
            PathPatch(
                _path(curve.steps),
                facecolor=_FILLS[curve.fill],
                edgecolor="black" if curve.weight else "none",
                linewidth=curve.weight * pen,
                linestyle=_dashes(curve),
                capstyle="round",
                joinstyle="round",
                snap=False,
                zorder=2 + curve.layer,
            )
        )
    for label in drawing.labels if labels else ():
        width, height = (side + 2 * AROUND for side in label.size)
        corner = label.at - complex(width, height) / 2
        paper = Rectangle((corner.real, corner.imag), width, height, facecolor="white", edgecolor="none")
        paper.set_zorder(2 + Layer.LABEL)
        axes.add_patch(paper)
        for glyph, at in letters_of(label):
            steps = [(kind, tuple(at + LETTER * point for point in points)) for kind, points in glyph.steps]
            axes.add_patch(PathPatch(_path(steps), facecolor="black", edgecolor="none", zorder=3 + Layer.LABEL))


def _dashes(curve: Curve) -> Any:
    """The dashes of a curve, which matplotlib counts in weights of its pen."""
    return (0, [length / curve.weight for length in DASHES[curve.dash]]) if curve.dash and curve.weight else "solid"


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
