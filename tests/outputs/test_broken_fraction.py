"""Fractions too wide for a column stand in the line, in pieces between which it may be broken."""

from __future__ import annotations

from variantgen.outputs.typst.broken_fraction import in_the_line
from variantgen.wording.formula import Absolute, Formula, Fraction, Number, Power, Sum, Symbol

ABOVE = Sum(((-1, Number("2")), (1, Symbol("b")), (-1, Number("5"))))


def said(formula: Formula) -> list[tuple[str, str]]:
    """What is read out of each piece, with the sign before it."""
    return [(sign, markup.plain) for sign, markup in in_the_line("=", formula)]


def test_a_quotient_is_broken_before_the_terms_of_its_sum() -> None:
    below = Sum(((1, Symbol("c")), (1, Symbol("d"))))
    assert said(Fraction(ABOVE, Symbol("c"))) == [("=", "(−2"), ("+", "b"), ("−", "5)/c")]
    assert said(Fraction(ABOVE, below)) == [("=", "(−2"), ("+", "b"), ("−", "5)/(c + d)")]


def test_strokes_of_a_modulus_stand_about_the_sum_only_over_a_square() -> None:
    square = Absolute(Fraction(ABOVE, Power(Symbol("c"), 2)))
    assert said(square) == [("=", "|−2"), ("+", "b"), ("−", "5|/c^2")]
    assert len(said(Absolute(Fraction(ABOVE, Symbol("c"))))) == 1


def test_what_has_no_sum_above_is_one_piece() -> None:
    assert len(said(Fraction(Number("2"), Symbol("c")))) == len(said(ABOVE)) == 1
