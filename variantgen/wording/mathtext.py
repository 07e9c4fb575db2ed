"""Formulas in the mathematical markup of matplotlib (a small part of TeX between dollar signs)."""

from __future__ import annotations

from collections.abc import Sequence

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

# The variants that print as the letters of the rest of a sheet: ε and φ.
_VARIANTS = {"epsilon": r"\varepsilon", "phi": r"\varphi"}
_ABOUT = {"modulus": "|{}|", "angle": r"\angle({},\,x)", "sense": r"\mathrm{{sgn}}\,{}"}
# What has a meaning in the markup, as what prints it.
_SPECIAL = {
    "\\": "\N{SET MINUS}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "%": r"\%",
    "_": r"\_",
    "#": "\N{MUSIC SHARP SIGN}",
    "^": "\N{LOGICAL AND}",
    "~": "\N{TILDE OPERATOR}",
    "'": "\N{PRIME}",
    '"': "\N{DOUBLE PRIME}",
    " ": r"\;",
    "\N{NO-BREAK SPACE}": r"\;",
}


def to_mathtext(formula: Formula) -> str:
    """Markup of a formula, with the dollar signs: ``$v_{B}$``; text in it is quoted. There are no spaces in it."""
    return f"${_inner(formula)}$"


def _inner(formula: Formula) -> str:
    match formula:
        case Symbol(base, index, upper):
            return _base(base) + _script("_", index) + _script("^", upper)
        case Number(text):
            # A comma alone would be set with a space after it, as between two numbers.
            return "".join("{,}" if letter == "," else _SPECIAL.get(letter, letter) for letter in text)
        case UnitText(parts):
            return r"\,".join(_upright(word) + (f"^{{{power}}}" if power != 1 else "") for word, power in parts)
        case Measured(number, unit):
            return _inner(number) + ("" if unit.tight or not unit.parts else r"\,") + _inner(unit)
        case Equation(left, right):
            return f"{_inner(left)}={_inner(right)}"
        case About(what, symbol):
            return _ABOUT[what].format(_inner(symbol))
        case Listing(items):
            return r",\,".join(_inner(item) for item in items)


def _base(name: str) -> str:
    if name in GREEK:
        return _VARIANTS.get(name, f"\\{name}")
    if name.isdecimal():
        return name
    return "".join(letter + (f"_{{{number}}}" if number else "") for letter, number in letters(name))


def _script(sign: str, parts: Sequence[Index]) -> str:
    if not parts:
        return ""
    words = r"\,".join(_upright(part.text) if part.upright else _base(part.text) for part in parts)
    return f"{sign}{{{words}}}"


def _upright(word: str) -> str:
    return r"\mathrm{" + "".join(_SPECIAL.get(letter, letter) for letter in word) + "}"
