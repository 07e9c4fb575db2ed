"""Formulas for the typesetting templates: markup that knows how the formula reads in plain text.

Tagged documents have the plain text beside the markup, for programs that read aloud; others never ask for it.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from variantgen.outputs.typst.fragments import FragmentTable
from variantgen.wording.formula import Formula, UnitText, to_plain, to_typst


class TypstMarkup(str):
    """Typst math markup of one formula, or of several after each other."""

    __slots__ = ("formulas",)
    formulas: tuple[Formula, ...]

    def __new__(cls, text: str, *formulas: Formula) -> TypstMarkup:
        """Markup that says the formulas."""
        made = super().__new__(cls, text)
        made.formulas = formulas
        return made

    @property
    def plain(self) -> str:
        """The same as plain text."""
        return ", ".join(map(to_plain, self.formulas))


class Piece(TypstMarkup):
    """Markup of a piece of a formula on a line of its own, with fractions of full size; its formulas are one row."""

    __slots__ = ()

    @property
    def plain(self) -> str:
        """The same as plain text."""
        return "".join(map(to_plain, self.formulas))


class Lettered:
    """What documents without tags have as letters at their places, and others with the markup of formulas."""

    __slots__ = ()

    def data(self, letters: bool, table: FragmentTable | None = None) -> Any:
        """The data for templates; fragments by their numbers in the ``table`` of the document, if it has one."""
        raise NotImplementedError


@lru_cache(maxsize=10_000)
def markup(formula: Formula) -> TypstMarkup:
    """A formula."""
    return TypstMarkup(to_typst(formula), formula)


@lru_cache(maxsize=10_000)
def piece(formula: Formula) -> Piece:
    """A formula as it stands on a line of its own."""
    text = to_typst(formula)
    tall = "frac(" in text or "sqrt(" in text
    return Piece(f"display({text})" if tall else text, formula)


def heading(symbol: Formula, unit: UnitText) -> TypstMarkup:
    """The head of a column of answers: ``v_B, cm/s``."""
    if not unit.parts:
        return markup(symbol)
    return TypstMarkup(f"{to_typst(symbol)}, thin {to_typst(unit)}", symbol, unit)


def alternatives(data: Any) -> dict[str, str]:
    """All markup in the data of a document with tags, with the plain text of each."""
    return {str(found): found.plain for found in marked(data, everywhere=True)}


def marked(data: Any, everywhere: bool = False) -> list[TypstMarkup]:
    """All markup in the data of a document, each once; ``everywhere``: also of what others have as letters."""
    found: dict[tuple[type, str], TypstMarkup] = {}
    waiting: list[Any] = [data]
    while waiting:
        item = waiting.pop()
        kind = type(item)  # most pieces are plain text and numbers
        if kind is TypstMarkup or kind is Piece:
            found.setdefault((kind, item), item)
        elif kind is dict:
            waiting.extend(item.values())
        elif kind is list or kind is tuple:
            waiting.extend(item)
        elif everywhere and isinstance(item, Lettered):
            waiting.append(item.data(letters=False))
    return list(found.values())
