"""Formulas as HTML: letters in italics, indices below, powers above."""

from __future__ import annotations

from functools import lru_cache
from html import escape

from variantgen.wording.formula import (
    GREEK,
    About,
    Equation,
    Formula,
    Index,
    Listing,
    Measured,
    Number,
    Symbol,
    UnitText,
    letters,
)

_ABOUT = {"modulus": "|{}|", "angle": "∠({}, <i>x</i>)", "sense": "sgn\N{NO-BREAK SPACE}{}"}


@lru_cache(maxsize=10_000)
def to_html(formula: Formula) -> str:
    """Markup of a formula, as it stands inside a line of text."""
    match formula:
        case Symbol(base, index, upper):
            scripts = (("sup", upper), ("sub", index))
            raised = [(tag, "\N{THIN SPACE}".join(map(_index, parts))) for tag, parts in scripts if parts]
            return _base(base) + "".join(f"<{tag}>{text}</{tag}>" for tag, text in raised)
        case Number(text):
            return escape(text)
        case UnitText(parts):
            return " ".join(
                escape(word) + (f"<sup>{_power(power)}</sup>" if power != 1 else "") for word, power in parts
            )
        case Measured(number, unit):
            return to_html(number) + ("" if unit.tight or not unit.parts else "\N{NO-BREAK SPACE}") + to_html(unit)
        case Equation(left, right):
            return f"{to_html(left)}\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}{to_html(right)}"
        case About(what, symbol):
            return _ABOUT[what].format(to_html(symbol))
        case Listing(items):
            return ", ".join(to_html(item) for item in items)


def _base(base: str) -> str:
    if base in GREEK:
        return f"<i>{GREEK[base]}</i>"
    if base.isdecimal():
        return base
    return "".join(f"<i>{letter}</i>" + (f"<sub>{number}</sub>" if number else "") for letter, number in letters(base))


def _index(index: Index) -> str:
    return escape(index.text) if index.upright else _base(index.text)


def _power(power: int) -> str:
    return str(power).replace("-", "\N{MINUS SIGN}")
