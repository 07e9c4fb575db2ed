"""How wide formulas are, nearly: for rows of solutions, of what the glyph table has no letters for.

Within 7 % (standard deviation, 3400 pieces of 76 solutions) of what the engine measures, in em of the text.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

from variantgen.wording.formula import (
    Formula,
    Fraction,
    Function,
    Index,
    Measured,
    Number,
    Parenthesised,
    Power,
    Product,
    Root,
    Sum,
    Symbol,
    UnitText,
    Vector,
    to_plain,
)

_SCRIPT = 0.7  # the size of an index
_SIGN, _DOT, _THIN, _PARENTHESES, _ROOT, _BAR = 1.2, 0.6, 0.17, 0.8, 0.95, 0.2
_NARROW = dict.fromkeys(".,;'/ ", 0.28)
_CAPITAL, _LETTER, _WIDEST = 0.7, 0.52, {"M": 1.05, "m": 0.85, "ω": 0.63, "W": 1.0}


@lru_cache(maxsize=10_000)
def formula_width(formula: Formula) -> float:
    """The width of a formula in em, nearly; what is rare counts by its letters."""
    match formula:
        case Symbol(base, index, upper, part):
            own = _letters(to_plain(Symbol(base))) + max(_index(index), _index(upper))
            return own + (_PARENTHESES + _index(part) if part else 0.0)
        case Vector(symbol):
            return formula_width(symbol)
        case Number(text):
            return _letters(text)
        case UnitText(parts):
            return sum(_letters(word) + (0.4 if power != 1 else 0.0) for word, power in parts)
        case Measured(number, unit):
            return formula_width(number) + (_THIN + formula_width(unit) if unit.parts else 0.0)
        case Sum(terms):
            first = _SIGN / 2 if terms[0][0] < 0 else 0.0
            return first + sum(formula_width(term) + _SIGN for _, term in terms) - _SIGN
        case Product(factors):
            enclosed = sum(_PARENTHESES for factor in factors if isinstance(factor, Sum) and len(factor.terms) > 1)
            return enclosed + sum(map(formula_width, factors)) + _DOT * (len(factors) - 1)
        case Fraction(above, below):
            return max(formula_width(above), formula_width(below)) + _BAR
        case Power(base):
            return formula_width(base) + 0.4 + (_PARENTHESES if isinstance(base, Sum | Fraction | Product) else 0.0)
        case Root(radicand):
            return formula_width(radicand) + _ROOT
        case Function(name, argument):
            enclosed = isinstance(argument, Sum | Fraction | Product)
            return _letters(name) + _THIN + formula_width(argument) + (_PARENTHESES if enclosed else 0.0)
        case Parenthesised(content):
            return formula_width(content) + _PARENTHESES
        case _:
            return _letters(to_plain(formula))


def _index(parts: Iterable[Index]) -> float:
    return _SCRIPT * sum(_letters(part.text) for part in parts)


def _letters(text: str) -> float:
    return sum(
        _NARROW.get(letter) or _WIDEST.get(letter) or (_CAPITAL if letter.isupper() else _LETTER) for letter in text
    )
