"""Formulas that are set here, by the glyph table of figures, and not by the typesetting engine.

The engine numbers every equation of a document, so what holds one is laid out anew wherever it stands. Letters at
places are numbered by nobody: the engine lays a name out once and finds it again on all sheets. They are the same
letters at the same places. Documents with tags have equations, which are read out.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from variantgen.figure.glyphs import STRETCHED, glyph, kerning
from variantgen.figure.letter_run import PlacedGlyph
from variantgen.figure.lettering import Lettering, typeset
from variantgen.outputs.typst.markup import Piece, TypstMarkup, marked
from variantgen.wording.formula import (
    Equation,
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
_LONGER = (Equation, Function, Measured, Number, Power, Product, Sum, Vector)
_LONGEST = 14.0  # em

_DIGITS = 4
_SIZE = (1.0, 0.7, 0.5)  # of formula, index, index of an index
_UNKNOWN = "°"  # stands for letters that the table does not have

# The space before it and up (em), size, the level that it is cut for, letters; of a sign that grows its name; of a bar
# its width. Neither takes room: what follows begins where it does.
Fragment = tuple[float, float, float, int, str] | tuple[float, float, str] | tuple[float, float, float]


class SetFormula(NamedTuple):
    """Width, lowest and highest ink (em), fragments, the width that is left after the last of them."""

    width: float
    lowest: float
    highest: float
    fragments: tuple[Fragment, ...]
    rest: float


def set_formulas(data: Any, longer: bool = False) -> dict[str, SetFormula]:
    """The formulas in the data of a document by their markup.

    ``longer`` sets products and sums too: for documents that break no formula.
    """
    return {
        str(found): made
        for found in marked(data)
        if type(found) is TypstMarkup and (made := _set(found.formulas, longer))
    }


def set_pieces(data: Any) -> dict[str, Any]:
    """The pieces of rows of formulas in the data by their markup, and the outlines of the signs in them."""
    pieces = {str(found): made for found in marked(data) if type(found) is Piece and (made := set_piece(found))}
    names = {part[2] for made in pieces.values() for part in made.fragments if isinstance(part[2], str)}
    return {"pieces": pieces, "signs": {name: _outline(name) for name in sorted(names)}}


def set_width(markup: TypstMarkup) -> float | None:
    """The width of a formula (em), or None for one that is left to the engine."""
    made = _set(markup.formulas)
    return made.width if made else None


def set_piece(piece: Piece) -> SetFormula | None:
    """A piece of a row, with fractions of full size; None for one that is left to the engine."""
    return _typeset(piece.formulas, display=True)


@lru_cache(maxsize=10_000)
def _set(formulas: tuple[Formula, ...], longer: bool = False) -> SetFormula | None:
    if not all(_is_set(formula) or (longer and isinstance(formula, (*_SET, *_LONGER))) for formula in formulas):
        return None
    found = _typeset(formulas if len(formulas) == 1 else (FormulaList(formulas),))
    return found if found and found.width <= _LONGEST else None


@lru_cache(maxsize=10_000)
def _typeset(formulas: tuple[Formula, ...], display: bool = False) -> SetFormula | None:
    try:
        found = typeset(*formulas, display=display)
    except (KeyError, TypeError):  # what the table has no letters for
        return None
    fragments, end = _fragments(found)
    unknown = "".join(part[-1] for part in fragments if isinstance(part[-1], str)).count(_UNKNOWN)
    if unknown != sum(to_plain(formula).count(_UNKNOWN) for formula in formulas):
        return None
    width, rest = _rounded(found.width), _rounded(found.width - end)
    return SetFormula(width, _rounded(found.bottom), _rounded(found.top), fragments, rest)


def _is_set(formula: Formula) -> bool:
    return isinstance(formula, _SET) and not (isinstance(formula, Symbol) and formula.base.startswith(ANGLE))


def _fragments(lettering: Lettering) -> tuple[tuple[Fragment, ...], float]:
    """The glyphs and bars of a formula, and where the last of them ends.

    Letters after each other are one fragment, which the engine spaces itself.
    """
    words: list[list[PlacedGlyph]] = []
    for placed in lettering.glyphs:
        if words and _follows(words[-1][-1], placed):
            words[-1].append(placed)
        else:
            words.append([placed])
    found: list[Fragment] = []
    end = 0.0
    for word in words:
        first, last = word[0], word[-1]
        if first.glyph.name[1] == STRETCHED:
            found.append((_rounded(first.at.real - end), _rounded(first.at.imag), first.glyph.name))
            end = first.at.real
        else:
            found.append(_letters(word, first.at.real - end))
            end = last.at.real + last.glyph.advance
    for bar in lettering.bars:
        found.append((_rounded(bar.at.real - end), _rounded(bar.at.imag), _rounded(bar.width)))
        end = bar.at.real
    return tuple(found), end


def _follows(before: PlacedGlyph, after: PlacedGlyph) -> bool:
    one, other = before.glyph, after.glyph
    if one.scale != other.scale or one.name[:2] != other.name[:2] or one.name[1] == STRETCHED:
        return False
    gap = one.advance
    if one.name[1] == "u":
        gap += one.scale * kerning(one.name[2:], other.name[2:])
    return abs(before.at + gap - after.at) < 1e-9


def _letters(word: Sequence[PlacedGlyph], gap: float) -> Fragment:
    glyph = word[0].glyph
    level, upright = int(glyph.name[0]), glyph.name[1] == "u"
    letters = "".join(placed.glyph.name[2:] for placed in word)
    place = (_rounded(gap), _rounded(word[0].at.imag))
    if upright:
        return (*place, glyph.scale, 0, letters)
    return (*place, _SIZE[level], level, "".join(map(italic, letters)))


def _rounded(length: float) -> float:
    return round(length, _DIGITS)


def _outline(name: str) -> list[list[Any]]:
    """The steps of the outline of a sign: kind and places (em), y down."""
    return [
        [kind, *([_rounded(point.real), _rounded(-point.imag)] for point in points)]
        for kind, points in glyph(name).steps
    ]


def italic(letter: str) -> str:
    """The letter as the alphabet of formulas has it."""
    for first, italic in (("A", 0x1D434), ("a", 0x1D44E), ("α", 0x1D6FC)):
        if letter.isalpha() and 0 <= ord(letter) - ord(first) < 26:
            return "\N{PLANCK CONSTANT}" if letter == "h" else chr(italic + ord(letter) - ord(first))
    return letter
