"""PDF of one figure, on a page of its size."""

from __future__ import annotations

from variantgen.figure.drawing import Drawing
from variantgen.outputs.figures.engine import page

SUFFIXES = (".pdf",)


def render(drawing: Drawing, width_mm: float | None = None) -> bytes:
    """The figure as a file. Raises ToolMissingError without the engine."""
    return page(drawing, "pdf", width_mm)
