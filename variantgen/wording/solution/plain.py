"""A solution as plain text for the terminal: fractions in one line, tables as aligned text, at most 100 columns."""

from __future__ import annotations

import textwrap
import unicodedata
from collections.abc import Iterator, Sequence

from variantgen.wording.formula import to_plain
from variantgen.wording.language import Language
from variantgen.wording.solution.document import (
    Block,
    FormulaLine,
    FormulaLines,
    Paragraph,
    Program,
    SolutionText,
    VectorTable,
)
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.text import Text

COLUMNS = 100
_INDENT = "    "
_HANGING = 8


def plain_solution(solution: SolutionText, language: Language) -> str:
    """The whole solution: plan, numbered steps, answer, check."""
    words = load_phrases(language.name).words
    paragraphs = [_wrapped(f"{words['plan']}: {plain_text(solution.plan)}")] if solution.plan else []
    for number, section in enumerate(solution.sections, start=1):
        heading = _wrapped(f"{number}. {plain_text(section.heading)}")
        paragraphs.append("\n".join([heading, *_blocks(section.blocks)]))
    paragraphs.append(_wrapped(f"{words['answer']}: {plain_text(solution.answer)}"))
    if solution.check:
        paragraphs.append("\n".join([f"{words['check']}.", *_blocks(solution.check)]))
    return "\n\n".join(paragraphs)


def plain_text(text: Text) -> str:
    """Text with its formulas in one line."""
    return "".join(part if isinstance(part, str) else to_plain(part) for part in text)


def _wrapped(text: str) -> str:
    return textwrap.fill(text, COLUMNS, break_on_hyphens=False, break_long_words=False)


def _blocks(blocks: Sequence[Block]) -> Iterator[str]:
    for block in blocks:
        match block:
            case Paragraph(text):
                yield _wrapped(plain_text(text))
            case FormulaLines(lines):
                yield from (part for line in lines for part in _line(line))
            case VectorTable():
                yield from _table(block)
            case Program(code):
                yield textwrap.indent(code.strip("\n"), _INDENT)


def _line(line: FormulaLine) -> Iterator[str]:
    """A formula, broken before a sign where it is too long for a row."""
    row = _INDENT
    for number, (sign, formula) in enumerate(line.pieces):
        piece = f"{sign} {to_plain(formula)}" if sign else to_plain(formula)
        if number and _width(row) + 1 + _width(piece) > COLUMNS:
            yield row
            row = " " * _HANGING + piece
        else:
            row += f" {piece}" if number else piece
    yield row


def _table(table: VectorTable) -> Iterator[str]:
    """Columns as wide as their widest cell."""
    rows = [
        (to_plain(r.vector), plain_text(r.direction), table.unknown if r.magnitude is None else to_plain(r.magnitude))
        for r in table.rows
    ]
    widths = [max(_width(row[i]) for row in (table.heads, *rows)) for i in range(3)]
    for row in (table.heads, *rows):
        yield (_INDENT + "  ".join(_padded(cell, width) for cell, width in zip(row, widths, strict=True))).rstrip()


def _padded(cell: str, width: int) -> str:
    return cell + " " * (width - _width(cell))


def _width(text: str) -> int:
    """Columns that a text takes: marks above letters take none."""
    return sum(not unicodedata.combining(letter) for letter in text)
