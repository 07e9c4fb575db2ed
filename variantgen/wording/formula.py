"""The formula tree: written once, rendered to every markup.

Names come from family files and are checked identifiers; numbers and units are text that is quoted on the way out.
Nothing that comes from a roster or an exam file is ever part of a formula.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "theta": "θ", "lambda": "λ",
    "mu": "μ", "rho": "ρ", "phi": "φ", "psi": "ψ", "omega": "ω", "tau": "τ", "sigma": "σ", "xi": "ξ", "eta": "η",
    "nu": "ν", "kappa": "κ", "chi": "χ", "pi": "π",
    "prime": "′",  # no letter, but a mark that the markups know by its name in the same way
}  # fmt: skip
_LETTERS = re.compile(r"([A-Za-z])(\d*)")


@dataclass(frozen=True)
class Index:
    """A part of an index: letters of points (italic) or a word (upright)."""

    text: str
    upright: bool = False


@dataclass(frozen=True)
class Symbol:
    """A letter with an index: ``omega`` with ``OA``, ``v`` with ``B`` and ``x``; the base may be a name like OA.

    ``upper`` is what stands above the index: the ``n`` or ``tau`` of a component of an acceleration.
    """

    base: str
    index: tuple[Index, ...] = ()
    upper: tuple[Index, ...] = ()


@dataclass(frozen=True)
class Number:
    """A number as it is printed in the language of the document."""

    text: str


@dataclass(frozen=True)
class UnitText:
    """A unit as it is printed: words with powers, ``(("см/с", 2),)``; ``tight`` if it follows without a space."""

    parts: tuple[tuple[str, int], ...]
    tight: bool = False


@dataclass(frozen=True)
class Measured:
    """A number with its unit."""

    number: Number
    unit: UnitText


@dataclass(frozen=True)
class Equation:
    """``left = right``."""

    left: Formula
    right: Formula


@dataclass(frozen=True)
class About:
    """What is asked of a symbol: its ``modulus``, its ``angle`` with the x axis, its ``sense``."""

    what: str
    symbol: Symbol


@dataclass(frozen=True)
class Listing:
    """Symbols one after the other with commas: points of a plan that coincide."""

    items: tuple[Symbol, ...]


Formula: TypeAlias = Symbol | Number | UnitText | Measured | Equation | About | Listing


_TYPST_ABOUT = {"modulus": "abs({})", "angle": "angle ({}, x)", "sense": 'op("sgn") {}'}
_PLAIN_ABOUT = {"modulus": "|{}|", "angle": "∠({}, x)", "sense": "sgn {}"}


def letters(text: str) -> list[tuple[str, str]]:
    """``O1A`` as letter and number pairs: ``[("O", "1"), ("A", "")]``."""
    return [(match[1], match[2]) for match in _LETTERS.finditer(text)]


@lru_cache(maxsize=10_000)
def to_typst(formula: Formula) -> str:
    """Typst math markup, without the dollar signs."""
    match formula:
        case Symbol(base, index, upper):
            scripts = (("_", index), ("^", upper))
            return _typst_base(base) + "".join(
                f"{sign}({' '.join(_typst_index(i) for i in parts)})" for sign, parts in scripts if parts
            )
        case Number(text):
            return _quoted(text)
        case UnitText(parts):
            return " ".join(
                _quoted(word) + (f"^({_quoted(_power(power))})" if power != 1 else "") for word, power in parts
            )
        case Measured(number, unit):
            if unit.tight:
                return _quoted(number.text + "".join(word for word, _ in unit.parts))
            return f"{to_typst(number)} thin {to_typst(unit)}" if unit.parts else to_typst(number)
        case Equation(left, right):
            return f"{to_typst(left)} = {to_typst(right)}"
        case About(what, symbol):
            return _TYPST_ABOUT[what].format(to_typst(symbol))
        case Listing(items):
            return ", ".join(to_typst(item) for item in items)


def _typst_base(base: str) -> str:
    if base in GREEK or base.isdecimal():
        return base
    return " ".join(letter + (f"_({number})" if number else "") for letter, number in letters(base))


def _typst_index(index: Index) -> str:
    return _quoted(index.text) if index.upright else _typst_base(index.text)


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _power(power: int) -> str:
    return str(power).replace("-", "\N{MINUS SIGN}")


def to_plain(formula: Formula) -> str:
    """Plain text: ``ω_OA = 3 рад/с²``."""
    match formula:
        case Symbol(base, index, upper):
            scripts = (("^", upper), ("_", index))
            return GREEK.get(base, base) + "".join(
                sign + " ".join(GREEK.get(i.text, i.text) for i in parts) for sign, parts in scripts if parts
            )
        case Number(text):
            return text
        case UnitText(parts):
            return " ".join(word + (_superscript(power) if power != 1 else "") for word, power in parts)
        case Measured(number, unit):
            return to_plain(number) + ("" if unit.tight or not unit.parts else "\N{NO-BREAK SPACE}") + to_plain(unit)
        case About(what, symbol):
            return _PLAIN_ABOUT[what].format(to_plain(symbol))
        case Equation(left, right):
            return f"{to_plain(left)} = {to_plain(right)}"
        case Listing(items):
            return ", ".join(to_plain(item) for item in items)


def _superscript(power: int) -> str:
    return str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
