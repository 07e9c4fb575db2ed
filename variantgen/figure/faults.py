"""What is wrong with a finished figure, as far as a program can see it."""

from __future__ import annotations

from variantgen.figure.drawing import Drawing, Label
from variantgen.wording.formula import to_plain

# A figure much longer than wide (or the other way round) does not fit beside its statement.
_LONGEST = 5.0


def figure_faults(drawing: Drawing) -> list[str]:
    """Labels that cover each other or leave the paper, and extreme proportions."""
    found = []
    for i, label in enumerate(drawing.labels):
        name = to_plain(label.formula)
        half_width, half_height = 0.5 * label.size[0], 0.5 * label.size[1]
        across = half_width <= label.at.real <= drawing.width - half_width
        if not (across and half_height <= label.at.imag <= drawing.height - half_height):
            found.append(f"the label {name} leaves the figure")
        found += [
            f"the labels {name} and {to_plain(other.formula)} cover each other"
            for other in drawing.labels[:i]
            if _overlap(label, other)
        ]
    if max(drawing.width, drawing.height) > _LONGEST * min(drawing.width, drawing.height):
        found.append(f"the figure is {drawing.width:.0f} by {drawing.height:.0f} units: too long")
    return found


def _overlap(first: Label, second: Label) -> bool:
    gap = first.at - second.at
    wide, high = (0.5 * (first.size[axis] + second.size[axis]) for axis in (0, 1))
    return abs(gap.real) < wide and abs(gap.imag) < high
