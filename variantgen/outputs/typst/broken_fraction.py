"""Fractions that are too wide for a column: in the line, so that they may be broken before each term above."""

from __future__ import annotations

from variantgen.outputs.typst.markup import Piece, piece
from variantgen.wording.formula import (
    Absolute,
    Formula,
    Fraction,
    Number,
    Parenthesised,
    Power,
    Sum,
    to_typst,
)
from variantgen.wording.formula.precedence import as_denominator

_SIGNS = {1: "+", -1: "\N{MINUS SIGN}"}
_FENCES = {"()": ("\\(", "\\)"), "||": ('class("opening", bar.v)', 'class("closing", bar.v)')}


def in_the_line(sign: str, formula: Formula) -> list[tuple[str, Piece]]:
    """``= (a + b)/c`` in pieces, one for each term of the sum above; what is no such fraction is one piece.

    The modulus of a fraction above a square is that of the sum. Each piece has the sign before it.
    """
    whole, around = _without_modulus(formula)
    if not isinstance(whole, Fraction) or not isinstance(whole.numerator, Sum) or len(whole.numerator.terms) < 2:
        return [(sign, piece(formula))]
    start, *middle, (last_sign, end) = whole.numerator.terms
    first, last = Sum((start,)), Sum(((1, end),))  # sums have the parentheses that terms need
    below = Parenthesised(whole.denominator) if as_denominator(whole.denominator, True) else whole.denominator
    opening, closing = _FENCES[around]
    opened = Piece(f"{opening} {to_typst(first)}", Number(around[0]), first)
    closed = Piece(f"{to_typst(last)} {closing}\\/{to_typst(below)}", last, Number(f"{around[1]}/"), below)
    inner = [(_SIGNS[own], piece(Sum(((1, term),)))) for own, term in middle]
    return [(sign, opened), *inner, (_SIGNS[last_sign], closed)]


def _without_modulus(formula: Formula) -> tuple[Formula, str]:
    """A fraction and what stands around the sum above it: the strokes of its modulus where it is above a square."""
    if not isinstance(formula, Absolute) or not isinstance(formula.content, Fraction):
        return formula, "()"
    return (formula.content, "||") if isinstance(formula.content.denominator, Power) else (formula, "()")
