"""How the letters of a formula stand, as the typesetting engine sets them: places of glyphs and bars, width, ink.

The rules are those of the OpenType math table with the constants of New Computer Modern Math: an index is lowered, an
upper index raised, both moved apart until a gap is left between them; some space follows. Lengths in em, the size of
the lettering of the figure.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache

from msgspec import Struct

from variantgen.figure.drawing import LETTER, Label
from variantgen.figure.letters.glyphs import Glyph
from variantgen.figure.letters.letter_run import Bar, PlacedGlyph, PlacedLetters, Run, digits, script, set_name
from variantgen.figure.letters.tall_letters import enclosed, fraction, root
from variantgen.wording.formula import (
    Absolute,
    Equation,
    Formula,
    FormulaList,
    Fraction,
    Function,
    Measured,
    Number,
    Parenthesised,
    Power,
    Product,
    Quotient,
    Root,
    Sum,
    Surd,
    Symbol,
    SymbolProperty,
    UnitText,
    Vector,
    precedence,
)
from variantgen.wording.formula.precedence import Between
from variantgen.wording.formula.tree import ANGLE

_PARENTHESES = 0.79  # as high as a formula may be between parentheses of a line
_THIN, _AROUND_EQUALS, _AROUND_SIGN = 1 / 6, 5 / 18, 2 / 9
ARROWS = {"v": 0.558, "a": 0.551, "r": 0.511, "omega": 0.609}  # where the arrow above a letter stands


class Lettering(Struct, frozen=True):
    """A set formula: its letters and bars, its width, and the bounds of its ink above the baseline (em)."""

    letters: tuple[PlacedLetters, ...]
    width: float
    bottom: float
    top: float
    bars: tuple[Bar, ...] = ()

    @property
    def glyphs(self) -> list[PlacedGlyph]:
        """Its letters one by one."""
        return [
            PlacedGlyph(glyph, at + place)
            for letters, at in self.letters
            for glyph, place in zip(letters.glyphs, letters.places, strict=True)
        ]


def lettering(formulas: Iterable[Formula], display: bool = False) -> Lettering:
    """The lettering of formulas in a row; ``display`` as in a line of its own, with fractions of full size and roots.

    Raises TypeError for a kind that has no letters, as fractions in a line of text.
    """
    run = Run(display)
    for formula in formulas:
        _set(run, formula)
    return Lettering(tuple(run.letters), run.x, run.bottom, run.top, tuple(run.bars))


@lru_cache(maxsize=10_000)
def typeset(formula: Formula) -> Lettering:
    """The lettering of a formula in a figure, which has many others with the same. Raises TypeError as above."""
    return lettering((formula,))


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
        case Power(base, exponent) if 0 <= exponent <= 9:
            _set_power(run, base, str(exponent))
        case Function(name, argument):
            run.words(name)
            _set_argument(run, argument)
        case _:
            _set_tall(run, formula)


def _set_tall(run: Run, formula: Formula) -> None:
    """What may be taller than a line of text. Raises TypeError for what has no letters, or none in such a line."""
    match formula:
        case Parenthesised(content):
            _set_part(run, content, True)
        case Absolute(content):
            _set_enclosed(run, content, "||")
        case Fraction(above, below) if run.display:
            run.append(fraction(_inner(above, run.cramped, False), _inner(below, True, False)))
        case Root(radicand) if run.tall:
            run.append(root(_inner(radicand, True, run.display)))
        case Surd() if run.display:
            _set_surd(run, formula)
        case _:
            raise TypeError(f"no letters are known for a formula of the kind {type(formula).__name__}")


def _set_symbol(run: Run, symbol: Symbol, exponent: str = "", arrow: bool = False) -> None:
    """A letter with its indices, an arrow above it, and an exponent: that of a letter in parentheses is theirs."""
    above = digits(exponent, 1) if exponent else Run()
    if symbol.part:
        run.add("(", 0)
    if symbol.base.startswith(ANGLE):
        run.add("∠", 0)
    if arrow:
        run.mark(run.x + ARROWS[symbol.base])
    set_name(run, symbol.base.removeprefix(ANGLE), 0)
    upper = script(symbol.upper, 1) if symbol.upper or symbol.part else above
    if symbol.index or upper.letters:
        run.attach(script(symbol.index, 1), upper, 0)
    if symbol.part:
        run.add(")", 0)
        run.attach(script(symbol.part, 1), above, 0)


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
    """A part of a formula, perhaps in parentheses."""
    if parentheses:
        _set_enclosed(run, formula, "()")
    else:
        _set(run, formula)


def _set_enclosed(run: Run, formula: Formula, signs: str) -> None:
    """A formula between two signs. Raises TypeError where they would be taller than a line of text."""
    content = Run(run.display, run.cramped, run.tall)
    _set(content, formula)
    if not run.tall and max(content.top, 0.5 - content.bottom) > _PARENTHESES:
        raise TypeError("tall parentheses are no letters")
    run.append(enclosed(content, *signs))


def _inner(formula: Formula, cramped: bool, display: bool) -> Run:
    """A part of a fraction or a root; a fraction in a fraction would be smaller and raises TypeError."""
    run = Run(display, cramped, tall=True)
    _set(run, formula)
    return run


def _set_power(run: Run, base: Formula, exponent: str) -> None:
    """A base with a digit above it."""
    match base:
        case Function(name, argument):  # cos² φ
            run.words(name)
            run.attach(Run(), digits(exponent, 1), 0)
            _set_argument(run, argument)
        case Symbol() if not precedence.as_base(base, False):
            _set_symbol(run, base, exponent)
        case Vector(symbol) if not precedence.as_base(base, False):
            _set_symbol(run, symbol, exponent, arrow=True)
        case _:
            whole = Run(run.display, run.cramped, run.tall)
            fenced = precedence.as_base(base, False) or isinstance(base, Parenthesised)
            _set_part(whole, base, precedence.as_base(base, False))
            run.append(whole)
            run.attach(Run(), digits(exponent, 1), 0, whole.top if fenced or whole.bars else 0.0)


def _set_argument(run: Run, argument: Formula) -> None:
    """The argument of a function after its name; parentheses follow without a space."""
    parentheses = precedence.as_argument(argument)
    if not (parentheses or isinstance(argument, Parenthesised)):
        run.x += _THIN
    _set_part(run, argument, parentheses)


def _set_surd(run: Run, surd: Surd) -> None:
    """``40√3/3``: a number and a root above a whole number."""
    size, root_of = Number(str(abs(surd.numerator))), Root(Number(str(surd.radicand)))
    if surd.numerator < 0:
        run.words("\N{MINUS SIGN}")
    above = Run(surd.denominator == 1, run.cramped, tall=True)
    if abs(surd.numerator) != 1 or surd.radicand == 1:
        _set(above, size)
    if surd.radicand != 1:
        _set(above, root_of)
    run.append(above if surd.denominator == 1 else fraction(above, _inner(Number(str(surd.denominator)), True, False)))


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
