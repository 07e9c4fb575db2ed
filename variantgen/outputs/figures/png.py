"""PNG of one figure, 200 dots to the inch."""

from __future__ import annotations

from variantgen.figure.drawing import Drawing
from variantgen.outputs.figures.engine import page

SUFFIXES = (".png",)


def render(drawing: Drawing) -> bytes:
    """The figure as a file."""
    return page(drawing, "png")
