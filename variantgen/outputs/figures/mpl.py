"""The figure on the axes of matplotlib, for notebooks and plots; letters are the same outlines as everywhere."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from variantgen.errors import missing_package
from variantgen.figure.curves import AROUND, DASHES, Step, curves
from variantgen.figure.drawing import LETTER, Drawing, Layer, Line
from variantgen.figure.letters.lettering import letters_of
from variantgen.outputs.figures import unit

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_FILLS = {"": "none", "ink": "black", "paper": "white", "shade": "0.92"}
_THINNEST = 0.35  # points
_ABOVE = 2.0


def need_matplotlib() -> None:
    """Raise ToolMissingError where matplotlib is not installed."""
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        raise missing_package("plots need", "matplotlib", "plots") from None


def figure(drawing: Drawing, width_mm: float | None = None) -> Figure:
    """A figure of matplotlib of the size of the drawing, or of a width. Raises ToolMissingError without matplotlib."""
    need_matplotlib()
    from matplotlib.figure import Figure

    inches = unit(drawing, width_mm) / 25.4
    made = Figure(figsize=(inches * drawing.width, inches * drawing.height), dpi=150)
    draw_on(made.add_axes((0.0, 0.0, 1.0, 1.0)), drawing)
    return made


def draw_on(axes: Axes, drawing: Drawing) -> None:
    """Draw on axes, which get the extent of the drawing (u), equal scales and no frame.

    Lines are as thick as the size of the axes asks for now; when the axes are resized later, lines keep their weight.
    """
    from matplotlib.patches import PathPatch, Rectangle

    axes.set_xlim(0, drawing.width)
    axes.set_ylim(0, drawing.height)
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.apply_aspect()
    draw_lines(axes, drawing.lines, points_per_unit(axes))
    front = _ABOVE + Layer.LABEL
    for label in drawing.labels:
        width, height = (side + 2 * AROUND for side in label.size)
        corner = label.at - complex(width, height) / 2
        paper = Rectangle(
            (corner.real, corner.imag), width, height, facecolor=_FILLS[label.paper], edgecolor="none", zorder=front
        )
        axes.add_patch(paper)
        for glyph, at in letters_of(label):
            steps = [(kind, tuple(at + LETTER * point for point in points)) for kind, points in glyph.steps]
            axes.add_patch(PathPatch(_path(steps), facecolor="black", edgecolor="none", zorder=front + 1))


def draw_lines(axes: Axes, lines: Iterable[Line], points: float, above: float = _ABOVE) -> list[Artist]:
    """Draw lines in the order of their layers on axes whose coordinates are u; ``points`` to the u give their weight.

    Returns what was added, to be removed again; ``above`` is the order of the hindmost layer.
    """
    from matplotlib.patches import PathPatch

    added: list[Artist] = []
    for curve in curves(lines):
        weight = max(_THINNEST, curve.weight * points) if curve.weight else 0.0
        # The library counts dashes in weights of their pen.
        dashes = [length * points / weight for length in DASHES[curve.dash]] if weight else []
        patch = PathPatch(
            _path(curve.steps),
            facecolor=_FILLS[curve.fill],
            edgecolor="black" if curve.weight else "none",
            linewidth=weight,
            linestyle=(0, dashes) if dashes else "solid",
            capstyle="round",
            joinstyle="round",
            snap=False,
            zorder=above + curve.layer,
        )
        added.append(axes.add_artist(patch))
    return added


def points_per_unit(axes: Axes) -> float:
    """Printer's points per u of axes whose coordinates are u."""
    box, (low, high) = axes.get_position(), axes.get_xlim()
    figure = axes.get_figure(root=True)
    assert figure is not None
    return float(72 * box.width * figure.get_size_inches()[0] / (high - low))


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
