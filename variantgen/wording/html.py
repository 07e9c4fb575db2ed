"""Formulas as HTML: letters in italics, indices below, powers above."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from html import escape

from variantgen.wording.formula.markup import MARKS_ABOVE, Mark, Markup, Signs
from variantgen.wording.formula.precedence import Between
from variantgen.wording.formula.tree import ANGLE, GREEK, SIGNS, Formula, Index, Symbol, UnitText, letters

_MINUS, _SPACE, _NARROW = "\N{MINUS SIGN}", "\N{NO-BREAK SPACE}", "\N{NARROW NO-BREAK SPACE}"
_ABOUT = {"modulus": "|{}|", "angle": "∠({}, <i>x</i>)", "sense": "sgn\N{NO-BREAK SPACE}{}"}


@lru_cache(maxsize=10_000)
def to_html(formula: Formula) -> str:
    """Markup of a formula, as it stands inside a line of text."""
    return _HTML.write(formula)


class _Html(Markup):
    """Markup for a line of text, which may break before a sign between terms or sides and nowhere else."""

    flat = True
    signs = Signs(
        minus=_MINUS,
        terms={1: f" +{_SPACE}", -1: f" {_MINUS}{_SPACE}"},
        factors={Between.DOT: f"{_SPACE}·{_SPACE}", Between.THIN: _NARROW, Between.OPERATOR: _NARROW},
        cross=f"{_SPACE}×{_SPACE}",
        equals=f"{_SPACE}={_SPACE}",
        relations={sign: f" {escape(sign)}{_SPACE}" for sign in SIGNS},
        comma=", ",
        semicolon=f";{_SPACE}",
        before_unit=_SPACE,
    )

    def letter(self, symbol: Symbol, exponent: int | None, mark: Mark) -> str:
        scripts = (("sup", symbol.upper), ("sub", symbol.index))
        raised = [(tag, _joined(parts)) for tag, parts in scripts if parts]
        letter = _base(symbol.base, MARKS_ABOVE[mark]) + "".join(f"<{tag}>{text}</{tag}>" for tag, text in raised)
        return letter if exponent is None else self.power(letter, exponent)

    def indexed(self, whole: str, index: Sequence[Index]) -> str:
        return f"({whole})<sub>{_joined(index)}</sub>"

    def number(self, text: str) -> str:
        return escape(text)

    def unit(self, unit: UnitText) -> str:
        return " ".join(self.power(escape(word), power) if power != 1 else escape(word) for word, power in unit.parts)

    def symbol_property(self, what: str, symbol: str) -> str:
        return _ABOUT[what].format(symbol)

    def fraction(self, numerator: str, denominator: str) -> str:
        return f"{numerator}{_SPACE}/{_SPACE}{denominator}"

    def ratio(self, numerator: str, denominator: str) -> str:
        return f"{numerator}/{denominator}"

    def power(self, base: str, exponent: int) -> str:
        return f"{base}<sup>{str(exponent).replace('-', _MINUS)}</sup>"

    def root(self, radicand: str) -> str:
        return f"√{radicand}"

    def function(self, name: str, exponent: int | None, argument: str, enclosed: bool) -> str:
        head = escape(name) if exponent is None else self.power(escape(name), exponent)
        return head + ("" if enclosed else _NARROW) + argument

    def parentheses(self, content: str) -> str:
        return f"({content})"

    def bars(self, content: str) -> str:
        return f"|{content}|"

    def arrow(self, above: str) -> str:
        return f"{_SPACE}—<sup>{above}</sup>→{_SPACE}"


_HTML = _Html()


def _base(base: str, mark: str = "") -> str:
    if base.startswith(ANGLE):
        return ANGLE + _base(base.removeprefix(ANGLE))
    if base in GREEK:
        return f"<i>{GREEK[base]}{mark}</i>"
    if base.isdecimal():
        return base
    return "".join(
        f"<i>{letter}{mark}</i>" + (f"<sub>{number}</sub>" if number else "") for letter, number in letters(base)
    )


def _index(index: Index) -> str:
    return escape(index.text) if index.upright else _base(index.text)


def _joined(parts: Sequence[Index]) -> str:
    return "\N{THIN SPACE}".join(map(_index, parts))
