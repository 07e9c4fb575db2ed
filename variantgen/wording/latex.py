"""Formulas as LaTeX math, without the dollar signs; they need ``amsmath``."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from variantgen.wording.formula.markup import Mark, Signs
from variantgen.wording.formula.precedence import Between
from variantgen.wording.formula.tex import TexMarkup, marked
from variantgen.wording.formula.tree import ANGLE, GREEK, Formula, Index, Symbol, UnitText, letters

_GREEK = {"epsilon": r"\varepsilon", "phi": r"\varphi"}  # the forms that the figures and the engine use
ESCAPES = {  # characters that are commands or not in every font
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#", "%": r"\%", "_": r"\_",
    "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "°": r"\textdegree{}", "\N{MINUS SIGN}": r"\textminus{}",
}  # fmt: skip
_ABOUT = {"modulus": r"\left|{}\right|", "angle": r"\angle({}, x)", "sense": r"\operatorname{{sgn}} {}"}
_SIGNS = {"′": "'", "∥": r"\parallel", "⟂": r"\perp"}


def escaped(text: str) -> str:
    """Text as LaTeX prints it, whatever characters it has."""
    return "".join(ESCAPES.get(letter, letter) for letter in text)


@lru_cache(maxsize=10_000)
def to_latex(formula: Formula) -> str:
    r"""LaTeX math: ``\omega_{OA}``; numbers, units and words as text."""
    return _LATEX.write(formula)


class _Latex(TexMarkup):
    """Markup of LaTeX, which knows itself how much room is around an operator."""

    flat = False
    signs = Signs(
        minus="-",
        terms={1: " + ", -1: " - "},
        factors={Between.DOT: r" \cdot ", Between.THIN: r"\,", Between.OPERATOR: " "},
        cross=r" \times ",
        equals=" = ",
        relations={
            "=": " = ",
            "≈": r" \approx ",
            "<": " < ",
            "≤": r" \le ",
            "≥": r" \ge ",
            "→": r" \to ",
            "∥": r" \parallel ",
            "⟂": r" \perp ",
        },
        comma=", ",
        semicolon="; ",
        before_unit=r"\,",
    )

    def letter(self, symbol: Symbol, exponent: int | None, mark: Mark) -> str:
        scripts = (("_", symbol.index), ("^", symbol.upper))
        joined = [(sign, _joined(parts)) for sign, parts in scripts if parts]
        letter = marked(_base(symbol.base), symbol, mark) + "".join(f"{sign}{{{text}}}" for sign, text in joined)
        return letter if exponent is None else self.power(letter, exponent)

    def indexed(self, whole: str, index: Sequence[Index]) -> str:
        return rf"({whole})_{{{_joined(index)}}}"

    def number(self, text: str) -> str:
        return text.replace("\N{MINUS SIGN}", "-").replace(",", "{,}") if _is_plain(text) else _word(text)

    def unit(self, unit: UnitText) -> str:
        return "".join(_word(word) + (f"^{{{power}}}" if power != 1 else "") for word, power in unit.parts)

    def symbol_property(self, what: str, symbol: str) -> str:
        return _ABOUT[what].format(symbol)

    def function(self, name: str, exponent: int | None, argument: str, enclosed: bool) -> str:
        operator = rf"\mathop{{{_word(name)}}}\nolimits"
        return f"{operator if exponent is None else self.power(operator, exponent)} {argument}"

    def parentheses(self, content: str) -> str:
        # What opens before it takes away the room that LaTeX leaves before a fraction.
        return rf"\mathopen{{}}\left({content}\right)"

    def bars(self, content: str) -> str:
        return rf"\mathopen{{}}\left|{content}\right|"

    def arrow(self, above: str) -> str:
        return rf" \xrightarrow{{{above}}} "


_LATEX = _Latex()


def sign_to_latex(sign: str) -> str:
    """A sign of relation or a plus or minus, as it stands between formulas."""
    between = {"+": _LATEX.signs.terms[1], "\N{MINUS SIGN}": _LATEX.signs.terms[-1], **_LATEX.signs.relations}
    return between[sign].strip()


def _base(base: str) -> str:
    if base.startswith(ANGLE):
        return rf"\angle {_base(base.removeprefix(ANGLE))}"
    if base in GREEK:
        return _GREEK.get(base, rf"\{base}")
    if base.isdecimal():
        return base
    written = (_SIGNS.get(letter, letter) + (f"_{{{number}}}" if number else "") for letter, number in letters(base))
    return " ".join(written)


def _index(index: Index) -> str:
    return _word(index.text) if index.upright else _base(index.text)


def _joined(parts: Sequence[Index]) -> str:
    return r"\,".join(map(_index, parts))


def _is_plain(text: str) -> bool:
    return all(letter.isdecimal() or letter in ".,\N{MINUS SIGN}" for letter in text)


def _word(text: str) -> str:
    if text == "°":
        return r"^{\circ}"
    return rf"\text{{{escaped(text)}}}"
