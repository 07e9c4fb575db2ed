"""A text of a sheet in any format: a sequence of strings and formulas."""

from __future__ import annotations

import re

from variantgen.wording.formula import Formula, Symbol
from variantgen.wording.formula.tree import GREEK

Text = tuple[str | Formula, ...]

_GREEK = {sign: name for name, sign in GREEK.items()}
_LETTER = re.compile(r"(?<![\w'’])([A-Z]+|[b-zα-ω])(?![\w'’])")  # letters of a quantity or of points, in a sentence


def with_steady_dashes(words: str) -> str:
    """The words with every dash on the line of the word before it: no line begins with a dash."""
    for dash in "\N{EM DASH}\N{EN DASH}":
        words = words.replace(f" {dash}", f"\N{NO-BREAK SPACE}{dash}")
    return words


def with_steady_letters(text: Text) -> Text:
    """The text with every letter of a point, body or quantity on the line of the word before it."""
    following = (*text[1:], "")
    return tuple(
        f"{part[:-1]}\N{NO-BREAK SPACE}"
        if isinstance(part, str) and part.endswith(" ") and isinstance(after, Symbol)
        else part
        for part, after in zip(text, following, strict=True)
    )


def with_symbols(note: str) -> Text:
    """A note with its letters of quantities and points as formulas; the English article ``a`` is none."""
    parts = enumerate(_LETTER.split(note))
    return tuple(Symbol(_GREEK.get(part, part)) if place % 2 else part for place, part in parts if part)
