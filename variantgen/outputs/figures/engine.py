"""PDF of one figure, and PNG, through the typesetting engine."""

from __future__ import annotations

from typing import Literal

from variantgen.figure.drawing import Drawing
from variantgen.outputs.figures import unit
from variantgen.outputs.typesetter import figure_data, typesetter


def page(drawing: Drawing, form: Literal["pdf", "png"], width_mm: float | None = None, ppi: float = 200.0) -> bytes:
    """A page of the size of the figure. Raises ToolMissingError without the engine."""
    data = {"figure": figure_data(drawing), "millimetres": unit(drawing, width_mm), "lang": drawing.language}
    with typesetter() as engine:
        return engine.compile("figure_page.typ", data, form, ppi)[0]
