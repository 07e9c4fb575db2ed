"""A LaTeX document with the TikZ picture of one figure, on a page of its size."""

from __future__ import annotations

from variantgen.figure.drawing import Drawing
from variantgen.outputs.figures import unit
from variantgen.outputs.figures.tikz import tikz

SUFFIXES = (".tex",)
_DOCUMENT = r"""\RequirePackage{{fix-cm}}  % letters of any size
\documentclass{{article}}
\usepackage[{encoding}]{{fontenc}}
\usepackage[utf8]{{inputenc}}
\usepackage{{amsmath,tikz}}
\usepackage[paperwidth={width:.3f}mm, paperheight={height:.3f}mm, margin=0mm]{{geometry}}
\pagestyle{{empty}}
\setlength{{\parindent}}{{0pt}}
\setlength{{\topskip}}{{0pt}}
\begin{{document}}
\noindent\vbox to 0pt{{%
{picture}\vss}}
\end{{document}}
"""


def render(drawing: Drawing, width_mm: float | None = None) -> bytes:
    """The document as a file; only one with Cyrillic letters needs their font encoding."""
    millimetres = unit(drawing, width_mm)
    picture = tikz(drawing, width_mm)
    printed = "".join(line for line in picture.splitlines() if not line.startswith("%"))
    return _DOCUMENT.format(
        encoding="OT1" if printed.isascii() else "T2A",
        width=millimetres * drawing.width,
        height=millimetres * drawing.height,
        picture=picture,
    ).encode()
