"""The worksheets of an XLSX file: all rows that are there, whatever the file says of its size, and within bounds."""

from __future__ import annotations

import io
import zipfile
import zlib
from collections.abc import Sequence
from typing import Any

from variantgen.errors import InputError, Problem, missing_package
from variantgen.exam.roster.worksheet import Row, Worksheet
from variantgen.limits import (
    ROSTER_COLUMNS,
    ROSTER_ROWS,
    WORKBOOK_BYTES,
    WORKBOOK_LOOKS,
    WORKBOOK_MARKS,
    WORKBOOK_ROWS,
    WORKSHEETS,
)

# What the reader of workbooks raises on damaged ones, as found by damaging them.
_BROKEN = (
    zipfile.BadZipFile, zlib.error, LookupError, ValueError, TypeError, AttributeError, SyntaxError, EOFError, OSError,
    NotImplementedError,
)  # fmt: skip
_PIECE = 1_000_000  # bytes
_SIMPLER = "copy the list into a new workbook (values only), or save it as CSV"


def workbook_worksheets(content: bytes, columns: int = ROSTER_COLUMNS, formulas: bool = False) -> list[Worksheet]:
    """The visible worksheets. Raises InputError for a damaged file or one beyond all bounds.

    See :func:`variantgen.exam.roster.table_files.read_worksheets`.
    """
    try:
        import openpyxl
    except ImportError:
        raise missing_package("an XLSX roster needs", "openpyxl", "xlsx", "  or save the table as CSV") from None
    try:
        _check_size(content)
        book = openpyxl.load_workbook(io.BytesIO(content), read_only=True, data_only=True)
        visible = [sheet for sheet in book.worksheets if sheet.sheet_state == "visible"]
        found = [Worksheet(tuple(_rows(sheet, columns)), str(sheet.title)) for sheet in visible]
        if not formulas:
            return found
        book = openpyxl.load_workbook(io.BytesIO(content), read_only=True)
        return [_with_formulas(sheet, dict(_rows(book[sheet.title], columns))) for sheet in found]
    except _BROKEN as error:
        raise InputError(
            Problem(f"is not a readable XLSX workbook ({type(error).__name__})", remedy="save it again, or as CSV")
        ) from None


def _check_size(content: bytes) -> None:
    """Raise InputError for a workbook that would not fit into the memory. No more is unpacked than the bounds allow."""
    with zipfile.ZipFile(io.BytesIO(content)) as parts:
        infos = parts.infolist()
        sheets = [part for part in infos if "/worksheets/" in part.filename]
        table = [*sheets, *(part for part in infos if part.filename.endswith("sharedStrings.xml"))]
        looks = [part for part in infos if part.filename.endswith((".xml", ".rels")) and part not in table]
        for found, most, what in (
            (table, WORKBOOK_BYTES, "worksheets"),
            (looks, WORKBOOK_LOOKS, "styles and other parts"),
        ):
            size = sum(part.file_size for part in found)
            if size > most:
                problem = f"the {what} of the workbook unpack to {size // 1_000_000} MB"
                raise InputError(Problem(f"{problem}, more than {most // 1_000_000} MB", remedy=_SIMPLER))
        if sum(_count(parts, part, b"<row") for part in sheets) > WORKBOOK_ROWS:
            problem = f"the workbook has more than {WORKBOOK_ROWS} rows, empty ones counted"
            raise InputError(Problem(problem, remedy=_SIMPLER))
        if sum(_count(parts, part, b"<") for part in looks) > WORKBOOK_MARKS:
            raise InputError(
                Problem("the styles and other parts of the workbook have too many entries", remedy=_SIMPLER)
            )
    if len(sheets) > WORKSHEETS:
        raise InputError(Problem(f"the workbook has more than {WORKSHEETS} worksheets", remedy=_SIMPLER))


def _count(parts: zipfile.ZipFile, part: zipfile.ZipInfo, tag: bytes) -> int:
    """How often a tag begins in a part, which is never whole in memory."""
    found, rest = 0, b""
    with parts.open(part) as content:
        while piece := content.read(_PIECE):
            joined = rest + piece
            found += joined.count(tag)
            rest = joined[len(joined) - len(tag) + 1 :]  # shorter than the tag: nothing is counted twice
    return found


def _with_formulas(sheet: Worksheet, written: dict[int, Sequence[str]]) -> Worksheet:
    """A worksheet with its formulas, those that have no value in their cells.

    ``written`` are the rows with all formulas as they stand.
    """
    values = dict(sheet.rows)
    rows = []
    for number, cells in written.items():
        known = values.get(number, [])
        own = [cell if cell.startswith("=") else "" for cell in cells]
        merged = [known[k] if k < len(known) and known[k] else cell for k, cell in enumerate(own)]
        while merged and not merged[-1]:
            merged.pop()
        if merged:
            rows.append((number, merged))
    computed = ((number, k) for number, cells in written.items() for k, cell in enumerate(cells) if cell[:1] == "=")
    return Worksheet(tuple(rows), sheet.title, frozenset(computed))


def _rows(sheet: Any, columns: int) -> list[Row]:
    """The rows of a worksheet that are not empty."""
    sheet.reset_dimensions()  # what the file says of them may be wrong, and rows outside would not be read
    found: list[Row] = []
    before: object = None
    for number, row in enumerate(sheet.iter_rows(max_col=columns, values_only=True), start=1):
        if number > ROSTER_ROWS:
            where = f"worksheet {sheet.title}"
            problem = f"a row has a number above {ROSTER_ROWS}, which no worksheet has"
            raise InputError(Problem(problem, key=where, remedy=_SIMPLER))
        # Where the file has no rows, the reader gives one and the same empty row a million times.
        if row is not before and any(cell is not None for cell in row):
            cells = [_cell(cell) for cell in row]
            while cells and not cells[-1]:
                cells.pop()
            if cells:
                found.append((number, cells))
        before = row
    return found


def _cell(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    return str(value).strip()
