"""PDF of one figure, and PNG, through the typesetting engine."""

from __future__ import annotations

from typing import Literal

from variantgen.figure.drawing import Drawing
from variantgen.outputs.figures import MILLIMETRES
from variantgen.outputs.typesetter import figure_data, typesetter


def page(drawing: Drawing, form: Literal["pdf", "png"]) -> bytes:
    """A page of the size of the figure."""
    data = {"figure": figure_data(drawing), "millimetres": MILLIMETRES, "lang": "en"}
    with typesetter() as engine:
        return engine.compile("figure_page.typ", data, form)[0]
