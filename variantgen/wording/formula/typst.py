"""Formulas as Typst math, without the dollar signs."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from variantgen.wording.formula.markup import Mark, Markup, Signs
from variantgen.wording.formula.precedence import Between
from variantgen.wording.formula.tree import ANGLE, GREEK, Formula, Index, Number, Symbol, UnitText, letters

_ABOUT = {"modulus": "abs({})", "angle": "angle ({}, x)", "sense": 'op("sgn") {}'}
_MARKS = {Mark.NONE: "{}", Mark.ARROW: "arrow({})", Mark.DOT: "dot({})", Mark.DOTS: "dot.double({})"}

_SIGNS = {
    "/": "\\/",
    "′": "zws'",
    "∥": 'class("normal", parallel)',
    "⟂": 'class("normal", perp)',
}  # a bare stroke would make a fraction


@lru_cache(maxsize=10_000)
def to_typst(formula: Formula) -> str:
    """Typst math markup, without the dollar signs."""
    return _TYPST.write(formula)


class _Typst(Markup):
    """Markup that is evaluated in the math mode of the engine: every word and number in it is a quoted string."""

    flat = False
    signs = Signs(
        minus="-",
        # Spaces are said: in small type the engine leaves none, except beside text. Beside a space, though, it takes
        # + and − for signs of one number and does not break the line after them.
        terms={1: ' med class("binary", +) med ', -1: ' med class("binary", -) med '},
        # Never at the end of a line, so not binary.
        factors={
            Between.DOT: ' thin class("normal", dot.op) thin ',
            Between.THIN: " thin ",
            Between.OPERATOR: " thin ",
        },
        cross=' thin class("normal", times) thin ',
        equals=" = ",
        relations={
            "=": " = ",
            "≈": " approx ",
            "<": " lt ",
            "≤": " lt.eq ",
            "≥": " gt.eq ",
            "→": " arrow.r ",
            "∥": " parallel ",
            "⟂": " perp ",
        },
        comma="\\, ",
        semicolon="\\; ",
        before_unit=" thin ",
    )

    def letter(self, symbol: Symbol, exponent: int | None, mark: Mark) -> str:
        scripts = (("_", symbol.index), ("^", symbol.upper))
        return (
            _MARKS[mark].format(_base(symbol.base))
            + "".join(f"{sign}({' '.join(map(_index, parts))})" for sign, parts in scripts if parts)
            + _exponent(exponent)
        )

    def indexed(self, whole: str, index: Sequence[Index]) -> str:
        return f"\\({whole}\\)_({' '.join(map(_index, index))})"  # of the size of the letter

    def number(self, text: str) -> str:
        return _quoted(text)

    def unit(self, unit: UnitText) -> str:
        return " ".join(
            _quoted(word) + (f"^({_quoted(_signed(power))})" if power != 1 else "") for word, power in unit.parts
        )

    def tight(self, number: Number, unit: UnitText) -> str:
        return _quoted(number.text + "".join(word for word, _ in unit.parts))

    def symbol_property(self, what: str, symbol: str) -> str:
        return _ABOUT[what].format(symbol)

    def fraction(self, numerator: str, denominator: str) -> str:
        return f"frac({numerator}, {denominator})"

    def power(self, base: str, exponent: int) -> str:
        return base + _exponent(exponent)

    def root(self, radicand: str) -> str:
        return f"sqrt({radicand})"

    def function(self, name: str, exponent: int | None, argument: str, enclosed: bool) -> str:
        # The engine sets no space before an accented letter.
        space = "thin " if argument.startswith("arrow(") else ""
        return f"op({_quoted(name)}){_exponent(exponent)} {space}{argument}"

    def parentheses(self, content: str) -> str:
        return f"({content})"

    def bars(self, content: str) -> str:
        return f"abs({content})"

    def coefficient(self, number: str, root: str) -> str:
        return f"{number} {root}"

    def place(self, point: str, coordinates: str) -> str:
        return f"{point} {coordinates}"

    def arrow(self, above: str) -> str:
        return f" limits(stretch(arrow.r, size: #2em))^({above}) "


_TYPST = _Typst()


def _base(base: str) -> str:
    if base.startswith(ANGLE):
        return f"angle {_base(base.removeprefix(ANGLE))}"
    if base in GREEK or base.isdecimal():
        return base
    return " ".join(_SIGNS.get(letter, letter) + (f"_({number})" if number else "") for letter, number in letters(base))


def _index(index: Index) -> str:
    return _quoted(index.text) if index.upright else _base(index.text)


def _exponent(exponent: int | None) -> str:
    if exponent is None:
        return ""
    return f"^{exponent}" if 0 <= exponent <= 9 else f"^({exponent})"


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _signed(power: int) -> str:
    return str(power).replace("-", "\N{MINUS SIGN}")
