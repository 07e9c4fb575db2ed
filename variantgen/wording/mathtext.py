"""Formulas in the mathematical markup of matplotlib (a small part of TeX between dollar signs)."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.wording.formula.markup import Mark, Signs
from variantgen.wording.formula.precedence import Between
from variantgen.wording.formula.tex import TexMarkup, marked
from variantgen.wording.formula.tree import ANGLE, GREEK, Formula, Index, Symbol, UnitText, letters

# The variants that print as the letters of the rest of a sheet: ε and φ.
_VARIANTS = {"epsilon": r"\varepsilon", "phi": r"\varphi"}
_ABOUT = {"modulus": "|{}|", "angle": r"\angle({},\,x)", "sense": r"\mathrm{{sgn}}\,{}"}
_SIGNS = {"′": "'", "∥": r"\parallel{}", "⟂": r"\perp{}"}
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
    "`": "\N{REVERSED PRIME}",
    " ": r"\;",
    "\N{NO-BREAK SPACE}": r"\;",
}
# In groups: a comma alone would be set with a space after it, a minus as if something were before it.
_NUMERAL = {**_SPECIAL, ",": "{,}", "\N{MINUS SIGN}": "{\N{MINUS SIGN}}"}


def to_mathtext(formula: Formula) -> str:
    """Markup of a formula, with the dollar signs: ``$v_{B}$``; text in it is quoted. There are no spaces in it."""
    return f"${_MATHTEXT.write(formula)}$"


class _Mathtext(TexMarkup):
    """The part of TeX that matplotlib knows; an empty group ends the name of a sign, since there are no spaces."""

    flat = False
    signs = Signs(
        minus="{-}",  # in a group, or else it is taken for a sign between terms after any but a few characters
        terms={1: "+", -1: "-"},
        factors={Between.DOT: r"\cdot{}", Between.THIN: r"\,", Between.OPERATOR: r"\,"},
        cross=r"\times{}",
        equals="=",
        relations={
            "=": "=",
            "≈": r"\approx{}",
            "<": "<",
            "≤": r"\leq{}",
            "≥": r"\geq{}",
            "→": r"\to{}",
            "∥": r"\parallel{}",
            "⟂": r"\perp{}",
        },
        comma=r",\,",
        semicolon=";",
        before_unit=r"\,",
    )

    def letter(self, symbol: Symbol, exponent: int | None, mark: Mark) -> str:
        letter = marked(_base(symbol.base), symbol, mark) + _script("_", symbol.index) + _script("^", symbol.upper)
        return letter if exponent is None else self.power(letter, exponent)

    def indexed(self, whole: str, index: Sequence[Index]) -> str:
        return f"({whole})" + _script("_", index)

    def number(self, text: str) -> str:
        return "".join(_NUMERAL.get(letter, letter) for letter in text)

    def unit(self, unit: UnitText) -> str:
        return r"\,".join(_upright(word) + (f"^{{{power}}}" if power != 1 else "") for word, power in unit.parts)

    def symbol_property(self, what: str, symbol: str) -> str:
        return _ABOUT[what].format(symbol)

    def function(self, name: str, exponent: int | None, argument: str, enclosed: bool) -> str:
        operator = _upright(name) if exponent is None else self.power(_upright(name), exponent)
        return operator + ("" if enclosed else r"\,") + argument

    def parentheses(self, content: str) -> str:
        # A group, since only that can have an exponent.
        return rf"{{\left({content}\right)}}"

    def bars(self, content: str) -> str:
        return rf"{{\left|{content}\right|}}"

    def arrow(self, above: str) -> str:
        return rf"\;\overset{{{above}}}{{\longrightarrow}}\;"


_MATHTEXT = _Mathtext()


def _base(name: str) -> str:
    if name in GREEK:
        return _VARIANTS.get(name, f"\\{name}")
    if name.isdecimal():
        return name
    if name.startswith(ANGLE):
        return r"\angle{}" + _base(name.removeprefix(ANGLE))
    return "".join(
        _SIGNS.get(letter, letter) + (f"_{{{number}}}" if number else "") for letter, number in letters(name)
    )


def _script(sign: str, parts: Sequence[Index]) -> str:
    if not parts:
        return ""
    words = r"\,".join(_upright(part.text) if part.upright else _base(part.text) for part in parts)
    return f"{sign}{{{words}}}"


def _upright(word: str) -> str:
    return r"\mathrm{" + "".join(_SPECIAL.get(letter, letter) for letter in word) + "}"
