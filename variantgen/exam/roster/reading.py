"""From the tables of a class list to its students: who they are, by which id, and what the instructor should know."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Sequence
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.exam import printable
from variantgen.exam.roster.columns import Columns, cell_of, find_columns, unused_columns_note
from variantgen.exam.roster.student import Student
from variantgen.exam.roster.table_files import read_worksheets
from variantgen.exam.roster.worksheet import Worksheet


class Roster(Struct, frozen=True):
    """The students of a class list, and ``notes`` on how it was read."""

    students: tuple[Student, ...]
    notes: tuple[str, ...]


class _Entry(Struct, frozen=True):
    """A row with a student; ``where`` names it. ``id`` is empty where the list has no column for it."""

    where: str
    id: str
    number: str
    student: Student


def read_roster(path: Path) -> list[Student]:
    """The students of a class list. Raises InputError with every problem found (row numbers as in the file)."""
    return list(read_class(path).students)


def read_class(path: Path, id_column: str = "") -> Roster:
    """Read and check a class list; ``id_column`` is the word in the header of the column to be used as id.

    A column that only counts the rows is no id: with a student more everybody would have another one. Without an id
    the name and the group are one. Raises InputError with every problem found (row numbers as in the file).
    """
    try:
        return _Reader(read_worksheets(path), id_column).read()
    except InputError as error:
        raise error.located(str(path)) from None


class _Reader:
    def __init__(self, sheets: Sequence[Worksheet], id_column: str) -> None:
        self._sheets = [sheet for sheet in sheets if sheet.rows]
        self._id_column = id_column
        self._notes: list[str] = []
        self._problems: list[Problem] = []

    def read(self) -> Roster:
        """All students."""
        if not self._sheets:
            remedy = "its first row names the columns: id, name, group"
            raise InputError(Problem("the roster is empty", remedy=remedy))
        tables = self._tables()
        several = len(tables) > 1
        entries = [list(self._entries(sheet, columns, several)) for sheet, columns in tables]
        if not self._problems and not any(entries):
            raise InputError(Problem("the roster has a header but no students"))
        students = self._named([columns for _, columns in tables], entries)
        if self._problems:
            raise InputError(self._problems)
        return Roster(tuple(students), tuple(dict.fromkeys(self._notes)))

    def _tables(self) -> list[tuple[Worksheet, Columns]]:
        """The worksheets that list students (of a file with one table this one), with their columns."""
        found: list[tuple[Worksheet, Columns]] = []
        wrong: list[InputError] = []
        for sheet in self._sheets:
            try:
                found.append((sheet, find_columns([cells for _, cells in sheet.rows], self._id_column)))
            except InputError as error:
                wrong.append(error)
                self._notes.append(f"worksheet {sheet.title} is left out: {error.problems[0].message}")
        if not found:
            raise wrong[0]
        return found

    def _entries(self, sheet: Worksheet, columns: Columns, several: bool) -> Iterator[_Entry]:
        """The students of a table; what is wrong with their rows is noted."""
        before = f"worksheet {sheet.title}, " if several else ""
        if columns.row:
            rows = ", ".join(str(number) for number, _ in sheet.rows[: columns.row])
            self._notes.append(f"{before}above the header, left out: row {rows}")
        if columns.unused:
            self._notes.append(f"{before}columns that are not used: {unused_columns_note(columns)}")
        for number, cells in sheet.rows[columns.row + 1 :]:
            where = f"{before}row {number}"
            if not sheet.title and any(cells[len(columns.heads) :]):
                remedy = "quote cells that hold the delimiter"
                self._problems.append(Problem("has more cells than the header", key=where, remedy=remedy))
                continue
            found = {kind: cell_of(cells, place) for kind, place in columns.places.items()}
            name, group = columns.name(cells), found.get("group", "")
            if "group" not in columns.places and several:
                group = sheet.title
            if not name and not any(found[kind] for kind in found.keys() - {"number"}):
                self._notes.append(f"{where} has no name and is left out")
                continue
            self._check({"name": name, "group": group}, where)
            yield _Entry(where, found.get("id", ""), found.get("number", ""), Student("", name, group))

    def _check(self, texts: dict[str, str], where: str) -> None:
        for kind, text in texts.items():
            if not text and kind != "group":
                self._problems.append(Problem(f"the {kind} is empty", key=where, remedy="fill it in or remove the row"))
            self._problems += printable.problems(text, f"the {kind}", where)

    def _named(self, columns: Sequence[Columns], tables: Sequence[Sequence[_Entry]]) -> list[Student]:
        """The students with their ids."""
        heads = {kind: own.head(kind) for own in reversed(columns) for kind in own.places}
        entries = [entry for table in tables for entry in table]
        if "id" in heads:
            if only_counts([[entry.id for entry in table] for table in tables]):
                self._notes.append(
                    f'the ids (column "{heads["id"]}") only count the rows: counted anew with a student more, '
                    "they would give everybody below the sheet of another"
                )
            return self._unique([(entry, entry.id) for entry in entries])
        if "number" in heads:
            if not only_counts([[entry.number for entry in table] for table in tables]):
                return self._unique([(entry, entry.number) for entry in entries])
            head = heads["number"]
            self._notes.append(
                f'the column "{head}" only counts the rows and is no id (--id-column "{head}" makes it one)'
            )
        self._notes.append("the id of a student is the name with the group")
        return self._by_name(entries)

    def _unique(self, entries: Sequence[tuple[_Entry, str]]) -> list[Student]:
        """The students with the ids of the list; those that are wrong or stand twice are noted."""
        seen: dict[str, str] = {}
        for entry, own in entries:
            self._check({"id": own}, entry.where)
            if own and own in seen:
                remedy = f"it is the id of {seen[own]} too"
                self._problems.append(Problem("the id stands twice", key=entry.where, value=own, remedy=remedy))
            seen.setdefault(own, entry.where)
        return [replace(entry.student, id=own) for entry, own in entries]

    def _by_name(self, entries: Sequence[_Entry]) -> list[Student]:
        """The students with ids made of name and group; namesakes in a group are distinguished by their order."""
        plain = [name_and_group(entry.student) for entry in entries]
        taken, owners, found = set(plain), dict[str, list[str]](), []
        for entry, own in zip(entries, plain, strict=True):
            others = owners.setdefault(own, [])
            others.append(entry.where)
            chosen, number = own, len(others)
            while number > 1 and (chosen := f"{own} [{number}]") in taken:
                number += 1
            taken.add(chosen)
            found.append(replace(entry.student, id=chosen))
        for own, rows in owners.items():
            if len(rows) > 1 and own:
                self._notes.append(
                    f"namesakes: {own} ({', '.join(rows)}) are told apart by their order, so one more above them would "
                    "take the sheet of another; a column with ids keeps them apart"
                )
        return found


def name_and_group(student: Student) -> str:
    """``Lee Ann (M-21)``, however it was typed."""
    name, group = (" ".join(unicodedata.normalize("NFC", text).split()) for text in (student.name, student.group))
    return f"{name} ({group})" if group else name


def only_counts(tables: Sequence[Sequence[str]]) -> bool:
    """Whether numbers count the rows of some table, from 1 on or from where the table before ended."""
    end = 0
    for texts in tables:
        numbers = [text.removesuffix(".") for text in texts]
        for start in (1, end + 1):
            if texts and numbers == [str(number) for number in range(start, start + len(texts))]:
                return True
        end += len(texts)
    return False
