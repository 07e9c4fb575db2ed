"""The values that templates of LaTeX get: source for formulas and text with formulas, drawings for figures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from msgspec import Struct

from variantgen.figure.drawing import Drawing
from variantgen.outputs.latex.characters import Alphabet
from variantgen.outputs.latex.text import Tex, latex_text
from variantgen.outputs.qr import qr_bars, qr_rows
from variantgen.wording.formula import Equation, Formula, Surd, UnitText
from variantgen.wording.latex import sign_to_latex, to_latex
from variantgen.wording.surds import with_surd
from variantgen.wording.text import Text, with_steady_dashes


class LatexWriting(Struct, frozen=True):
    """Fulfils :class:`variantgen.outputs.documents.writing.Writing` for documents of an alphabet."""

    alphabet: Alphabet

    def formula(self, formula: Formula) -> Tex:
        """Markup of a formula without the dollar signs."""
        return Tex(to_latex(formula))

    def text(self, text: Text) -> Tex:
        """Words, and formulas inside dollar signs."""
        return Tex("".join(self._run(part) for part in text))

    def _run(self, part: str | Formula) -> str:
        """A part of a text; blanks at its ends are kept."""
        if not isinstance(part, str):
            return f"${to_latex(part)}$"
        return latex_text(f".{with_steady_dashes(part)}.", self.alphabet)[1:-1]

    def equals(self, equation: Equation, exact: Surd | None = None) -> dict[str, Any]:
        """The whole equation as one formula."""
        return {"formula": self.formula(with_surd(equation, exact))}

    def heading(self, symbol: Formula, unit: UnitText) -> Tex:
        """Symbol and unit, between which a line may end."""
        return Tex(f"${to_latex(symbol)}$, ${to_latex(unit)}$" if unit.parts else f"${to_latex(symbol)}$")

    def row(self, formulas: Sequence[Sequence[tuple[str, Formula]]], last: bool) -> list[list[tuple[Tex, Tex]]]:
        """Each formula in pieces: the command for the sign and the markup."""
        return [
            [(Tex(sign_to_latex(sign) if sign else ""), self.formula(formula)) for sign, formula in pieces]
            for pieces in formulas
        ]

    def figure(self, drawing: Drawing, caption: Text = ()) -> Drawing:
        """The drawing itself: the template says the size."""
        return drawing

    def code(self, text: str) -> Tex:
        """A picture of TikZ: the dark modules that are side by side as rectangles."""
        rows = qr_rows(text)
        bars = [f"({x},{y}) rectangle +({count},1)" for x, y, count in qr_bars(rows)]
        lines = "\n   ".join(" ".join(bars[i : i + 5]) for i in range(0, len(bars), 5))
        module = f"{10 / len(rows):.5g}mm"
        return Tex(rf"\tikz[x={module}, y=-{module}] \fill {lines};")
