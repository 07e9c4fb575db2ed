"""The class list: CSV (comma, semicolon or tab; UTF-8 or cp1251) or XLSX, columns in any order, Russian or English."""

from __future__ import annotations

import csv
import io
import zipfile
import zlib
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from variantgen.errors import InputError, Problem, missing_package, nearest
from variantgen.exam import printable
from variantgen.tables import read_limited
from variantgen.wording.language import languages, load_language

_MAX_BYTES = 50_000_000
# What the reader of workbooks raises on damaged ones, as found by damaging them.
_BROKEN_WORKBOOK = (
    zipfile.BadZipFile, zlib.error, LookupError, ValueError, TypeError, AttributeError, SyntaxError, EOFError, OSError,
    NotImplementedError,
)  # fmt: skip


@dataclass(frozen=True)
class Student:
    """One entry of the roster; ``id`` alone decides the variant."""

    id: str
    name: str
    group: str = ""


def numbered(count: int) -> list[Student]:
    """Students without a roster: ids 1 .. count, no names."""
    return [Student(str(i), "") for i in range(1, count + 1)]


def read_roster(path: Path) -> list[Student]:
    """Read and check a roster. Raises InputError with every problem found (row numbers as in the file)."""
    try:
        content = read_limited(path, _MAX_BYTES)
    except OSError as error:
        raise InputError(Problem(f"cannot be read: {error.strerror}", file=str(path))) from None
    try:
        rows = _xlsx_rows(content) if content[:4] == b"PK\x03\x04" else _csv_rows(content)
        return _students(rows)
    except InputError as error:
        raise error.located(str(path)) from None


def _csv_rows(content: bytes) -> list[tuple[int, list[str]]]:
    text = _decoded(content)
    header = text.lstrip("\r\n").split("\n", 1)[0]
    delimiter = max(";\t,", key=header.count)
    try:
        reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
        return [
            (reader.line_num, [cell.strip() for cell in row]) for row in reader if any(cell.strip() for cell in row)
        ]
    except csv.Error as error:
        raise InputError(
            Problem(f"is not a proper CSV table: {error}", remedy="save it again as CSV from the spreadsheet")
        ) from None


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


def _xlsx_rows(content: bytes) -> list[tuple[int, list[str]]]:
    try:
        import openpyxl
    except ImportError:
        raise missing_package("an XLSX roster needs", "openpyxl", "xlsx", "  or save the table as CSV") from None
    try:
        book = openpyxl.load_workbook(io.BytesIO(content), read_only=True, data_only=True)
        sheet = book.worksheets[0]
        rows = [(i, [_cell(cell) for cell in row]) for i, row in enumerate(sheet.iter_rows(values_only=True), start=1)]
    except _BROKEN_WORKBOOK as error:
        raise InputError(
            Problem(f"is not a readable XLSX workbook ({type(error).__name__})", remedy="save it again, or as CSV")
        ) from None
    return [(i, row) for i, row in rows if any(row)]


def _cell(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    return str(value).strip()


def _students(rows: list[tuple[int, list[str]]]) -> list[Student]:
    if not rows:
        raise InputError(Problem("the roster is empty", remedy="its first row names the columns: id, name, group"))
    columns = _header(rows[0][1])
    if len(rows) == 1:
        raise InputError(Problem("the roster has a header but no students"))
    problems: list[Problem] = []
    seen: dict[str, int] = {}
    students = []
    for line, row in rows[1:]:
        key = f"row {line}"
        if len(row) > len(rows[0][1]) and any(row[len(rows[0][1]) :]):
            problems.append(
                Problem("has more cells than the header", key=key, remedy="quote cells that hold the delimiter")
            )
            continue
        found = {name: row[i] if i < len(row) else "" for name, i in columns.items()}
        problems += _cell_problems(found, key)
        if found["id"] and found["id"] in seen:
            problems.append(
                Problem(
                    "the id stands twice",
                    key=key,
                    value=found["id"],
                    remedy=f"it is the id of row {seen[found['id']]} too",
                )
            )
        seen.setdefault(found["id"], line)
        students.append(Student(found["id"], found["name"], found.get("group", "")))
    if problems:
        raise InputError(problems)
    return students


@cache
def _column_words() -> dict[str, str]:
    """The words that may head a column in any language (table ``[roster]`` of its words), with the column's name."""
    return {
        word.strip(): column
        for language in languages()
        for column, words in load_language(language).words("roster").items()
        for word in words.split(",")
    }


def _header(cells: list[str]) -> dict[str, int]:
    columns: dict[str, int] = {}
    problems: list[Problem] = []
    known = _column_words()
    for i, cell in enumerate(cells):
        word = " ".join(cell.casefold().replace("_", " ").split())
        if not word:
            continue
        column = known.get(word)
        if column is None:
            problems.append(Problem("unknown column", key="header", value=cell[:60], remedy=nearest(word, known)))
        elif column in columns:
            problems.append(
                Problem(f"a second column for the {column}", key="header", value=cell[:60], remedy="keep one")
            )
        else:
            columns[column] = i
    for column in ("id", "name"):
        if column not in columns and not problems:
            problems.append(
                Problem(
                    f"no column for the {column}",
                    key="header",
                    value=", ".join(cells)[:60],
                    remedy="the columns are id, name, group",
                )
            )
    if problems:
        raise InputError(problems)
    return columns


def _cell_problems(found: dict[str, str], key: str) -> list[Problem]:
    problems = []
    for column, text in found.items():
        if not text and column != "group":
            problems.append(Problem(f"the {column} is empty", key=key, remedy="fill it in or remove the row"))
        problems += printable.problems(text, f"the {column}", key)
    return problems
