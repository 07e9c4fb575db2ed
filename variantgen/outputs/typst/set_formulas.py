"""Formulas that are set here, by the glyph table of figures, and not by the typesetting engine.

The engine numbers every equation of a document, so what holds one is laid out anew wherever it stands. Letters at
places are numbered by nobody: the engine lays a name out once and finds it again on all sheets. They are the same
letters at the same places. Documents with tags have equations, which are read out.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

from variantgen.figure.glyphs import kerning
from variantgen.figure.letter_run import PlacedGlyph
from variantgen.figure.lettering import Lettering, typeset
from variantgen.outputs.typst.markup import TypstMarkup, marked
from variantgen.wording.formula import (
    Formula,
    FormulaList,
    Function,
    Measured,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    SymbolProperty,
    UnitText,
    Vector,
    to_plain,
)
from variantgen.wording.formula.tree import ANGLE

# Others are left to the engine: some of them may be broken into lines, for some figures have no letters.
_SET = (Symbol, UnitText, SymbolProperty)
_LONGER = (Function, Measured, Number, Power, Product, Sum, Vector)
_LONGEST = 14.0  # em

_DIGITS = 4
_SIZE = (1.0, 0.7, 0.5)  # of formula, index, index of an index
_UNKNOWN = "°"  # stands for letters that the table does not have

# The space before it and up (em), size, the level that it is cut for, letters.
Fragment = tuple[float, float, float, int, str]


def set_formulas(data: Any, longer: bool = False) -> dict[str, Any]:
    """The formulas in the data of a document by their markup: width, lowest and highest ink (em), pieces.

    ``longer`` sets products and sums too: for documents that break no formula.
    """
    return {str(found): made for found in marked(data) if (made := _set(found.formulas, longer))}


def set_width(markup: TypstMarkup) -> float | None:
    """The width of a formula (em), or None for one that is left to the engine."""
    made = _set(markup.formulas)
    return made[0] if made else None


@lru_cache(maxsize=10_000)
def _set(
    formulas: tuple[Formula, ...], longer: bool = False
) -> tuple[float, float, float, tuple[Fragment, ...]] | None:
    if not all(_is_set(formula) or (longer and isinstance(formula, (*_SET, *_LONGER))) for formula in formulas):
        return None
    whole = formulas[0] if len(formulas) == 1 else FormulaList(formulas)
    try:
        found = typeset(whole)
    except (KeyError, TypeError):  # a fraction in it, a letter without an arrow
        return None
    if found.width > _LONGEST:
        return None
    pieces = _pieces(found)
    if "".join(piece[-1] for piece in pieces).count(_UNKNOWN) != to_plain(whole).count(_UNKNOWN):
        return None
    return round(found.width, _DIGITS), round(found.bottom, _DIGITS), round(found.top, _DIGITS), pieces


def _is_set(formula: Formula) -> bool:
    return isinstance(formula, _SET) and not (isinstance(formula, Symbol) and formula.base.startswith(ANGLE))


def _pieces(lettering: Lettering) -> tuple[Fragment, ...]:
    """The glyphs of a formula; letters after each other are one piece, which the engine spaces itself."""
    words: list[list[PlacedGlyph]] = []
    for placed in lettering.glyphs:
        if words and _follows(words[-1][-1], placed):
            words[-1].append(placed)
        else:
            words.append([placed])
    ends = [0.0, *(word[-1].at.real + word[-1].glyph.advance for word in words)]
    return tuple(_piece(word, word[0].at.real - end) for word, end in zip(words, ends, strict=False))


def _follows(before: PlacedGlyph, after: PlacedGlyph) -> bool:
    one, other = before.glyph, after.glyph
    if one.scale != other.scale or one.name[:2] != other.name[:2]:
        return False
    gap = one.advance
    if one.name[1] == "u":
        gap += one.scale * kerning(one.name[2:], other.name[2:])
    return abs(before.at + gap - after.at) < 1e-9


def _piece(word: Sequence[PlacedGlyph], gap: float) -> Fragment:
    glyph = word[0].glyph
    level, upright = int(glyph.name[0]), glyph.name[1] == "u"
    letters = "".join(placed.glyph.name[2:] for placed in word)
    place = (round(gap, _DIGITS), round(word[0].at.imag, _DIGITS))
    if upright:
        return (*place, glyph.scale, 0, letters)
    return (*place, _SIZE[level], level, "".join(map(italic, letters)))


def italic(letter: str) -> str:
    """The letter as the alphabet of formulas has it."""
    for first, italic in (("A", 0x1D434), ("a", 0x1D44E), ("α", 0x1D6FC)):
        if letter.isalpha() and 0 <= ord(letter) - ord(first) < 26:
            return "\N{PLANCK CONSTANT}" if letter == "h" else chr(italic + ord(letter) - ord(first))
    return letter
