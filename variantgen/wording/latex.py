"""Formulas as LaTeX math, without the dollar signs."""

from __future__ import annotations

from functools import lru_cache

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

_GREEK = {"epsilon": r"\varepsilon", "phi": r"\varphi"}  # the forms that the figures and the engine use
_ESCAPES = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#", "%": r"\%", "_": r"\_",
    "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "°": r"\textdegree{}", "\N{MINUS SIGN}": r"\textminus{}",
}  # fmt: skip
_ABOUT = {"modulus": r"\left|{}\right|", "angle": r"\angle({}, x)", "sense": r"\operatorname{{sgn}} {}"}


def escaped(text: str) -> str:
    """Text as LaTeX prints it, whatever characters it has."""
    return "".join(_ESCAPES.get(letter, letter) for letter in text)


@lru_cache(maxsize=10_000)
def to_latex(formula: Formula) -> str:
    r"""LaTeX math: ``\omega_{OA}``; numbers, units and words as text."""
    match formula:
        case Symbol(base, index, upper):
            scripts = (("_", index), ("^", upper))
            joined = [(sign, r"\,".join(_index(i) for i in parts)) for sign, parts in scripts if parts]
            return _base(base) + "".join(f"{sign}{{{text}}}" for sign, text in joined)
        case Number(text):
            return _number(text)
        case UnitText(parts):
            return "".join(_word(word) + (f"^{{{power}}}" if power != 1 else "") for word, power in parts)
        case Measured(number, unit):
            between = "" if unit.tight or not unit.parts else r"\,"
            return f"{to_latex(number)}{between}{to_latex(unit)}"
        case Equation(left, right):
            return f"{to_latex(left)} = {to_latex(right)}"
        case About(what, symbol):
            return _ABOUT[what].format(to_latex(symbol))
        case Listing(items):
            return ", ".join(to_latex(item) for item in items)


def _base(base: str) -> str:
    if base in GREEK:
        return _GREEK.get(base, rf"\{base}")
    if base.isdecimal():
        return base
    return " ".join(letter + (f"_{{{number}}}" if number else "") for letter, number in letters(base))


def _index(index: Index) -> str:
    return _word(index.text) if index.upright else _base(index.text)


def _number(text: str) -> str:
    return text.replace("\N{MINUS SIGN}", "-").replace(",", "{,}") if _is_plain(text) else _word(text)


def _is_plain(text: str) -> bool:
    return all(letter.isdecimal() or letter in ".,\N{MINUS SIGN}" for letter in text)


def _word(text: str) -> str:
    if text == "°":
        return r"^{\circ}"
    return rf"\text{{{escaped(text)}}}"
