"""A drawing as text, one primitive per line: for comparing figures and for reading what changed in one."""

from __future__ import annotations

import math

from variantgen.figure.drawing import Arc, Drawing, Line, Path, Strokes
from variantgen.wording.formula import to_plain


def transcript(drawing: Drawing) -> str:
    """Size, lines back to front, labels, text in words; places in u to a tenth, angles in whole degrees."""
    found = [f"size {drawing.width:.1f} {drawing.height:.1f}"]
    found += [_line(line) for line in drawing.lines]
    found += [f"label {to_plain(label.formula)} at {_xy(label.at)}" for label in drawing.labels]
    if drawing.alt:
        found.append(f"alt {drawing.alt}")
    return "\n".join(found) + "\n"


def _line(line: Line) -> str:
    style = f"{line.layer.name.lower()} {line.weight:g}"
    match line:
        case Strokes(segments):
            start, end = segments[0][0], segments[-1][1]
            return f"strokes {style} {len(segments)} from {_xy(start)} to {_xy(end)}"
        case Path():
            marks = [mark for mark in ("closed" if line.closed else "", line.fill, line.dash) if mark]
            return " ".join(["path", style, *marks, *(_xy(point) for point in line.points)])
        case Arc():
            marks = [mark for mark in (line.fill, line.dash) if mark]
            part = [] if line.full else [f"from {math.degrees(line.start):.0f} over {math.degrees(line.sweep):.0f}"]
            return " ".join(["arc", style, *marks, f"at {_xy(line.centre)} radius {line.radius:.1f}", *part])


def _xy(place: complex) -> str:
    return f"{place.real + 0.0:.1f},{place.imag + 0.0:.1f}"
