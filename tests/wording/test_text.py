"""Texts with symbols: what has to stay on one line."""

from __future__ import annotations

from variantgen.wording.formula import Index, Symbol
from variantgen.wording.text import with_steady_letters

SPEED = Symbol("v", (Index("B"),))


def test_a_letter_stays_on_the_line_of_the_word_before_it() -> None:
    heading = ("Ускорение точки ", Symbol("M"), " звена ", Symbol("AB"))
    assert with_steady_letters(heading) == (
        "Ускорение точки\N{NO-BREAK SPACE}", Symbol("M"), " звена\N{NO-BREAK SPACE}", Symbol("AB"),
    )  # fmt: skip


def test_nothing_else_is_held_together() -> None:
    for text in (("Geometry",), (SPEED, " is asked "), ("(", SPEED, ")"), ("a ", "b")):
        assert with_steady_letters(text) == text
