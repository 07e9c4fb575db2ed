"""Formulas, text and figures as HTML that is XML too; an output chooses the markup of formulas and of images."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from html import escape
from math import inf
from typing import Any

from markupsafe import Markup
from msgspec import Struct

from variantgen.figure.drawing import Drawing
from variantgen.outputs.documents.formula_rows import breadth
from variantgen.outputs.qr import qr_rows, qr_svg
from variantgen.wording.formula import Equation, Formula, Surd, UnitText
from variantgen.wording.html import to_html
from variantgen.wording.solution.plain import plain_text
from variantgen.wording.surds import with_surd
from variantgen.wording.text import Text, with_steady_dashes

# Text with a place where it may be broken: what holds to a formula before it, the rest, what holds to one after it.
_SPACED = re.compile(r"([^ ]*)( .* | )([^ ]*)", re.DOTALL)
# Letters of a formula that is to be set smaller, because it has no place where it could be broken, and its class.
_LONG = ((100, "piece longer"), (74, "piece long"), (0, "piece"))


class HtmlWriting(Struct, frozen=True):
    """Fulfils :class:`variantgen.outputs.documents.writing.Writing`: what its methods return is markup for templates.

    ``math(formula, display)`` is a formula inside a line (``display``: fractions of full size); ``image(drawing,
    millimetres, caption)`` a figure of a width, whose caption as plain text is told where the figure tells nothing.
    """

    math: Callable[[Formula, bool], str]
    image: Callable[[Drawing, float, str], str]

    def formula(self, formula: Formula) -> Markup:
        """A formula inside a line."""
        return markup(self.math(formula, False))

    def text(self, text: Text) -> Markup:
        """Words with formulas in them; a formula keeps the signs that touch it, which browsers would break off."""
        return markup("".join(self._run(run) for run in _runs(text)))

    def _run(self, run: Sequence[str | Formula]) -> str:
        inner = "".join(
            escape(with_steady_dashes(part)) if isinstance(part, str) else self.math(part, False) for part in run
        )
        return inner if len(run) == 1 else f'<span class="steady">{inner}</span>'

    def equals(self, equation: Equation, exact: Surd | None = None) -> dict[str, Any]:
        """The whole equation as one formula."""
        return {"formula": self.formula(with_surd(equation, exact))}

    def heading(self, symbol: Formula, unit: UnitText) -> Markup:
        """Symbol and unit."""
        return self.formula(symbol) + (markup(", ") + self.formula(unit) if unit.parts else "")

    def row(self, formulas: Sequence[Sequence[tuple[str, Formula]]], last: bool) -> list[list[dict[str, Any]]]:
        """Each formula in pieces."""
        return [[self._piece(sign, formula) for sign, formula in pieces] for pieces in formulas]

    def _piece(self, sign: str, formula: Formula) -> dict[str, Any]:
        """The sign with the space after it, the markup, and the class that sets long formulas smaller."""
        return {
            "sign": f"{sign}\N{NO-BREAK SPACE}" if sign else "",
            "formula": markup(self.math(formula, True)),
            "class": next(name for letters, name in _LONG if breadth(formula) >= letters),
        }

    def figure(self, drawing: Drawing, caption: Text = ()) -> Callable[..., Markup]:
        """A function of the millimetres of a figure unit and of the largest width in millimetres."""

        def sized(unit: float, widest: float = inf) -> Markup:
            return markup(self.image(drawing, min(unit * drawing.width, widest), plain_text(caption)))

        return sized

    def code(self, text: str) -> Markup:
        """An image as SVG."""
        return markup(qr_svg(qr_rows(text)))


def in_text(formula: Formula, display: bool) -> str:
    """A formula as letters, indices and powers, which every platform shows; fractions have one size only."""
    return to_html(formula)


def markup(text: str) -> Markup:
    """Markup that the program has made itself."""
    return Markup(text)  # noqa: S704


def _runs(text: Sequence[str | Formula]) -> Iterator[list[str | Formula]]:
    """Words and formulas as they hold together: a formula and what stands beside it without a space is a run."""
    run: list[str | Formula] = []
    for part in text:
        if isinstance(part, str) and (match := _SPACED.fullmatch(part)):
            before, words, after = match.groups()
            yield from _held([*run, before])
            yield [words]
            run = [after]
        else:
            run.append(part)
    yield from _held(run)


def _held(run: Sequence[str | Formula]) -> Iterator[list[str | Formula]]:
    """A run without empty strings; nothing where nothing is left."""
    if kept := [part for part in run if part != ""]:
        yield kept
