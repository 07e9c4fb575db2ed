r"""Formulas for pages that MathJax typesets: LaTeX between ``\(`` and ``\)``, inside HTML.

Versions 2 to 4 of MathJax differ in what they read inside ``\text``, so characters that LaTeX escapes there stand
outside of it here, in mathematics, where all of them agree.
"""

from __future__ import annotations

import re
from functools import lru_cache
from html import escape

from variantgen.wording.formula import Formula
from variantgen.wording.latex import to_latex

_TEXT = re.compile(r"\\text\{((?:[^\\{}]|\\[^A-Za-z]|\\[A-Za-z]+\{\})*)\}")
_ESCAPED = re.compile(r"(\\[^A-Za-z]|\\[A-Za-z]+\{\})")
_NAMED = {
    r"\textbackslash{}": r"\backslash ",
    r"\textasciicircum{}": r"\wedge ",
    r"\textasciitilde{}": r"\sim ",
    r"\textdegree{}": r"{}^{\circ}",
    r"\textminus{}": "-",
}


@lru_cache(maxsize=10_000)
def to_mathjax(formula: Formula, display: bool = False) -> str:
    r"""``\(...\)`` as HTML; with ``display`` fractions have their full size."""
    style = r"\displaystyle " if display else ""
    return escape(rf"\({style}{_TEXT.sub(_words, to_latex(formula))}\)")


def _words(match: re.Match[str]) -> str:
    """A run of text as runs without escapes and what stands between them."""
    parts = _ESCAPED.split(match[1])
    found = (_NAMED.get(part, part) if number % 2 else rf"\text{{{part}}}" for number, part in enumerate(parts) if part)
    return f"{{{''.join(found)}}}" if len(parts) > 1 else "".join(found)
