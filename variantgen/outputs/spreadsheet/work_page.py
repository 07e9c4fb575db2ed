"""The sheet of a workbook that tells how much work everyone's variants take."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.exam.exam import Exam
from variantgen.exam.sheets import Sheet
from variantgen.outputs.spreadsheet.identity import WHO, finish, write_heads, write_identity
from variantgen.outputs.spreadsheet.workbook_writer import CELL, HEAD, Workbook

_WIDTH = 14  # of a column, in letters
_PARTS = ("calculations", "negatives", "obtuse")


def write_work(book: Workbook, exam: Exam, sheets: Sequence[Sheet]) -> None:
    """Add the sheet: a row for each student, three columns for each problem, the calculations of all problems.

    Above the columns of a problem stand its fewest and most calculations. Nothing is added where the exam was built
    without looking at work.
    """
    places = [place for place in range(len(exam.tasks)) if all(sheet.items[place].work is not None for sheet in sheets)]
    if not places or not sheets:
        return
    words, language = exam.spoken.words("fairness"), exam.spoken
    page, end = book.page(words["work"]), WHO + len(_PARTS) * len(places)
    table = [[work for place in places if (work := sheet.items[place].work) is not None] for sheet in sheets]
    for number, place in enumerate(places):
        first, sizes = WHO + len(_PARTS) * number, [row[number].calculations for row in table]
        title = f"{language.words('key')['problem']} {exam.tasks[place].number}: {_spread(sizes)}"
        page.merged(0, first, first + len(_PARTS) - 1, title, HEAD)
    totals = [sum(work.calculations for work in row) for row in table]
    page.text(0, end, f"{words['sheets']}: {_spread(totals)}", HEAD)
    write_heads(page, 1, sheets, language)
    page.widths(WHO, [_WIDTH] * (end + 1 - WHO))
    for column in range(WHO, end):
        page.text(1, column, words[_PARTS[(column - WHO) % len(_PARTS)]], HEAD)
    page.text(1, end, words["calculations"], HEAD)
    for row, (sheet, works, total) in enumerate(zip(sheets, table, totals, strict=True), start=2):
        write_identity(page, row, sheet)
        for column, size in enumerate((getattr(work, part) for work in works for part in _PARTS), start=WHO):
            page.number(row, column, size, CELL)
        page.number(row, end, total, CELL)
    finish(page, 1, len(sheets) + 1, end + 1)
    page.printed((0, 1), (len(sheets) + 1, end))


def _spread(sizes: Sequence[int]) -> str:
    least, most = min(sizes), max(sizes)
    return str(least) if least == most else f"{least}\N{EN DASH}{most}"
