r"""TikZ source: readable and editable, with named styles and letters as LaTeX math.

The preamble needs ``\usepackage{tikz}``, ``\usepackage{amsmath}`` and, for Russian words in indices, a Cyrillic font
encoding; the styles stand at the head of each picture, so that it can be put into any document.
"""

from __future__ import annotations

import cmath
import math
from textwrap import wrap

from variantgen.figure.curves import AROUND, DASHES
from variantgen.figure.drawing import BOLD, LETTER, MEDIUM, THIN, Arc, Drawing, Label, Line, Path, Strokes
from variantgen.outputs.figures import unit
from variantgen.wording.latex import to_latex

SUFFIXES = (".tikz",)
_PENS = {BOLD: "bold", 0.8 * BOLD: "strong", MEDIUM: "medium", THIN: "fine"}
_FILLS = {"ink": "fill=black", "paper": "fill=white", "shade": "fill=black!8"}
_DASHED = {"dashed": "hidden line", "dashdot": "centre line"}
_COLUMNS = 110  # of the words at the head
_POINT = 72.27 / 25.4  # points of TeX in a millimetre


def render(drawing: Drawing, width_mm: float | None = None) -> bytes:
    """The picture as a file."""
    return tikz(drawing, width_mm).encode()


def tikz(drawing: Drawing, width_mm: float | None = None) -> str:
    """A ``tikzpicture`` of the size of the drawing; ends with a line feed."""
    millimetres = unit(drawing, width_mm)
    lines = [f"% {line}" for sentence in drawing.alt.splitlines() for line in wrap(sentence, _COLUMNS)]
    lines.append("\\begin{tikzpicture}[\n  " + ",\n  ".join(_styles(millimetres)) + "]")
    lines.append(rf"  \path[use as bounding box] (0,0) rectangle {_xy(complex(drawing.width, drawing.height))};")
    lines += [_command(line, millimetres * _POINT) for line in drawing.lines]
    lines += [
        rf"  \node[{_letters(label)}] at {_xy(label.at)} {{${to_latex(label.formula)}$}};" for label in drawing.labels
    ]
    return "\n".join([*lines, "\\end{tikzpicture}", ""])


def _styles(millimetres: float) -> list[str]:
    """Pens, dashes and letters by name, for a size of the figure unit."""
    points = millimetres * _POINT
    size = f"\\fontsize{{{LETTER * points:.2f}}}{{{1.2 * LETTER * points:.2f}}}\\selectfont"
    return [
        f"x={millimetres:.5g}mm, y={millimetres:.5g}mm, line cap=round, line join=round",
        *(f"{name}/.style={{line width={weight * points:.2f}pt}}" for weight, name in _PENS.items()),
        *(
            f"{name}/.style={{dash pattern="
            + " ".join(f"{'off' if i % 2 else 'on'} {x * points:.1f}pt" for i, x in enumerate(DASHES[dash]))
            + "}"
            for dash, name in _DASHED.items()
        ),
        f"letters/.style={{inner sep={AROUND * points:.2f}pt, outer sep=0pt, fill=white, font={size}}}",
    ]


def _letters(label: Label) -> str:
    """The options of a label: on paper, or on the shade of a plate."""
    return "letters" if label.paper == "paper" else f"letters, {_FILLS[label.paper]}"


def _command(line: Line, points: float) -> str:
    match line:
        case Strokes(segments, _, weight):
            return rf"  \draw[{_pen(weight, points)}] " + " ".join(f"{_xy(a)} -- {_xy(b)}" for a, b in segments) + ";"
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
    drawn = [_pen(line.weight, points)] if line.weight else []
    options = ", ".join([*drawn, *filter(None, (_FILLS.get(line.fill), _DASHED.get(line.dash)))])
    return rf"  \{'draw' if line.weight else 'fill'}[{options}] {way};"


def _pen(weight: float, points: float) -> str:
    """The named pen of a weight, or its width; ``points`` is the figure unit."""
    near = min(_PENS, key=lambda known: abs(known - weight))
    return _PENS[near] if abs(near - weight) < 1e-6 else f"line width={weight * points:.2f}pt"


def _xy(place: complex) -> str:
    return f"({_number(place.real)},{_number(place.imag)})"


def _number(value: float) -> str:
    return f"{value + 0.0:.2f}".rstrip("0").rstrip(".")
