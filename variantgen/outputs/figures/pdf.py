"""PDF of one figure, on a page of its size."""

from __future__ import annotations

from variantgen.figure.drawing import Drawing
from variantgen.outputs.figures.engine import page

SUFFIXES = (".pdf",)


def render(drawing: Drawing) -> bytes:
    """The figure as a file."""
    return page(drawing, "pdf")
