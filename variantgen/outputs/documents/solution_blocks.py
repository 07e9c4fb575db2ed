"""The text of a solution as data for the typesetting templates: paragraphs, rows of formulas, tables, programs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from variantgen.outputs.documents.formula_rows import rows
from variantgen.outputs.documents.writing import Writing
from variantgen.wording.solution.document import Block, FormulaLines, Paragraph, Program, VectorTable


def blocks_data(blocks: Sequence[Block], writing: Writing) -> list[dict[str, Any]]:
    """Blocks in order; each says its ``kind``, and whether it ``leads`` to what stands under it on the same page.

    A paragraph leads to formulas and tables, and a vector equation to the table of its vectors.
    """
    found = [_block(item, writing) for item in blocks]
    for i, block in enumerate(found):
        after = [later["kind"] for later in found[i + 1 : i + 3]]
        if block["kind"] == "text":
            block["leads"] = bool(after) and after[0] != "text"
        else:
            to_table = after[:1] == ["vectors"] or after == ["text", "vectors"]
            block["leads"] = block["kind"] == "formulas" and to_table
    return found


def _block(item: Block, writing: Writing) -> dict[str, Any]:
    match item:
        case Paragraph(text):
            return {"kind": "text", "text": writing.text(text)}
        case FormulaLines(lines):
            found = list(rows(lines))
            made = [writing.row(row, last=i == len(found)) for i, row in enumerate(found, start=1)]
            return {"kind": "formulas", "rows": made}
        case VectorTable(heads, unknown, lines):
            cells = [
                [
                    writing.formula(row.vector),
                    writing.text(row.direction),
                    writing.text((unknown,) if row.magnitude is None else (row.magnitude,)),
                ]
                for row in lines
            ]
            return {"kind": "vectors", "heads": list(heads), "rows": cells}
        case Program(code):
            return {"kind": "program", "code": code.strip("\n")}
