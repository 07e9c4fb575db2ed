"""The labels of a figure for the typesetting engine: all their letters as one line, each at its height.

For the engine a place of its own for each label would be as much work as a paragraph of text.
"""

from __future__ import annotations

from typing import Any

from variantgen.figure.drawing import LETTER, Drawing, Label
from variantgen.outputs.typst.fragments import FragmentTable, LetterLine
from variantgen.outputs.typst.markup import Lettered, markup
from variantgen.outputs.typst.set_formulas import set_label


class FigureLabels(Lettered):
    """The labels of a drawing."""

    def __init__(self, drawing: Drawing) -> None:
        self._drawing = drawing

    def data(self, letters: bool, table: FragmentTable | None = None) -> dict[str, Any]:
        """``letters`` are fragments of a line along the top of the figure, ``markup`` the labels without letters.

        A label is the place of its middle (x, y in u, y down) and its markup.
        """
        line = LetterLine()
        others: list[Any] = []
        x = 0.0  # where the line has come to, in em as all that follows
        for label in self._drawing.labels:
            made = set_label(markup(label.formula)) if letters else None
            if not made:
                others.append(self._with_markup(label))
                continue
            middle = complex(label.at.real, label.at.imag - self._drawing.height) / LETTER
            start = middle.real - made.width / 2
            line.space(start - x)
            line.extend(made.fragments, up=middle.imag - (made.highest + made.lowest) / 2)
            x = start + made.width - made.rest
        fragments = line.found()
        return {"letters": fragments if table is None else table.numbers(fragments), "markup": others}

    def _with_markup(self, label: Label) -> list[Any]:
        y = self._drawing.height - label.at.imag
        return [round(label.at.real, 2), round(y, 2), markup(label.formula)]
