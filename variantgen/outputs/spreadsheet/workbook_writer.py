"""Workbooks and their sheets, by XlsxWriter: text is always text, and the same input gives the same bytes.

Rows and columns count from zero. The cells of a sheet have to be written row by row.
"""

from __future__ import annotations

import datetime
import unicodedata
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import xlsxwriter

Style = Mapping[str, Any]

PLAIN: Style = {}
_LINE = {"border": 1, "border_color": "#BFC6D0"}
HEAD: Style = {
    **_LINE, "bold": True, "bg_color": "#E6EAF0", "align": "center", "valign": "vcenter", "text_wrap": True,
}  # fmt: skip
TITLE: Style = {"bold": True, "font_size": 13}
NOTE: Style = {"font_color": "#555555"}
CELL: Style = {**_LINE}
TEXT: Style = {**_LINE, "indent": 1}
ABSENT: Style = {**_LINE, "bg_color": "#D0D3D8"}
INPUT: Style = {**_LINE, "bg_color": "#E3F0FB", "locked": False}

_EPOCH = datetime.datetime(2000, 1, 1, tzinfo=datetime.UTC)
_PAPER_A4 = 9
_LINE_HEIGHT, _HIGHEST_ROW = 15.0, 405.0  # points
_SPARE_LETTERS = 8  # of a line that is broken between words
_LONGEST_TITLE, _LONGEST_FOOTER, _LONGEST_PROPERTY = 31, 100, 255  # UTF-16 units
_FORBIDDEN = str.maketrans(dict.fromkeys("[]:*?/\\", " "))
# Some programs (Numbers, previews of telephones) show no text that stands in the cells themselves, where it takes no
# memory. Classes of usual size have the common table of texts, which they show.
_MANY_STUDENTS = 1000


class Page:
    """A sheet of a workbook."""

    def __init__(self, book: Workbook, sheet: Any) -> None:
        self.book, self.sheet = book, sheet

    def text(self, row: int, column: int, text: str, style: Style = PLAIN) -> None:
        """Text as it stands, whatever it begins with; a cell without text is blank."""
        form = self.book.style(style)
        if not text:
            self.sheet.write_blank(row, column, None, form)
        elif text.startswith("<r>") and text.endswith("</r>"):
            # The library takes such text for its own markup: as two runs it is escaped.
            self.sheet.write_rich_string(row, column, text[:1], self.book.style(PLAIN), text[1:], form)
        else:
            self.sheet.write_string(row, column, text, form)

    def wrapped(self, row: int, column: int, text: str, letters: int, style: Style = TEXT) -> None:
        """Text on as many lines as a column of so many letters needs; the row is made high enough."""
        lines = len(text) // (letters - _SPARE_LETTERS) + 1
        if lines > 1:
            self.sheet.set_row(row, min(_LINE_HEIGHT * lines, _HIGHEST_ROW))
        self.text(row, column, text, {**style, "text_wrap": True})

    def number(self, row: int, column: int, value: float, style: Style = CELL) -> None:
        """A number."""
        self.sheet.write_number(row, column, value, self.book.style(style))

    def formula(self, row: int, column: int, formula: str, shown: float | str, style: Style = CELL) -> None:
        """A formula, and its value for programs that do not compute."""
        self.sheet.write_formula(row, column, "=" + formula, self.book.style(style), shown)

    def merged(self, row: int, first: int, last: int, text: str, style: Style) -> None:
        """One text over several columns (or one)."""
        if last > first:
            self.sheet.merge_range(row, first, row, last, "", self.book.style(style))
        self.text(row, first, text, style)

    def widths(self, first: int, widths: Sequence[float]) -> None:
        """The widths of columns, in letters."""
        for column, width in enumerate(widths, start=first):
            self.sheet.set_column(column, column, width)

    def printed(self, header: tuple[int, int], last: tuple[int, int], percent: int = 0) -> None:
        """Paper: A4, landscape, the rows ``header`` on every page, title and page number below.

        What is printed begins with the first of these rows and ends with the cell ``last``; it is so wide as a page, or
        of ``percent`` of its size.
        """
        self.sheet.set_landscape()
        self.sheet.set_paper(_PAPER_A4)
        self.sheet.set_margins(left=0.4, right=0.4, top=0.5, bottom=0.7)
        self.sheet.repeat_rows(*header)
        self.sheet.print_area(header[0], 0, *last)
        if percent:
            self.sheet.set_print_scale(percent)
        else:
            self.sheet.fit_to_pages(1, 0)
        self.sheet.set_footer(f"&L{_footer(self.book.title)}&C&A&R&P / &N")


class Workbook:
    """A workbook. ``folder`` is where large ones keep their sheets while they are made."""

    def __init__(self, path: Path, title: str, students: int, folder: Path) -> None:
        self.title = _cut(printable(title), _LONGEST_PROPERTY)
        large = students > _MANY_STUDENTS
        self._book = xlsxwriter.Workbook(
            str(path),
            {
                "constant_memory": large,
                "in_memory": not large,
                "tmpdir": str(folder),
                "use_zip64": large,
                "strings_to_formulas": False,
                "strings_to_urls": False,
                "strings_to_numbers": False,
            },
        )
        self._book.set_properties({"title": self.title, "created": _EPOCH})
        self._titles: set[str] = set()
        self._styles: dict[tuple[tuple[str, Any], ...], Any] = {}

    def page(self, title: str) -> Page:
        """A new sheet; the title is changed so far as sheets must be named."""
        found = sheet_title(title, self._titles)
        self._titles.add(found.casefold())
        return Page(self, self._book.add_worksheet(found))

    def style(self, style: Style) -> Any:
        """The format of the library for a style; each is made once."""
        key = tuple(sorted(style.items()))
        if key not in self._styles:
            self._styles[key] = self._book.add_format({"valign": "vcenter", **style})
        return self._styles[key]

    def close(self) -> None:
        """Write the file."""
        self._book.close()


@contextmanager
def open_workbook(path: Path, title: str, students: int, folder: Path) -> Iterator[Workbook]:
    """A workbook that is written at the end of the block."""
    book = Workbook(path, title, students, folder)
    yield book
    book.close()


def printable(text: str) -> str:
    """A text without characters that XML or a header cannot hold."""
    return "".join(" " if unicodedata.category(letter) in ("Cc", "Cs", "Cn") else letter for letter in text).strip()


def sheet_title(text: str, taken: Collection[str] = ()) -> str:
    """A title that a sheet may have: at most 31 letters, without ``[]:*?/`` and a backslash, no quote at its ends.

    It is not one of those that are ``taken`` (in lower case).
    """
    whole = " ".join(printable(text).translate(_FORBIDDEN).split()).strip(" '")
    found, number = _cut(whole, _LONGEST_TITLE).strip(" '"), 1
    while found.casefold() in taken:
        number += 1
        found = _cut(whole, _LONGEST_TITLE - len(f" ({number})")) + f" ({number})"
    return found


def quoted(title: str) -> str:
    """The title of a sheet in a formula."""
    return "'" + title.replace("'", "''") + "'"


def _footer(text: str) -> str:
    """Text of a footer, in which an ampersand begins a command."""
    return _cut(text, _LONGEST_FOOTER).replace("&", "&&")


def _cut(text: str, most: int) -> str:
    """The beginning of a text, at most so many UTF-16 units; three dots say that there was more."""
    if len(text.encode("utf-16-le")) // 2 <= most:
        return text
    return text.encode("utf-16-le")[: 2 * (most - 1)].decode("utf-16-le", "ignore").rstrip() + "…"
