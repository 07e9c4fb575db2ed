"""PNG of one figure."""

from __future__ import annotations

from variantgen.figure.drawing import Drawing
from variantgen.outputs.figures.engine import page

SUFFIXES = (".png",)


def render(drawing: Drawing, width_mm: float | None = None, ppi: float = 200.0) -> bytes:
    """The figure as a file, ``ppi`` dots to the inch. Raises ToolMissingError without the engine."""
    return page(drawing, "png", width_mm, ppi)
