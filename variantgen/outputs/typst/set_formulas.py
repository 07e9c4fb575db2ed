"""Formulas that are set here, by the glyph table of figures, and not by the typesetting engine.

The engine numbers every equation of a document, so what holds one is laid out anew wherever it stands. Letters at
places are numbered by nobody: the engine lays a name out once and finds it again on all sheets. They are the same
letters at the same places. Documents with tags have equations, which are read out.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from variantgen.figure.letters.letter_run import UNKNOWN
from variantgen.figure.letters.lettering import lettering
from variantgen.outputs.typst.fragments import Fragment, FragmentTable, PlacedMark, fragments_of, rounded
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
)
from variantgen.wording.formula.tree import ANGLE

# Others are left to the engine: some of them may be broken into lines, for some figures have no letters.
_SET = (Symbol, UnitText, SymbolProperty)
_LONGER = (Equation, Function, Measured, Number, Power, Product, Sum, Vector)
_LONGEST = 14.0  # em


class SetFormula(NamedTuple):
    """Width, lowest and highest ink (em), fragments, the width that is left after the last of them.

    ``marks`` are signs that grow and bars, where they are no fragments.
    """

    width: float
    lowest: float
    highest: float
    fragments: tuple[Fragment, ...]
    rest: float
    marks: tuple[PlacedMark, ...] = ()


def set_formulas(data: Any) -> dict[str, SetFormula]:
    """The formulas in the data of a document by their markup, but for those that it may break into lines."""
    return {str(found): made for found in marked(data) if type(found) is TypstMarkup and (made := _set(found.formulas))}


def numbered(formulas: Mapping[str, SetFormula], table: FragmentTable) -> dict[str, Sequence[Any]]:
    """The same for templates, with the numbers of fragments."""
    return {
        name: (width, lowest, highest, table.numbers(fragments), rest)
        for name, (width, lowest, highest, fragments, rest, *_) in formulas.items()
    }


def set_width(markup: TypstMarkup) -> float | None:
    """The width of a formula (em), or None for one that is left to the engine."""
    made = _set(markup.formulas)
    return made.width if made else None


def set_longer(markup: TypstMarkup) -> SetFormula | None:
    """A formula, also a product or a sum, in a document that breaks none; None for one that is left to the engine."""
    return _set(markup.formulas, longer=True)


@lru_cache(maxsize=10_000)
def set_piece(piece: Piece) -> SetFormula | None:
    """A piece of a row, with fractions of full size and its marks apart; None for one that is left to the engine."""
    return _typeset(piece.formulas, display=True, apart=True)


def set_whole_piece(piece: Piece) -> SetFormula | None:
    """The same with its marks among the letters, for rows that are measured."""
    return _typeset(piece.formulas, display=True)


@lru_cache(maxsize=10_000)
def set_label(markup: TypstMarkup) -> SetFormula | None:
    """A label of a figure; None for one that is left to the engine."""
    return _typeset(markup.formulas)


@lru_cache(maxsize=10_000)
def _set(formulas: tuple[Formula, ...], longer: bool = False) -> SetFormula | None:
    if not all(_is_set(formula) or (longer and isinstance(formula, (*_SET, *_LONGER))) for formula in formulas):
        return None
    found = _typeset(formulas if len(formulas) == 1 else (FormulaList(formulas),))
    return found if found and found.width <= _LONGEST else None


def _typeset(formulas: tuple[Formula, ...], display: bool = False, apart: bool = False) -> SetFormula | None:
    try:
        found = lettering(formulas, display)
    except (KeyError, TypeError):  # what the table has no letters for
        return None
    if any(glyph.name == UNKNOWN for letters, _ in found.letters for glyph in letters.glyphs):
        return None
    marks: list[PlacedMark] | None = [] if apart else None
    fragments, end = fragments_of(found, marks)
    width, rest = rounded(found.width), rounded(found.width - end)
    return SetFormula(width, rounded(found.bottom), rounded(found.top), fragments, rest, tuple(marks or ()))


def _is_set(formula: Formula) -> bool:
    return isinstance(formula, _SET) and not (isinstance(formula, Symbol) and formula.base.startswith(ANGLE))
