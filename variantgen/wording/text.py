"""A text of a sheet in any format: a sequence of strings and formulas."""

from __future__ import annotations

from variantgen.wording.formula import Formula

Text = tuple[str | Formula, ...]


def with_steady_dashes(words: str) -> str:
    """The words with every dash on the line of the word before it: no line begins with a dash."""
    for dash in "\N{EM DASH}\N{EN DASH}":
        words = words.replace(f" {dash}", f"\N{NO-BREAK SPACE}{dash}")
    return words
