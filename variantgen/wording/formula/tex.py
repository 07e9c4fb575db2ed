"""What formulas in TeX have in common, be they for LaTeX or for the part of it that matplotlib knows."""

from __future__ import annotations

from variantgen.wording.formula.markup import Mark, Markup
from variantgen.wording.formula.tree import Symbol

_MARKS = {Mark.NONE: "{}", Mark.ARROW: r"\vec{{{}}}", Mark.DOT: r"\dot{{{}}}", Mark.DOTS: r"\ddot{{{}}}"}
_WIDE_ARROW = r"\overrightarrow{{{}}}"


class TexMarkup(Markup):
    """Fractions, powers and roots."""

    def fraction(self, numerator: str, denominator: str) -> str:
        """One above the other."""
        return rf"\frac{{{numerator}}}{{{denominator}}}"

    def power(self, base: str, exponent: int) -> str:
        """With the exponent in a group of its own."""
        return f"{base}^{{{exponent}}}"

    def root(self, radicand: str) -> str:
        """The square root."""
        return rf"\sqrt{{{radicand}}}"


def marked(base: str, symbol: Symbol, mark: Mark) -> str:
    """The letter of a symbol below its mark: an arrow as wide as a name of several letters."""
    pattern = _WIDE_ARROW if mark is Mark.ARROW and symbol.is_name else _MARKS[mark]
    return pattern.format(base)
