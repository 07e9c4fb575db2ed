"""PDF of one figure, and PNG, through the typesetting engine."""

from __future__ import annotations

from typing import Literal

from variantgen.figure.drawing import Drawing
from variantgen.outputs.figures import unit
from variantgen.outputs.typst.typesetter import Typesetter, typesetter
from variantgen.outputs.typst.writing import figure_data


def page(drawing: Drawing, form: Literal["pdf", "png"], width_mm: float | None = None, ppi: float = 200.0) -> bytes:
    """A page of the size of the figure. Raises ToolMissingError without the engine."""
    with typesetter() as engine:
        return page_by(engine, drawing, form, width_mm, ppi)


def page_by(
    engine: Typesetter,
    drawing: Drawing,
    form: Literal["pdf", "png"],
    width_mm: float | None = None,
    ppi: float = 200.0,
) -> bytes:
    """The same by an engine that is at hand."""
    data = {"figure": figure_data(drawing), "millimetres": unit(drawing, width_mm), "lang": drawing.language}
    return engine.compile("figure_page.typ", data, form, ppi)[0]
