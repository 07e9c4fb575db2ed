"""How the data for templates write formulas and figures: each engine has its own way."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

from variantgen.figure.drawing import Drawing
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

    def row(self, formulas: Sequence[Sequence[tuple[str, Formula]]], last: bool) -> Any:
        """Formulas in a row on lines of their own, ``last`` in their sentence.

        Each is in pieces that hold together, with a sign like ``=`` before each; there is none before the first piece.
        """

    def figure(self, drawing: Drawing, caption: Text = ()) -> Any:
        """A figure of no size yet; the caption is for those who do not see it, where nothing else tells it."""

    def code(self, text: str) -> Any:
        """A QR code, 10 mm wide."""
