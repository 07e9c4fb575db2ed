"""How the data for templates of documents write formulas: for the engine, or in the markup of another output."""

from __future__ import annotations

from typing import Any, Protocol

from variantgen.figure.drawing import Drawing
from variantgen.outputs.qr import qr_rows, qr_svg
from variantgen.outputs.typst.markup import heading, markup
from variantgen.outputs.typst.typesetter import equals_data, figure_data
from variantgen.wording.formula import Equation, Formula, Surd, UnitText
from variantgen.wording.text import Text


class Writing(Protocol):
    """The values that a template gets for what is no plain text; plain strings are text, which the template escapes."""

    def formula(self, formula: Formula) -> Any:
        """A formula inside a line."""

    def text(self, text: Text) -> Any:
        """Words with formulas in them."""

    def equals(self, equation: Equation, exact: Surd | None = None) -> dict[str, Any]:
        """``symbol = value unit``; ``exact`` is the value in closed form, which stands before the rounded one."""

    def heading(self, symbol: Formula, unit: UnitText) -> Any:
        """The head of a column of answers: ``v_B, cm/s``."""

    def sign(self, sign: str) -> Any:
        """A sign between the pieces of a formula, like ``=``; nothing before the first piece."""

    def figure(self, drawing: Drawing) -> Any:
        """A figure of no size yet."""

    def code(self, text: str) -> Any:
        """A QR code, 10 mm wide."""


class TypstWriting:
    """Data for the templates of the engine."""

    def formula(self, formula: Formula) -> str:
        """The markup, which templates evaluate."""
        return markup(formula)

    def text(self, text: Text) -> list[Any]:
        """Runs of text: strings as they are, formulas as one-element lists."""
        return [part if isinstance(part, str) else [markup(part)] for part in text]

    def equals(self, equation: Equation, exact: Surd | None = None) -> dict[str, Any]:
        """Data for ``equals`` of ``common.typ``."""
        return {**equals_data(equation, exact)}

    def heading(self, symbol: Formula, unit: UnitText) -> str:
        """The markup, which templates evaluate."""
        return heading(symbol, unit)

    def sign(self, sign: str) -> str:
        """The sign itself, as text."""
        return sign

    def figure(self, drawing: Drawing) -> dict[str, Any]:
        """Data for ``figure.typ``."""
        return figure_data(drawing)

    def code(self, text: str) -> str:
        """An image as SVG."""
        return qr_svg(qr_rows(text))


TYPST = TypstWriting()
