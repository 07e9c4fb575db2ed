"""The text of a solution as data for the typesetting templates: paragraphs, rows of formulas, tables, programs."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Any

from variantgen.outputs.sheet_data import text_data
from variantgen.wording.formula import GREEK, Formula, Sum, to_typst
from variantgen.wording.solution.document import Block, Line, Lines, Paragraph, Program, VectorTable

# Letters, by which widths are guessed: what a row of the page holds, and what a piece may have before
# its sum is cut.
_ROW, _PIECE = 100, 56
_GAP = 6
# What of the markup takes no room by itself, and what is one letter.
_SILENT = re.compile(r'frac|sqrt|arrow|op|dot\.|thin|abs|display|["_^(){}\s]')
_NAMES = re.compile("|".join((*GREEK, "angle", "perp", "parallel")))
_SIGNS = {1: "+", -1: "\N{MINUS SIGN}"}


def blocks_data(blocks: Sequence[Block]) -> list[dict[str, Any]]:
    """Blocks in order; each says its ``kind``, and whether it ``leads`` to what stands under it on the same page.

    A paragraph leads to formulas and tables, and a vector equation to the table of its vectors.
    """
    found = [_block(item) for item in blocks]
    for i, block in enumerate(found):
        after = [later["kind"] for later in found[i + 1 : i + 3]]
        if block["kind"] == "text":
            block["leads"] = bool(after) and after[0] != "text"
        else:
            to_table = after[:1] == ["vectors"] or after == ["text", "vectors"]
            block["leads"] = block["kind"] == "formulas" and to_table
    return found


def _block(item: Block) -> dict[str, Any]:
    match item:
        case Paragraph(text):
            return {"kind": "text", "text": text_data(text)}
        case Lines(lines):
            return {"kind": "formulas", "rows": list(_rows(lines))}
        case VectorTable(heads, unknown, rows):
            cells = [
                [
                    to_typst(row.vector),
                    text_data(row.direction),
                    [unknown] if row.magnitude is None else [[to_typst(row.magnitude)]],
                ]
                for row in rows
            ]
            return {"kind": "vectors", "heads": list(heads), "rows": cells}
        case Program(code):
            return {"kind": "program", "code": code.strip("\n")}


def _rows(lines: Sequence[Line]) -> Iterator[list[list[list[str]]]]:
    """Formulas as pieces; those that fit beside each other share a row."""
    row: list[list[list[str]]] = []
    room = _ROW
    for line in lines:
        pieces, length = _pieces(line)
        if row and length > room:
            yield row
            row, room = [], _ROW
        row.append(pieces)
        room -= length
    if row:
        yield row


def _letters(markup: str) -> int:
    """About how wide a formula is, in letters; a fraction counts half of what stands above and below."""
    letters = len(_SILENT.sub("", _NAMES.sub("x", markup)))
    return letters // 2 if markup.startswith("frac(") else letters


def _pieces(line: Line) -> tuple[list[list[str]], int]:
    """The pieces of a formula with the sign before each, and their width in letters.

    A long sum may be broken before each of its terms.
    """
    found: list[list[str]] = []
    length = _GAP
    for sign, formula in line.pieces:
        own = [[sign, to_typst(formula)]]
        letters = _letters(own[0][1])
        if letters > _PIECE and isinstance(formula, Sum) and len(formula.terms) > 1:
            own = list(_terms(sign, formula))
            letters = sum(_letters(markup) for _, markup in own)
        found += own
        length += letters + sum(len(before) + 2 for before, _ in own)
    return found, length


def _terms(sign: str, formula: Sum) -> Iterator[list[str]]:
    """The terms of a sum, the first with the sign of the line, the others with their own."""
    for number, (own, term) in enumerate(formula.terms):
        if number == 0:
            yield [sign, to_typst(Sum(((own, term),)))]
        else:
            yield [_SIGNS[own], to_typst(_summand(term))]


def _summand(term: Formula) -> Formula:
    """A term as it stands in a sum, in parentheses where the sum would put them."""
    return Sum(((1, term),))
