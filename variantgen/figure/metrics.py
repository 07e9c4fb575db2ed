"""Sizes of labels from the widths of the letters, in units of the letter size (em)."""

from __future__ import annotations

from functools import cache

from variantgen.wording.formula import GREEK, Equation, Formula, Index, Listing, Measured, Symbol, letters, to_plain

# Advance widths of the italic letters of New Computer Modern Math (em), rounded; unknown letters count as _SMALL.
_WIDE = {
    "A": 0.75, "B": 0.76, "C": 0.72, "D": 0.83, "E": 0.74, "F": 0.64, "G": 0.79, "H": 0.83, "K": 0.85, "L": 0.68,
    "M": 0.97, "N": 0.80, "O": 0.76, "P": 0.64, "Q": 0.79, "R": 0.76, "S": 0.61, "T": 0.58, "U": 0.68, "W": 0.94,
}  # fmt: skip
_GREEK = {
    "omega": 0.62, "epsilon": 0.47, "phi": 0.65, "alpha": 0.64, "beta": 0.57, "psi": 0.65, "gamma": 0.52, "tau": 0.51,
    "pi": 0.57, "prime": 0.40,
}  # fmt: skip
_SMALL, _NUMBER, _INDEX = 0.50, 0.36, 0.72
CAP, DESCENT = 0.70, 0.20  # height of a capital; what an index or a descender adds below
ASCENT = 0.25  # what an upper index adds above
_COMMA, _EQUALS = 0.45, 1.40  # between the parts of a list, of an equation


def width(formula: Formula) -> float:
    """Width of a formula (em)."""
    match formula:
        case Symbol(base, index, upper):
            return _text_width(base) + max(_script_width(index), _script_width(upper))
        case Listing(items):
            return sum(width(item) for item in items) + _COMMA * (len(items) - 1)
        case Equation(left, right):
            return width(left) + _EQUALS + width(right)
        case Measured():
            return _SMALL * len(to_plain(formula))
    return 3.0


def _script_width(script: tuple[Index, ...]) -> float:
    """Width of what stands at the upper or the lower index (em)."""
    return _INDEX * sum(0.52 * len(i.text) if i.upright else _text_width(i.text) for i in script)


@cache
def size(formula: Formula) -> tuple[float, float]:
    """Width and height of a label (em)."""
    return width(formula), CAP + (DESCENT if _is_low(formula) else 0.0) + (ASCENT if _is_high(formula) else 0.0)


def _is_low(formula: Formula) -> bool:
    """Whether something hangs below the line."""
    match formula:
        case Symbol(base, index, _):
            return bool(index or base in ("phi", "psi", "beta", "rho"))
        case Equation(left, right):
            return _is_low(left) or _is_low(right)
        case Listing() | Measured():
            return True
    return False


def _is_high(formula: Formula) -> bool:
    """Whether an upper index rises above the capitals."""
    match formula:
        case Symbol(_, index, upper):
            return bool(upper and index)
        case Equation(left, right):
            return _is_high(left) or _is_high(right)
    return False


def _text_width(text: str) -> float:
    if text in GREEK:
        return _GREEK.get(text, 0.6)
    if text.isdecimal():
        return _SMALL * len(text)
    return sum(_WIDE.get(letter, _SMALL) + _NUMBER * len(number) for letter, number in letters(text))
