r"""TikZ source: readable and editable, with named styles and letters as LaTeX math.

The preamble needs ``\usepackage{tikz}``, ``\usepackage{amsmath}`` and, for Russian words in indices, a Cyrillic font
encoding; the styles stand at the head of each picture, so that it can be put into any document.
"""

from __future__ import annotations

import cmath
import math

from variantgen.figure.drawing import BOLD, LETTER, MEDIUM, THIN, Arc, Drawing, Line, Path, Strokes
from variantgen.outputs.figures import MILLIMETRES
from variantgen.wording.latex import escaped, to_latex

SUFFIXES = (".tikz", ".tex")
_PENS = {BOLD: "bold", 0.8 * BOLD: "strong", MEDIUM: "medium", THIN: "fine"}
_FILLS = {"ink": "fill=black", "paper": "fill=white", "shade": "fill=black!8"}
_DASHES = {"dashed": "hidden line", "dashdot": "centre line"}
_POINTS_PER_UNIT = MILLIMETRES * 72.27 / 25.4
_DASHDOT = " ".join(
    f"{'off' if i % 2 else 'on'} {x * _POINTS_PER_UNIT:.1f}pt" for i, x in enumerate((4, 1.2, 0.6, 1.2))
)
_STYLES = (
    f"x={MILLIMETRES}mm, y={MILLIMETRES}mm, line cap=round, line join=round",
    *(f"{name}/.style={{line width={weight * _POINTS_PER_UNIT:.2f}pt}}" for weight, name in _PENS.items()),
    f"hidden line/.style={{dash pattern=on {3 * _POINTS_PER_UNIT:.1f}pt off {1.8 * _POINTS_PER_UNIT:.1f}pt}}",
    f"centre line/.style={{dash pattern={_DASHDOT}}}",
    "letters/.style={inner sep=0.3pt, outer sep=0pt, fill=white, "
    f"font=\\fontsize{{{LETTER * _POINTS_PER_UNIT:.2f}}}{{{1.2 * LETTER * _POINTS_PER_UNIT:.2f}}}\\selectfont}}",
)


def render(drawing: Drawing) -> bytes:
    """The figure as a file."""
    return tikz(drawing).encode()


def tikz(drawing: Drawing) -> str:
    """A ``tikzpicture``; ends with a line feed."""
    lines = [f"% {escaped(sentence)}" for sentence in drawing.alt.splitlines()]
    lines.append("\\begin{tikzpicture}[\n  " + ",\n  ".join(_STYLES) + "]")
    lines += [_command(line) for line in drawing.lines]
    lines += [rf"  \node[letters] at {_xy(label.at)} {{${to_latex(label.formula)}$}};" for label in drawing.labels]
    return "\n".join([*lines, "\\end{tikzpicture}", ""])


def _command(line: Line) -> str:
    match line:
        case Strokes(segments, _, weight):
            return rf"  \draw[{_pen(weight)}] " + " ".join(f"{_xy(a)} -- {_xy(b)}" for a, b in segments) + ";"
        case Path():
            way = " -- ".join(_xy(point) for point in line.points) + (" -- cycle" if line.closed else "")
        case Arc() if line.full:
            way = f"{_xy(line.centre)} circle[radius={_number(line.radius)}]"
        case Arc():
            start, end = math.degrees(line.start), math.degrees(line.start + line.sweep)
            angles = f"start angle={_number(start)}, end angle={_number(end)}"
            way = (
                f"{_xy(line.centre + cmath.rect(line.radius, line.start))} arc[{angles}, radius={_number(line.radius)}]"
            )
    drawn = [_pen(line.weight)] if line.weight else []
    options = ", ".join([*drawn, *filter(None, (_FILLS.get(line.fill), _DASHES.get(line.dash)))])
    return rf"  \{'draw' if line.weight else 'fill'}[{options}] {way};"


def _pen(weight: float) -> str:
    """The named pen of a weight, or its width."""
    near = min(_PENS, key=lambda known: abs(known - weight))
    return _PENS[near] if abs(near - weight) < 1e-6 else f"line width={weight * _POINTS_PER_UNIT:.2f}pt"


def _xy(place: complex) -> str:
    return f"({_number(place.real)},{_number(place.imag)})"


def _number(value: float) -> str:
    return f"{value + 0.0:.2f}".rstrip("0").rstrip(".")
