"""The rows of a class list as they stand in the file: CSV, or the worksheets of a workbook."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from pathlib import Path

from variantgen.errors import InputError, Problem
from variantgen.exam.roster.columns import known_in
from variantgen.exam.roster.worksheet import Row, Worksheet
from variantgen.limits import ROSTER_BYTES, ROSTER_COLUMNS, ROSTER_ROWS, TITLE_ROWS
from variantgen.tables import read_limited


def read_worksheets(path: Path, columns: int = ROSTER_COLUMNS, formulas: bool = False) -> list[Worksheet]:
    """The tables of a file, at least one. Raises InputError.

    Of a workbook so many ``columns`` are looked at; ``formulas``: a formula that was never computed is told as it
    stands, and not taken for an empty cell.
    """
    try:
        content = read_limited(path, ROSTER_BYTES)
    except OSError as error:
        raise InputError(Problem(f"cannot be read: {error.strerror}", file=str(path))) from None
    if content[:4] == b"PK\x03\x04":
        from variantgen.exam.roster.workbook import workbook_worksheets

        return workbook_worksheets(content, columns, formulas)
    return [Worksheet(tuple(_csv_rows(content)))]


def _csv_rows(content: bytes) -> list[Row]:
    text = _decoded(content)
    delimiter = _delimiter(text.lstrip("\r\n").split("\n", TITLE_ROWS)[:TITLE_ROWS])
    try:
        reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
        rows: list[Row] = []
        for row in reader:
            cells = [cell.strip() for cell in row]
            if any(cells):
                rows.append((reader.line_num, cells))
            if len(rows) > ROSTER_ROWS:
                raise InputError(Problem(f"the roster has more than {ROSTER_ROWS} rows", remedy="split it"))
    except csv.Error as error:
        raise InputError(
            Problem(f"is not a proper CSV table: {error}", remedy="save it again as CSV from the spreadsheet")
        ) from None
    return rows


def _delimiter(lines: Sequence[str]) -> str:
    """What parts the cells: that by which a line is the best header, or by which the first line has most cells."""
    return max(";\t,", key=lambda mark: (max(known_in(line.split(mark)) for line in lines), lines[0].count(mark)))


def _decoded(content: bytes) -> str:
    if b"\0" in content and not content.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise InputError(Problem("is not a text file", remedy="save the table as CSV (UTF-8) or XLSX"))
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        encodings = ["utf-16"]
    else:
        encodings = ["utf-8-sig", "cp1251"]
    for encoding in encodings:
        try:
            return content.decode(encoding)
        except UnicodeDecodeError:
            continue
    raise InputError(Problem("is neither UTF-8 nor cp1251 text", remedy="save the table as CSV (UTF-8) or XLSX"))
