"""The first columns of every sheet: who a row is about."""

from __future__ import annotations

from collections.abc import Sequence

from xlsxwriter.utility import xl_rowcol_to_cell

from variantgen.exam.sheets import Sheet
from variantgen.outputs.spreadsheet.numbers import width
from variantgen.outputs.spreadsheet.workbook_writer import CELL, HEAD, Page
from variantgen.wording.language import Language

WHO = 4  # columns: code, id, name, group
FROZEN = 3  # those that stay in sight
_AS_TEXT = {**CELL, "num_format": "@"}


def heads(language: Language) -> tuple[str, str, str, str]:
    """The heads of the columns."""
    words = language.words("spreadsheet")
    return language.words("key")["variant"], words["id"], words["name"], words["group"]


def write_heads(page: Page, row: int, sheets: Sequence[Sheet], language: Language) -> list[float]:
    """Write the heads of the columns; returns their widths (in letters)."""
    titles = heads(language)
    for column, head in enumerate(titles):
        page.text(row, column, head, HEAD)
    widths = [width(texts) for texts in zip(titles, *map(_who, sheets), strict=True)]
    page.widths(0, widths)
    return widths


def write_identity(page: Page, row: int, sheet: Sheet) -> None:
    """Who a row is about; an id stays text."""
    for column, text in enumerate(_who(sheet)):
        page.text(row, column, text, _AS_TEXT)


def finish(page: Page, header: int, last: int, columns: int) -> None:
    """Heads and names stay in sight; below the row ``header`` are filters.

    What a spreadsheet would mark as doubtful is meant: ids that are numbers, formulas unlike their neighbours.
    """
    page.sheet.freeze_panes(header + 1, FROZEN)
    page.sheet.autofilter(header, 0, last, columns - 1)
    end = xl_rowcol_to_cell(last, columns - 1)
    page.sheet.ignore_errors(
        {"number_stored_as_text": f"A{header + 2}:D{last + 1}", "formula_differs": f"E{header + 2}:{end}"}
    )


def _who(sheet: Sheet) -> tuple[str, str, str, str]:
    student = sheet.student
    return sheet.code, student.id, student.name, student.group
