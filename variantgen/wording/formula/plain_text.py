"""Formulas as plain text."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from variantgen.wording.formula.markup import MARKS_ABOVE, Mark, Markup, Signs
from variantgen.wording.formula.precedence import Between
from variantgen.wording.formula.tree import GREEK, SIGNS, Formula, Index, Measured, Number, Sum, Symbol, UnitText

_ABOUT = {"modulus": "|{}|", "angle": "∠({}, x)", "sense": "sgn {}"}
_MINUS, _SPACE = "\N{MINUS SIGN}", "\N{NO-BREAK SPACE}"
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@lru_cache(maxsize=10_000)
def to_plain(formula: Formula) -> str:
    """Plain text: ``ω_OA = 3 рад/с²``."""
    return _PLAIN.write(formula)


def is_number_of(piece: Formula, result: Formula) -> bool:
    """Whether a formula is the number of a result, without its unit."""
    if not isinstance(result, Measured):
        return False
    if not isinstance(piece, Number | Measured) and not (isinstance(piece, Sum) and len(piece.terms) == 1):
        return False
    return to_plain(piece) in (to_plain(result), to_plain(result.number))


class _Plain(Markup):
    """Text in one line; what must not be torn apart at the end of a line has no-break spaces."""

    flat = True
    signs = Signs(
        minus=_MINUS,
        terms={1: " + ", -1: f" {_MINUS} "},
        factors={Between.DOT: " · ", Between.THIN: _SPACE, Between.OPERATOR: _SPACE},
        cross=" × ",
        equals=" = ",
        relations={sign: f" {sign} " for sign in SIGNS},
        comma=", ",
        semicolon="; ",
        before_unit=_SPACE,
    )

    def letter(self, symbol: Symbol, exponent: int | None, mark: Mark) -> str:
        scripts = (("^", symbol.upper), ("_", symbol.index))
        base = "".join(
            letter + MARKS_ABOVE[mark] if letter.isalpha() else letter for letter in GREEK.get(symbol.base, symbol.base)
        )
        whole = base + "".join(sign + " ".join(map(_index, parts)) for sign, parts in scripts if parts)
        return whole if exponent is None else self.power(whole, exponent)

    def indexed(self, whole: str, index: Sequence[Index]) -> str:
        return f"({whole})_" + " ".join(map(_index, index))

    def number(self, text: str) -> str:
        return text

    def unit(self, unit: UnitText) -> str:
        return " ".join(
            word + (str(power).translate(_SUPERSCRIPTS) if power != 1 else "") for word, power in unit.parts
        )

    def symbol_property(self, what: str, symbol: str) -> str:
        return _ABOUT[what].format(symbol)

    def fraction(self, numerator: str, denominator: str) -> str:
        return f"{numerator} / {denominator}"

    def ratio(self, numerator: str, denominator: str) -> str:
        return f"{numerator}/{denominator}"

    def power(self, base: str, exponent: int) -> str:
        return f"{base}^{exponent}" if exponent >= 0 else f"{base}^({_MINUS}{-exponent})"

    def root(self, radicand: str) -> str:
        return f"√{radicand}"

    def function(self, name: str, exponent: int | None, argument: str, enclosed: bool) -> str:
        head = name if exponent is None else self.power(name, exponent)
        return head + ("" if enclosed else _SPACE) + argument

    def parentheses(self, content: str) -> str:
        return f"({content})"

    def bars(self, content: str) -> str:
        return f"|{content}|"

    def arrow(self, above: str) -> str:
        return f" —{above}→ "


_PLAIN = _Plain()


def _index(index: Index) -> str:
    return GREEK.get(index.text, index.text)
