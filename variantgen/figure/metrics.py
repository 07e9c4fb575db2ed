"""Sizes of labels from the widths of the letters, in units of the letter size (em)."""

from __future__ import annotations

from functools import cache

from variantgen.wording.formula import GREEK, Formula, Symbol, letters

# Advance widths of the italic letters of New Computer Modern Math (em), rounded; unknown letters count as _SMALL.
_WIDE = {
    "A": 0.75, "B": 0.76, "C": 0.72, "D": 0.83, "E": 0.74, "F": 0.64, "G": 0.79, "H": 0.83, "K": 0.85, "L": 0.68,
    "M": 0.97, "N": 0.80, "O": 0.76, "P": 0.64, "Q": 0.79, "R": 0.76, "S": 0.61, "T": 0.58, "U": 0.68, "W": 0.94,
}  # fmt: skip
_GREEK = {"omega": 0.62, "epsilon": 0.47, "phi": 0.65, "alpha": 0.64, "beta": 0.57, "psi": 0.65, "gamma": 0.52}
_SMALL, _NUMBER, _INDEX = 0.50, 0.36, 0.72
CAP, DESCENT = 0.70, 0.20  # height of a capital; what an index or a descender adds below


def width(formula: Formula) -> float:
    """Width of a symbol (em); other formulas are counted by their letters."""
    if not isinstance(formula, Symbol):
        return 3.0
    main = _text_width(formula.base)
    return main + _INDEX * sum(0.52 * len(i.text) if i.upright else _text_width(i.text) for i in formula.index)


@cache
def size(formula: Formula) -> tuple[float, float]:
    """Width and height of a label (em)."""
    low = isinstance(formula, Symbol) and bool(formula.index or formula.base in ("phi", "psi", "beta", "rho"))
    return width(formula), CAP + (DESCENT if low else 0.0)


def _text_width(text: str) -> float:
    if text in GREEK:
        return _GREEK.get(text, 0.6)
    if text.isdecimal():
        return _SMALL * len(text)
    return sum(_WIDE.get(letter, _SMALL) + _NUMBER * len(number) for letter, number in letters(text))
