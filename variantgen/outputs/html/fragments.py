"""Statements and worked solutions as HTML that is XML too; an output chooses how formulas and figures are written.

Text from outside is escaped here and nowhere else; words of families and languages too.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from html import escape

from variantgen.exam.content import SolvedProblem
from variantgen.exam.notices import Notices
from variantgen.exam.solution_figures import SolutionFigure
from variantgen.figure.drawing import Drawing
from variantgen.outputs.documents.formula_rows import Pieces, breadth, rows
from variantgen.outputs.documents.solution_data import see, solution_words
from variantgen.wording.formula import Formula
from variantgen.wording.language import Language
from variantgen.wording.solution.document import Block, FormulaLines, Paragraph, Program, Section, VectorTable
from variantgen.wording.solution.plain import plain_text
from variantgen.wording.statement import Statement
from variantgen.wording.text import Text

# Text with a place where it may be broken: what holds to a formula before it, the rest, what holds to one after it.
_SPACED = re.compile(r"([^ ]*)( .* | )([^ ]*)", re.DOTALL)
# Letters of a formula that is to be set smaller, because it has no place where it could be broken, and its class.
_LONG = ((100, "piece longer"), (74, "piece long"), (0, "piece"))


@dataclass(frozen=True)
class HtmlStyle:
    """How an output writes what is not text.

    ``math(formula, display)`` is a formula inside a line (``display``: fractions of full size); ``figure(drawing,
    millimetres)`` a figure of a width. ``heading`` is the tag of headings inside a problem. ``captioned``, if there is
    one, writes figures that have a caption, which it gets as plain text for those who do not see the figure.
    """

    math: Callable[[Formula, bool], str]
    figure: Callable[[Drawing, float], str]
    heading: str = "h4"
    captioned: Callable[[Drawing, float, str], str] | None = None

    def text(self, text: Text) -> str:
        """Words with formulas in them; a formula keeps the signs that touch it, which browsers would break off."""
        return "".join(self._run(run) for run in _runs(text))

    def formulas(self, found: Sequence[Formula], end: str = "") -> str:
        """Formulas after each other, with commas between them and what stands at the end."""
        signs = [*[", "] * (len(found) - 1), end]
        return self.text(tuple(part for pair in zip(found, signs, strict=True) for part in pair))

    def _run(self, run: Sequence[str | Formula]) -> str:
        inner = "".join(escape(part) if isinstance(part, str) else self.math(part, False) for part in run)
        return inner if len(run) == 1 else f'<span class="steady">{inner}</span>'


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


def statement_html(problem_text: Statement, language: Language, style: HtmlStyle) -> str:
    """What a problem says, what is given and what is asked, as paragraphs."""
    words = language.words("sheet")
    given = (
        f"<p><strong>{escape(words['given'])}</strong> {style.formulas(problem_text.given, '.')}</p>"
        if problem_text.given
        else ""
    )
    found = f"<p><strong>{escape(words['find'])}</strong> {style.formulas(problem_text.asked, '.')}</p>"
    return f"<p>{style.text(problem_text.text)}</p>{given}{found}"


def notices_html(notices: Notices, language: Language, style: HtmlStyle) -> str:
    """What an exam says at the head of its sheets, as paragraphs; nothing where it says nothing."""
    words = language.words("notices")
    facts = (f"<p><strong>{escape(words[name])}</strong> {style.text(text)}</p>" for name, text in notices.facts)
    return "".join((*facts, *(f"<p>{style.text(text)}</p>" for text in notices.instructions)))


def notes_html(notes: Sequence[str]) -> str:
    """The conventions of signs as a small paragraph."""
    return f'<p class="notes"><small>{escape(" ".join(notes))}</small></p>' if notes else ""


def solution_html(solved: SolvedProblem, language: Language, style: HtmlStyle) -> str:
    """A worked solution: figures, plan, numbered steps, answer, check."""
    words, text = solution_words(language), solved.text
    parts = [_figures(row, style) for row in solved.rows]
    if text.plan:
        parts.append(f"<p><strong>{escape(words['plan'])}:</strong> {style.text(text.plan)}</p>")
    for number, section in enumerate(text.sections, start=1):
        parts += _section(number, section, solved, language, style)
    parts.append(f'<p class="answer"><strong>{escape(words["answer"])}:</strong> {style.text(text.answer)}</p>')
    if text.check:
        parts.append(f"<{style.heading}>{escape(words['check'])}</{style.heading}>")
        parts += blocks_html(text.check, style)
    return "".join(parts)


def _figures(row: Sequence[SolutionFigure], style: HtmlStyle) -> str:
    """Figures beside each other, with captions."""
    shown = (f"<figure>{_drawn(one, style)}<figcaption>{style.text(one.caption)}</figcaption></figure>" for one in row)
    return f'<div class="figures d-flex flex-wrap">{"".join(shown)}</div>'


def _drawn(shown: SolutionFigure, style: HtmlStyle) -> str:
    """A figure without its caption."""
    width = shown.drawing.width * shown.unit
    if style.captioned is None:
        drawing = shown.drawing
        return style.figure(drawing if drawing.alt else replace(drawing, tell=lambda: plain_text(shown.caption)), width)
    return style.captioned(shown.drawing, width, plain_text(shown.caption))


def _section(
    number: int, section: Section, solved: SolvedProblem, language: Language, style: HtmlStyle
) -> Iterator[str]:
    reference = see(section, solved, language)
    after = f' <span class="see">{escape(reference)}</span>' if reference else ""
    yield f"<{style.heading}>{number}. {style.text(section.heading)}.{after}</{style.heading}>"
    yield from blocks_html(section.blocks, style)


def blocks_html(blocks: Sequence[Block], style: HtmlStyle) -> Iterator[str]:
    """Paragraphs, rows of formulas, tables of vectors, listings."""
    for block in blocks:
        match block:
            case Paragraph(text):
                yield f"<p>{style.text(text)}</p>"
            case FormulaLines(lines):
                every = list(rows(lines))
                for number, row in enumerate(every, start=1):
                    end = ";" if number < len(every) else "."
                    signs = [*";" * (len(row) - 1), end]
                    found = (_pieces(one, sign, style) for one, sign in zip(row, signs, strict=True))
                    yield f'<p class="formulas">{" ".join(found)}</p>'
            case VectorTable():
                yield _table(block, style)
            case Program(code):
                yield f"<pre><code>{escape(code.strip(chr(10)))}</code></pre>"


def _pieces(pieces: Pieces, end: str, style: HtmlStyle) -> str:
    """A formula that may be broken before the signs between its pieces, and what stands at its end."""
    found = []
    for number, (sign, formula) in enumerate(pieces, start=1):
        before = f"{escape(sign)}\N{NO-BREAK SPACE}" if sign else ""
        after = end if number == len(pieces) else ""
        kind = next(name for letters, name in _LONG if breadth(formula) >= letters)
        found.append(f'<span class="{kind}">{before}{style.math(formula, True)}{after}</span>')
    return f'<span class="formula">{" ".join(found)}</span>'


def _table(table: VectorTable, style: HtmlStyle) -> str:
    """The vectors of an equation with what is known of them."""
    heads = "".join(f'<th scope="col">{escape(head)}</th>' for head in table.heads)
    body = "".join(
        f"<tr><td>{style.math(row.vector, False)}</td><td>{style.text(row.direction)}</td><td>"
        f"{escape(table.unknown) if row.magnitude is None else style.math(row.magnitude, False)}</td></tr>"
        for row in table.rows
    )
    whole = f"<thead><tr>{heads}</tr></thead><tbody>{body}</tbody>"
    return f'<div class="wide"><table class="vectors table table-sm w-auto">{whole}</table></div>'
