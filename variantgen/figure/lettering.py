"""How the letters of a formula stand, as the typesetting engine sets them: places of glyphs, width, ink.

The rules are those of the OpenType math table with the constants of New Computer Modern Math: an index is lowered, an
upper index raised, both moved apart until a gap is left between them; some space follows. Lengths in em, the size of
the lettering of the figure.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from variantgen.figure.drawing import LETTER, Label
from variantgen.figure.glyphs import Glyph
from variantgen.figure.letter_run import SCALE, WORD_SPACE, PlacedGlyph, Run
from variantgen.wording.formula import (
    GREEK,
    Equation,
    Formula,
    FormulaList,
    Function,
    Index,
    Measured,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
    SymbolProperty,
    UnitText,
    Vector,
    letters,
    precedence,
)
from variantgen.wording.formula.precedence import Between
from variantgen.wording.formula.tree import ANGLE

_PARENTHESES = 0.79  # as high as a formula may be between parentheses of a line
_THIN, _AROUND_EQUALS, _AROUND_SIGN = 1 / 6, 5 / 18, 2 / 9
ARROWS = {"v": 0.558, "a": 0.551, "r": 0.511, "omega": 0.609}  # where the arrow above a letter stands


@dataclass(frozen=True)
class Lettering:
    """A set formula: its glyphs, its width, and the bounds of its ink above the baseline (em)."""

    glyphs: tuple[PlacedGlyph, ...]
    width: float
    bottom: float
    top: float


@lru_cache(maxsize=10_000)
def typeset(formula: Formula) -> Lettering:
    """The lettering of a formula. Raises TypeError for a kind that stands in texts only, like a fraction."""
    run = Run()
    _set(run, formula)
    bottom = min((p.at.imag + p.glyph.bottom for p in run.glyphs), default=0.0)
    top = max((p.at.imag + p.glyph.top for p in run.glyphs), default=0.0)
    return Lettering(tuple(run.glyphs), run.x, bottom, top)


def letters_of(label: Label) -> list[tuple[Glyph, complex]]:
    """The glyphs of a label with where their origins are on the paper (u); ``label.at`` is the middle of the ink."""
    found = typeset(label.formula)
    origin = label.at - LETTER * complex(0.5 * found.width, 0.5 * (found.top + found.bottom))
    return [(placed.glyph, origin + LETTER * placed.at) for placed in found.glyphs]


def _set(run: Run, formula: Formula) -> None:
    match formula:
        case Symbol():
            _set_symbol(run, formula)
        case Vector(symbol):
            _set_symbol(run, symbol, arrow=True)
        case Number(text):
            run.words(text)
        case UnitText(parts):
            for word, power in parts:
                run.words(word)
                if power != 1:
                    above = Run()
                    above.words(str(power).replace("-", "\N{MINUS SIGN}"), 1)
                    run.attach(Run(), above, 0)
        case Measured(number, unit):
            run.words(number.text)
            run.x += 0.0 if unit.tight or not unit.parts else _THIN
            _set(run, unit)
        case Equation(left, right):
            _set(run, left)
            run.x += _AROUND_EQUALS
            run.words("=")
            run.x += _AROUND_EQUALS
            _set(run, right)
        case FormulaList(items):
            for i, item in enumerate(items):
                if i:
                    run.words(",")
                    run.x += _THIN
                _set(run, item)
        case SymbolProperty(what, symbol):
            _set_about(run, what, symbol)
        case Quotient(above, below):
            _set(run, above)
            run.words("/")
            _set(run, below)
        case Sum(terms):
            _set_sum(run, terms)
        case Product(factors):
            _set_product(run, factors)
        case Power(Symbol() as base, exponent) if not precedence.as_base(base, False) and 0 <= exponent <= 9:
            _set_symbol(run, base, exponent=str(exponent))
        case Power(Number() as base, exponent) if not precedence.as_base(base, False) and 0 <= exponent <= 9:
            run.words(base.text)
            run.attach(Run(), _digits(str(exponent), 1), 0)
        case Function(name, argument) if not (isinstance(argument, Vector) or precedence.as_argument(argument)):
            run.words(name)
            run.x += _THIN
            _set(run, argument)
        case _:
            raise TypeError(f"figures have no letters for a formula of the kind {type(formula).__name__}")


def _set_symbol(run: Run, symbol: Symbol, exponent: str = "", arrow: bool = False) -> None:
    """A letter with its indices, an arrow above it, and an exponent: that of a letter in parentheses is theirs."""
    above = _digits(exponent, 1) if exponent else Run()
    if symbol.part:
        run.add("(", 0)
    if symbol.base.startswith(ANGLE):
        run.add("∠", 0)
    if arrow:
        run.mark(run.x + ARROWS[symbol.base])
    _set_name(run, symbol.base.removeprefix(ANGLE), 0)
    upper = _script(symbol.upper, 1) if symbol.upper or symbol.part else above
    if symbol.index or upper.glyphs:
        run.attach(_script(symbol.index, 1), upper, 0)
    if symbol.part:
        run.add(")", 0)
        run.attach(_script(symbol.part, 1), above, 0)


def _set_sum(run: Run, terms: Sequence[tuple[int, Formula]]) -> None:
    for i, (sign, term) in enumerate(terms):
        around = _AROUND_SIGN if i else 0.0
        run.x += around
        if i or sign < 0:
            run.words("+" if sign > 0 else "\N{MINUS SIGN}")
        run.x += around
        _set_part(run, term, precedence.as_term(sign, term, not i, False))


def _set_product(run: Run, factors: Sequence[Formula]) -> None:
    for i, factor in enumerate(factors):
        if i:
            run.x += _THIN
            if precedence.between(factors, i - 1) is Between.DOT:
                run.words("\N{DOT OPERATOR}")
                run.x += _THIN
        _set_part(run, factor, precedence.as_factor(factors, i, False))


def _set_part(run: Run, formula: Formula, parentheses: bool) -> None:
    """A part of a formula, perhaps in parentheses. Raises TypeError where those would have to be taller than a line."""
    if parentheses:
        found = typeset(formula)
        if max(found.top, 0.5 - found.bottom) > _PARENTHESES:
            raise TypeError("tall parentheses are no letters")
        run.add("(", 0)
    _set(run, formula)
    if parentheses:
        run.add(")", 0)


def _set_about(run: Run, what: str, symbol: Symbol) -> None:
    """``|v|``, ``∠(v, x)``, ``sgn v``."""
    match what:
        case "modulus":
            run.add("|", 0)
            _set(run, symbol)
            run.add("|", 0)
        case "angle":
            run.add("∠", 0)
            run.add("(", 0)
            _set(run, symbol)
            run.add(",", 0)
            run.x += _THIN
            run.add("x", 0)
            run.add(")", 0)
        case _:
            run.words("sgn")
            run.x += _THIN
            _set(run, symbol)


def _set_name(run: Run, name: str, level: int) -> None:
    """Letters of points with their numbers, a Greek letter, or digits."""
    if name in GREEK:
        run.add(GREEK[name], level)
    elif name.isdecimal():
        for digit in name:
            run.add(digit, level)
    else:
        for letter, number in letters(name):
            if letter == "′":
                run.attach(Run(), _prime(level + 1), level)
                continue
            run.add(letter, level)
            if number:
                run.attach(_digits(number, level + 1), Run(), level)


def _prime(level: int) -> Run:
    run = Run()
    run.add("′", min(level, 2))
    return run


def _digits(number: str, level: int) -> Run:
    run = Run()
    _set_name(run, number, min(level, 2))
    return run


def _script(parts: Sequence[Index], level: int) -> Run:
    run = Run()
    for i, part in enumerate(parts):
        if i and (part.upright or parts[i - 1].upright):
            run.x += WORD_SPACE * SCALE[level]
        if part.upright:
            run.words(part.text, level)
        else:
            _set_name(run, part.text, level)
    return run
