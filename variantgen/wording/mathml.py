"""Formulas as presentation MathML, for pages of HTML and for packages of learning platforms.

Only elements of MathML Core are used, so that browsers show them without help.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from html import escape

from variantgen.wording.formula.markup import Mark, Markup, Signs
from variantgen.wording.formula.precedence import Between
from variantgen.wording.formula.tree import ANGLE, GREEK, SIGNS, Formula, Index, Symbol, UnitText, letters

NAMESPACE = "http://www.w3.org/1998/Math/MathML"
_MINUS = "\N{MINUS SIGN}"
_THIN = '<mspace width="0.167em"/>'
_ABOUT = {
    "modulus": '<mo stretchy="false">|</mo>{}<mo stretchy="false">|</mo>',
    "angle": '<mo>∠</mo><mo stretchy="false">(</mo>{}<mo separator="true">,</mo><mi>x</mi><mo stretchy="false">)</mo>',
    "sense": f"<mi>sgn</mi>{_THIN}{{}}",
}
_PRIMED = (Index("prime"),)
_ABOVE = {Mark.ARROW: "→", Mark.DOT: "˙", Mark.DOTS: "¨"}


def _operator(sign: str, space: str = "") -> str:
    return f'<mo lspace="{space}" rspace="{space}">{escape(sign)}</mo>' if space else f"<mo>{escape(sign)}</mo>"


@lru_cache(maxsize=10_000)
def to_mathml(formula: Formula, display: bool = False) -> str:
    """A ``math`` element; with ``display`` fractions have their full size."""
    style = ' displaystyle="true"' if display else ""
    return f'<math xmlns="{NAMESPACE}"{style}>{_MATHML.write(formula)}</math>'


class _MathML(Markup):
    """Markup of MathML; what a method returns is one or more elements beside each other."""

    flat = False
    signs = Signs(
        minus=f'<mo form="prefix">{_MINUS}</mo>',
        terms={1: '<mo form="infix">+</mo>', -1: f'<mo form="infix">{_MINUS}</mo>'},
        factors={Between.DOT: _operator("⋅", "0.17em"), Between.THIN: _THIN, Between.OPERATOR: _THIN},
        cross=_operator("×"),
        equals=_operator("="),
        relations={sign: _operator(sign) for sign in SIGNS},
        comma='<mo separator="true">,</mo>',
        semicolon='<mo separator="true">;</mo>',
        before_unit=_THIN,
    )

    def letter(self, symbol: Symbol, exponent: int | None, mark: Mark) -> str:
        base = _row(_base(symbol.base))
        if mark is not Mark.NONE:
            sign = _ABOVE[mark]
            stretchy = "true" if mark is Mark.ARROW and symbol.is_name else "false"
            size = ' mathsize="65%"' if mark is Mark.ARROW else ""  # of full size it is wider than most letters
            base = f'<mover accent="true">{base}<mo stretchy="{stretchy}"{size}>{sign}</mo></mover>'
        upper = symbol.upper
        if upper == _PRIMED:  # raised by its own form
            base, upper = f"<mrow>{base}<mo>{GREEK['prime']}</mo></mrow>", ()
        below, above = (_row(_joined(parts)) if parts else "" for parts in (symbol.index, upper))
        if exponent is not None and not above:
            above, exponent = _number(exponent), None
        if above and mark is not Mark.NONE:  # what stands above the letter does not lift what stands beside it
            base = f'<mpadded height="0.5em">{base}</mpadded>'
        if below and above:
            base = f"<msubsup>{base}{below}{above}</msubsup>"
        elif below or above:
            tag = "msub" if below else "msup"
            base = f"<{tag}>{base}{below or above}</{tag}>"
        return base if exponent is None else self.power(self.parentheses(base), exponent)

    def indexed(self, whole: str, index: Sequence[Index]) -> str:
        return f"<msub>{self.parentheses(whole)}{_row(_joined(index))}</msub>"

    def number(self, text: str) -> str:
        if text.startswith(_MINUS):
            return f'<mo form="prefix">{_MINUS}</mo><mn>{escape(text[1:])}</mn>'
        return f"<mn>{escape(text)}</mn>"

    def unit(self, unit: UnitText) -> str:
        words = (
            _word(word) if power == 1 else f"<msup>{_word(word)}{_number(power)}</msup>" for word, power in unit.parts
        )
        return "".join(words)

    def symbol_property(self, what: str, symbol: str) -> str:
        return _ABOUT[what].format(symbol)

    def fraction(self, numerator: str, denominator: str) -> str:
        return f"<mfrac>{_row(numerator)}{_row(denominator)}</mfrac>"

    def power(self, base: str, exponent: int) -> str:
        return f"<msup>{_row(base)}{_number(exponent)}</msup>"

    def root(self, radicand: str) -> str:
        return f"<msqrt>{radicand}</msqrt>"

    def function(self, name: str, exponent: int | None, argument: str, enclosed: bool) -> str:
        word = f"<mi>{escape(name)}</mi>"  # several letters are upright
        head = word if exponent is None else f"<msup>{word}{_number(exponent)}</msup>"
        return head + ("" if enclosed else _THIN) + argument

    def parentheses(self, content: str) -> str:
        held = "" if _is_tall(content) else ' stretchy="false"'
        return f"<mrow><mo{held}>(</mo>{content}<mo{held}>)</mo></mrow>"

    def bars(self, content: str) -> str:
        grows = "true" if _is_tall(content) else "false"
        return (
            f'<mrow><mo form="prefix" stretchy="{grows}">|</mo>{content}'
            f'<mo form="postfix" stretchy="{grows}">|</mo></mrow>'
        )

    def coefficient(self, number: str, root: str) -> str:
        return number + root

    def arrow(self, above: str) -> str:
        sign = '<mo stretchy="true" lspace="0.3em" rspace="0.3em">⟶</mo>'
        return f"<mover>{sign}{_row(above)}</mover>"


_MATHML = _MathML()


def _is_tall(content: str) -> bool:
    """Whether parentheses have to grow with their content, as those around letters with indices do not."""
    return "<mfrac>" in content or "<msqrt>" in content


def _row(content: str) -> str:
    """One element: the content itself if it is one letter or number."""
    single = content.count("<") == 2 and content.startswith(("<mi>", "<mn>", "<mtext>"))
    return content if single else f"<mrow>{content}</mrow>"


def _base(base: str) -> str:
    if base.startswith(ANGLE):
        return f"<mo>{ANGLE}</mo>{_base(base.removeprefix(ANGLE))}"
    if base in GREEK:
        return f"<mi>{GREEK[base]}</mi>"
    if base.isdecimal():
        return f"<mn>{base}</mn>"
    return "".join(
        f"<msub><mi>{letter}</mi><mn>{number}</mn></msub>" if number else f"<mi>{letter}</mi>"
        for letter, number in letters(base)
    )


def _index(index: Index) -> str:
    return _word(index.text) if index.upright else _base(index.text)


def _joined(parts: Sequence[Index]) -> str:
    return _THIN.join(map(_index, parts))


def _word(text: str) -> str:
    return f"<mtext>{escape(text)}</mtext>"


def _number(value: int) -> str:
    if value < 0:
        return f"<mrow><mo>{_MINUS}</mo><mn>{-value}</mn></mrow>"
    return f"<mn>{value}</mn>"
