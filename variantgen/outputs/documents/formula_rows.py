"""Formulas of a solution as rows: short ones share a row, long sums may be broken before each term."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from variantgen.wording.formula import GREEK, Formula, Fraction, Sum, to_plain, to_typst
from variantgen.wording.solution.document import FormulaLine

Pieces = list[tuple[str, Formula]]  # a formula as pieces that hold together, with the sign before each

# Letters, by which widths are guessed: what a row of the page holds, and what a piece may have before
# its sum is cut.
_ROW, _PIECE = 100, 36
_GAP = 6
# What of the markup takes no room by itself, and what is one letter.
_SILENT = re.compile(r'frac|sqrt|arrow|op|dot\.|thin|abs|display|["_^(){}\s]')
_NAMES = re.compile("|".join((*GREEK, "angle", "perp", "parallel")))
_SIGNS = {1: "+", -1: "\N{MINUS SIGN}"}


def rows(lines: Sequence[FormulaLine]) -> Iterator[list[Pieces]]:
    """Rows of formulas; those that fit beside each other share a row."""
    row: list[Pieces] = []
    room = _ROW
    for line in lines:
        pieces, length = _pieces(line)
        if row and length > room:
            yield row
            row, room = [], _ROW
        row.append(pieces)
        room -= length
    if row:
        yield row


@lru_cache(maxsize=10_000)
def _letters(formula: Formula) -> int:
    """About how wide a formula is, in letters; a fraction counts half of what stands above and below."""
    markup = to_typst(formula)
    letters = len(_SILENT.sub("", _NAMES.sub("x", markup)))
    return letters // 2 if markup.startswith("frac(") else letters


def breadth(formula: Formula) -> int:
    """How many letters a formula has beside each other; of a fraction, its longer part."""
    parts = (formula.numerator, formula.denominator) if isinstance(formula, Fraction) else (formula,)
    return max(sum(1 for letter in to_plain(part) if letter not in "_^" and not letter.isspace()) for part in parts)


def _pieces(line: FormulaLine) -> tuple[Pieces, int]:
    """The pieces of a formula and their width in letters. A long sum may be broken before each of its terms."""
    found: Pieces = []
    length = _GAP
    for sign, formula in line.pieces:
        own: Pieces = [(sign, formula)]
        letters = _letters(formula)
        if letters > _PIECE and isinstance(formula, Sum) and len(formula.terms) > 1:
            own = list(_terms(sign, formula))
            letters = sum(_letters(term) for _, term in own)
        found += own
        length += letters + sum(len(before) + 2 for before, _ in own)
    return found, length


def _terms(sign: str, formula: Sum) -> Iterator[tuple[str, Formula]]:
    """The terms of a sum, the first with the sign of the line, the others with their own.

    A term is a sum of itself, so that it has the parentheses that the sum would put.
    """
    for number, (own, term) in enumerate(formula.terms):
        if number == 0:
            yield sign, Sum(((own, term),))
        else:
            yield _SIGNS[own], Sum(((1, term),))
