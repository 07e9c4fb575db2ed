r"""Templates of LaTeX sources: ``\VAR{...}`` is a value, a line that begins with ``%%`` a command of the template.

Every value that is no source (:class:`~variantgen.outputs.latex.text.Tex`) is text, and escaped.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from textwrap import wrap
from typing import Any

import jinja2

from variantgen.errors import InputError, Problem
from variantgen.figure.drawing import Drawing
from variantgen.outputs.figures.tikz import tikz
from variantgen.outputs.latex.characters import Alphabet
from variantgen.outputs.latex.text import Tex, latex_text
from variantgen.resources import templates_dir
from variantgen.tables import shown

_COLUMNS = 110
_FORMULA = re.compile(r"(?<!\\)\$.*?(?<!\\)\$", re.DOTALL)
_KEPT = "\x1f"  # a blank at which no line of the source ends
_KEY_WIDTH, _NAMES, _PADDING = 180.0, 61.2, 2.3  # mm: a table of the key, its first columns, the room beside a value


def fill(name: str, data: Mapping[str, Any], alphabet: Alphabet) -> str:
    """The source that a template makes of data. Raises InputError for text that cannot be printed."""
    return _environment(alphabet).get_template(name).render(data)


@cache
def _environment(alphabet: Alphabet) -> jinja2.Environment:
    source = partial(_source, alphabet)
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(templates_dir() / "latex"),
        block_start_string=r"\BLOCK{",
        block_end_string="}",
        variable_start_string=r"\VAR{",
        variable_end_string="}",
        comment_start_string=r"\COMMENT{",
        comment_end_string="}",
        line_statement_prefix="%%",
        line_comment_prefix="%#",
        trim_blocks=True,
        keep_trailing_newline=True,
        undefined=jinja2.StrictUndefined,
        finalize=source,
        autoescape=False,  # noqa: S701  (finalize escapes, for LaTeX)
    )
    environment.filters.update(_filters(source))
    return environment


def _source(alphabet: Alphabet, value: Any) -> Tex:
    """A value as source."""
    if isinstance(value, Tex):
        return value
    if isinstance(value, str | int):
        return latex_text(str(value), alphabet)
    raise TypeError(f"a template of LaTeX was given {type(value).__name__}, which is neither text nor source")


def _filters(source: Callable[[Any], Tex]) -> dict[str, Callable[..., Tex]]:
    """What templates may do with values."""

    def lines(*values: Any) -> Tex:
        """A paragraph in lines of the source that fit on a screen."""
        text = _FORMULA.sub(lambda formula: formula[0].replace(" ", _KEPT), "".join(map(source, values)))
        wrapped = wrap(text, _COLUMNS, break_long_words=False, break_on_hyphens=False)
        return Tex("\n".join(wrapped).replace(_KEPT, " "))

    def answers(found: Sequence[Mapping[str, Any]]) -> Tex:
        """Answers with marks and tolerances, which hold together."""
        return Tex("; ".join(rf"\mbox{{${one['formula']}${_remarks(source, one)}}}" for one in found))

    def values(found: Sequence[Mapping[str, Any]]) -> Tex:
        """Cells with values, marks and tolerances."""
        return Tex(" & ".join(f"{source(one['value'])}{_remarks(source, one)}" for one in found))

    def listing(code: str) -> Tex:
        """A program as it stands between the lines of a verbatim environment."""
        if "\\end{" in code or any(source(letter) != letter for letter in set(code) if not letter.isascii()):
            raise InputError(Problem("LaTeX cannot print this program", value=shown(code)))
        return Tex(code)

    return {
        "answers": answers,
        "blank_cells": lambda cells: Tex("& " * (len(cells) - 1)),
        "cells": lambda cells: Tex(" & ".join(cells)),
        "formulas": _formulas,
        "lines": lines,
        "listing": listing,
        "picture": _picture,
        "pieces": _pieces,
        "values": values,
        "width_of_values": lambda cells: Tex(f"{(_KEY_WIDTH - _NAMES) / len(cells) - _PADDING:.1f}mm"),
    }


def _remarks(source: Callable[[Any], Tex], answer: Mapping[str, Any]) -> str:
    """The mark of an answer, and its tolerance where it is not the usual one."""
    margin = rf"\margin{{{source(answer['margin'])}}}" if answer["margin"] else ""
    return source(answer["mark"]) + margin


def _picture(drawing: Drawing, unit: float, widest: float = float("inf")) -> Tex:
    """A TikZ picture with so many millimetres per figure unit, at most ``widest`` millimetres wide."""
    return Tex(tikz(drawing, min(unit * drawing.width, widest)).rstrip("\n"))


def _formulas(found: Sequence[Tex]) -> Tex:
    """Formulas in dollar signs, one after the other."""
    return Tex(", ".join(f"${formula}$" for formula in found))


def _pieces(found: Sequence[tuple[Tex, Tex]], end: str) -> Tex:
    """A formula in pieces that hold together, with the sign before each."""
    pieces = (rf"\then{{{sign}}}{{{formula}}}" if sign else rf"\piece{{{formula}}}" for sign, formula in found)
    return Tex("\n  ".join(pieces) + end)
