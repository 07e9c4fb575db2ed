"""The worksheet of a form for marking that takes points given or taken by hand, in the order of the class list."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.exam.sheets import Sheet
from variantgen.outputs.spreadsheet.identity import WHO, finish, write_heads, write_identity
from variantgen.outputs.spreadsheet.numbers import number_check
from variantgen.outputs.spreadsheet.problem_columns import ProblemColumns
from variantgen.outputs.spreadsheet.workbook_writer import HEAD, INPUT, NOTE, Page
from variantgen.wording.language import Language

_HELP, _HEADS = range(2)
FIRST = _HEADS + 1  # the row of the first student
_WIDTH = 8.0  # of a column, in letters


def column(block: ProblemColumns) -> int:
    """The column of a problem."""
    return WHO + block.place


def write_corrections(
    page: Page, blocks: Sequence[ProblemColumns], sheets: Sequence[Sheet], language: Language
) -> None:
    """Write the worksheet: a row for each student, a column ``± 1`` for each problem."""
    words, end = language.words("spreadsheet"), WHO + len(blocks)
    page.text(_HELP, 0, words["help_corrections"], NOTE)
    write_heads(page, _HEADS, sheets, language)
    page.widths(WHO, [_WIDTH] * len(blocks))
    for block in blocks:
        page.text(_HEADS, column(block), f"{words['adjustment']} {block.task.number}", HEAD)
    for row, sheet in enumerate(sheets, start=FIRST):
        write_identity(page, row, sheet)
        for block in blocks:
            page.text(row, column(block), "", INPUT)
    last = FIRST + len(sheets) - 1
    page.sheet.data_validation(FIRST, WHO, last, end - 1, number_check(words))
    finish(page, _HEADS, last, end)
    page.printed((_HEADS, _HEADS), (last, end - 1))
