"""What templates of the typesetting engine get: markup of formulas, runs of text, figures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from variantgen.figure.drawing import LETTER, Drawing
from variantgen.outputs.qr import qr_rows, qr_svg
from variantgen.outputs.typst.broken_fraction import in_the_line
from variantgen.outputs.typst.figure_curves import FigureCurves
from variantgen.outputs.typst.figure_labels import FigureLabels
from variantgen.outputs.typst.formula_lines import WIDEST, Row, in_lines
from variantgen.outputs.typst.markup import Piece, heading, markup, piece
from variantgen.outputs.typst.set_formulas import set_piece
from variantgen.outputs.typst.widths import formula_width
from variantgen.wording.formula import Equation, Formula, Measured, Surd, UnitText
from variantgen.wording.text import Text, with_steady_dashes


class TypstWriting:
    """Fulfils :class:`variantgen.outputs.documents.writing.Writing` for the engine."""

    def formula(self, formula: Formula) -> str:
        """The markup, which templates evaluate."""
        return markup(formula)

    def text(self, text: Text) -> list[Any]:
        """Runs of text: strings as they are, formulas as one-element lists."""
        return [with_steady_dashes(part) if isinstance(part, str) else [markup(part)] for part in text]

    def equals(self, equation: Equation, exact: Surd | None = None) -> dict[str, Any]:
        """Data for ``equals`` of ``common.typ``; a unit without a space is put to the value."""
        right = equation.right
        if not isinstance(right, Measured):
            return {"symbol": markup(equation.left), "exact": markup(right), "value": "", "unit": ""}
        tight = "".join(word for word, _ in right.unit.parts) if right.unit.tight else ""
        return {
            "symbol": markup(equation.left),
            "exact": markup(exact) if exact else "",
            "value": right.number.text + tight,
            "unit": "" if tight else markup(right.unit),
        }

    def heading(self, symbol: Formula, unit: UnitText) -> str:
        """The markup, which templates evaluate."""
        return heading(symbol, unit)

    def row(self, formulas: Sequence[Sequence[tuple[str, Formula]]], last: bool) -> Row:
        """The lines of the row; fractions too wide for a column are broken in the line."""
        made = [[part for sign, formula in pieces for part in _pieces(sign, formula)] for pieces in formulas]
        return in_lines(made, "." if last else ";")

    def figure(self, drawing: Drawing, caption: Text = ()) -> dict[str, Any]:
        """Data for ``figure.typ``."""
        return figure_data(drawing)

    def code(self, text: str) -> str:
        """An image as SVG."""
        return qr_svg(qr_rows(text))


TYPST = TypstWriting()


def _pieces(sign: str, formula: Formula) -> list[tuple[str, Piece]]:
    """A piece, or the parts of a fraction too wide for a column."""
    whole = piece(formula)
    made = set_piece(whole)
    width = made.width if made else formula_width(formula)
    return in_the_line(sign, formula) if width > WIDEST else [(sign, whole)]


def figure_data(drawing: Drawing) -> dict[str, Any]:
    """A drawing as data for ``figure.typ``. It stands for its words itself, which are made when they are needed."""
    return {
        "w": round(drawing.width, 2),
        "h": round(drawing.height, 2),
        "letter": LETTER,
        "alt": drawing,
        "curves": FigureCurves(drawing),
        "labels": FigureLabels(drawing),
    }
