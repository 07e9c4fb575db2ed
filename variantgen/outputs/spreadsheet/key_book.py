"""The key as a workbook: a row for each answer, and on the sheet of each problem a row for each student.

The last sheet tells how much work everyone has.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from msgspec import Struct

from variantgen.exam.exam import Exam
from variantgen.exam.sheets import Answer, Item, Sheet
from variantgen.outputs.spreadsheet.headings import Headings
from variantgen.outputs.spreadsheet.identity import WHO, finish, write_heads, write_identity
from variantgen.outputs.spreadsheet.numbers import decimals, number_format, number_width, width
from variantgen.outputs.spreadsheet.work_page import write_work
from variantgen.outputs.spreadsheet.workbook_writer import CELL, HEAD, TEXT, Page, Workbook, open_workbook
from variantgen.wording.distractors import mistake_text
from variantgen.wording.language import Language

MOST_ROWS = 1_000_000  # on a sheet; a workbook has room for 1 048 576
_CENTRED = {**CELL, "align": "center"}
_REMARK = 60  # width of a column of remarks, in letters


def write_key(exam: Exam, sheets: Sequence[Sheet], path: Path, folder: Path) -> None:
    """Write ``key.xlsx``; ``folder`` is where parts of a large one are kept meanwhile."""
    language = exam.spoken
    headings = Headings(language)
    with open_workbook(path, f"{language.words('key')['title']}: {exam.title}", len(sheets), folder) as book:
        rows = [_Row(sheet, item, answer) for sheet in sheets for item in sheet.items for answer in item.answers]
        title = language.words("spreadsheet")["key"]
        for number, first in enumerate(range(0, len(rows), MOST_ROWS), start=1):
            page = book.page(title if number == 1 else f"{title} {number}")
            _every_answer(page, rows[first : first + MOST_ROWS], language, headings)
        for place in range(len(exam.tasks)):
            for own in _asked_alike(sheets, place, headings):
                _Table(book, place, own, headings).write()
        write_work(book, exam, sheets)


def _asked_alike(sheets: Sequence[Sheet], place: int, headings: Headings) -> list[list[Sheet]]:
    """The students by type of a problem and by what they are asked in it, in the order of the exam file."""
    found: dict[tuple[object, ...], list[Sheet]] = {}
    for sheet in sheets:
        item = sheet.items[place]
        names = [family.name for family in item.task.families]
        asked = tuple(headings.heading(item, answer) for answer in item.answers)
        found.setdefault((names.index(item.variant.family.name), asked), []).append(sheet)
    return [found[key] for key in sorted(found)]


class _Row(Struct, frozen=True):
    """An answer and whose it is."""

    sheet: Sheet
    item: Item
    answer: Answer


def _every_answer(page: Page, rows: Sequence[_Row], language: Language, headings: Headings) -> None:
    """The sheet with a row for each answer."""
    words = language.words("spreadsheet")
    turned = any(len(row.answer.accepted_intervals) > 1 for row in rows)
    unnoticed = any(row.answer.unnoticed for row in rows)
    bounds = ["low", "high"] + (["or_low", "or_high"] if turned else [])
    heads = [language.words("key")["problem"], *(words[name] for name in ("type", "quantity", "value", *bounds))]
    heads += [words["unit"]] + ([words["unnoticed"]] if unnoticed else [])
    students = list({id(row.sheet): row.sheet for row in rows}.values())
    types = {family.title(language.name) for row in rows for family in row.item.task.families}
    write_heads(page, 0, students, language)
    page.widths(WHO, [9, width(types), 12, *[11.0] * (1 + len(bounds)), 10, *[_REMARK] * unnoticed])
    for column, head in enumerate(heads, start=WHO):
        page.text(0, column, head, HEAD)
    for number, row in enumerate(rows, start=1):
        _one_answer(page, number, row, len(bounds) // 2, headings)
        if unnoticed:
            page.wrapped(number, WHO + len(heads) - 1, _mistakes(row.item, row.answer, language), _REMARK)
    finish(page, 0, len(rows), WHO + len(heads))
    page.printed((0, 0), (len(rows), WHO + len(heads) - 1))


def _one_answer(page: Page, number: int, row: _Row, accepted_intervals: int, headings: Headings) -> None:
    item, answer = row.item, row.answer
    write_identity(page, number, row.sheet)
    page.number(number, WHO, item.task.number, _CENTRED)
    page.text(number, WHO + 1, item.variant.family.title(headings.language.name), TEXT)
    page.text(number, WHO + 2, headings.symbol(item, answer), TEXT)
    places = decimals([answer.value])
    _write_answer(page, number, WHO + 3, answer, places, accepted_intervals)
    page.text(number, WHO + 4 + 2 * accepted_intervals, headings.unit(answer), TEXT)


def _write_answer(page: Page, row: int, column: int, answer: Answer, places: int, accepted_intervals: int) -> None:
    """The value and the bounds of so many intervals."""
    look = {**CELL, "num_format": number_format(answer, places)}
    marked = {**look, "bold": True, "num_format": number_format(answer, places, marked=bool(answer.unnoticed))}
    page.number(row, column, answer.value, marked)
    bounds = [end for window in answer.accepted_intervals for end in window]
    for place in range(2 * accepted_intervals):
        if place < len(bounds):
            page.number(row, column + 1 + place, bounds[place], look)
        else:
            page.text(row, column + 1 + place, "", CELL)


def _mistakes(item: Item, answer: Answer, language: Language) -> str:
    """The mistakes that an answer does not show."""
    symbols = item.variant.form.symbols
    return "; ".join(mistake_text(mistake, language, symbols) for mistake in answer.unnoticed)


class _Table:
    """The sheet of a problem: a row for each student, three columns or more for each quantity.

    All are asked the same; of another type, or asked something else, students have a sheet of their own.
    """

    def __init__(self, book: Workbook, place: int, sheets: Sequence[Sheet], headings: Headings) -> None:
        self.sheets, self.headings, self.language = sheets, headings, headings.language
        self.words = self.language.words("spreadsheet")
        self.items = [sheet.items[place] for sheet in sheets]
        first = self.items[0]
        self.page = book.page(f"{first.task.number}. {first.variant.family.title(self.language.name)}")
        self.forms = list(dict.fromkeys(item.variant.form.name for item in self.items))
        self.columns = list(self._columns(WHO + (len(self.forms) > 1)))

    def _columns(self, first: int) -> Iterator[_Column]:
        """Where the numbers of each quantity stand, from a column on."""
        for answers in zip(*(item.answers for item in self.items), strict=True):
            accepted_intervals = max(len(answer.accepted_intervals) for answer in answers)
            ends = [end for answer in answers for window in answer.accepted_intervals for end in window]
            places = decimals(answer.value for answer in answers)
            yield _Column(first, accepted_intervals, places, number_width(ends, places))
            first += 1 + 2 * accepted_intervals

    def write(self) -> None:
        """Write the sheet."""
        page, end = self.page, self.columns[-1].last + 1
        unnoticed = any(answer.unnoticed for item in self.items for answer in item.answers)
        self._write_heads()
        if unnoticed:
            page.widths(end, [_REMARK])
            page.text(1, end, self.words["not_shown"], HEAD)
        for row, (sheet, item) in enumerate(zip(self.sheets, self.items, strict=True), start=2):
            write_identity(page, row, sheet)
            if len(self.forms) > 1:
                page.text(row, WHO, item.variant.form.name, TEXT)
            for column, answer in zip(self.columns, item.answers, strict=True):
                _write_answer(page, row, column.first, answer, column.places, column.accepted_intervals)
            if unnoticed:
                page.wrapped(row, end, self._remarks(item), _REMARK)
        finish(page, 1, len(self.sheets) + 1, end + unnoticed)
        page.printed((0, 1), (len(self.sheets) + 1, end + unnoticed - 1))

    def _write_heads(self) -> None:
        """Quantities, below them what the columns of each are."""
        page, first = self.page, self.items[0]
        for column, answer in zip(self.columns, first.answers, strict=True):
            page.merged(0, column.first, column.last, self.headings.heading(first, answer), HEAD)
        write_heads(page, 1, self.sheets, self.language)
        if len(self.forms) > 1:
            page.text(1, WHO, self.words["form"], HEAD)
            page.widths(WHO, [width([self.words["form"], *self.forms])])
        for column in self.columns:
            names = ("value", "low", "high", "or_low", "or_high")[: 1 + 2 * column.accepted_intervals]
            page.widths(column.first, [column.width] * len(names))
            for place, name in enumerate(names, start=column.first):
                page.text(1, place, self.words[name], HEAD)

    def _remarks(self, item: Item) -> str:
        """The answers that do not show a mistake, and which."""
        remarks = (
            f"{self.headings.symbol(item, answer)}: {_mistakes(item, answer, self.language)}"
            for answer in item.answers
            if answer.unnoticed
        )
        return "; ".join(remarks)


class _Column(Struct, frozen=True):
    """The columns of a quantity: the first, how many intervals there are, decimals, their width in letters."""

    first: int
    accepted_intervals: int
    places: int
    width: float

    @property
    def last(self) -> int:
        """The last of the columns."""
        return self.first + 2 * self.accepted_intervals
