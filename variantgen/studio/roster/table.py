"""A table of a class as it was brought, on disk, with what the instructor has said of it.

It lies in ``.studio/roster``: ``table`` holds its bytes, ``said.json`` its name, the columns, the answers to questions.
``uploads`` keeps both of every table that another one took the place of, by ``key``.
``columns.json`` remembers what columns were said to be by their heads, so that the next list is read the same way.
"""

from __future__ import annotations

import hashlib
import json
import re
import threading
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from msgspec import Struct, field
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.exam.roster.columns import NAME_PARTS, cell_of, find_columns
from variantgen.exam.roster.reading import only_counts
from variantgen.exam.roster.table_files import read_worksheets
from variantgen.exam.roster.worksheet import Worksheet
from variantgen.limits import TITLE_ROWS
from variantgen.studio.roster.looks import by_looks
from variantgen.studio.workspace import ROSTER, Workspace, write_whole

KINDS = ("", "name", *NAME_PARTS, "id", "group")
_ANSWERS = 5000
_LONGEST = 400
_KEY = 16  # digits of a hash that name a table or a version


class Tab(Struct, frozen=True):
    """A worksheet: its rows, the place of the first student's row, what each column holds, whether it is used."""

    title: str
    rows: tuple[tuple[int, Sequence[str]], ...]
    begin: int
    kinds: tuple[str, ...]
    used: bool

    @property
    def head(self) -> str:
        """The cells above the first student, by which a list like this one is known again."""
        return (
            "\t".join(" ".join(cell.split()).casefold() for cell in self.rows[self.begin - 1][1]) if self.begin else ""
        )


class ClassTable(Struct, frozen=True):
    """A table that was brought: its name, its worksheets, answers by question, and what it was used for.

    ``taken`` is the hash of the class list that was made of it; '' for one that is not used yet.
    """

    name: str
    tabs: tuple[Tab, ...]
    answers: Mapping[str, str] = field(default_factory=dict)
    taken: str = ""


class ClassTables:
    """The table of a folder. Its methods raise InputError for tables that cannot be read."""

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        self.lock = threading.Lock()  # of whoever reads the table to change it
        self._parsed: tuple[str, list[Worksheet]] = ("", [])

    def _place(self, name: str) -> Path:
        return self._workspace.state("roster", name)

    def bring(self, content: bytes, name: str) -> ClassTable:
        """Keep a table in place of the one before, and guess its columns."""
        before = self._said().get("answers", {})
        kept = {key: text for key, text in _texts(before).items() if key.startswith("id:")}
        sheets = self._worksheets(content, name)
        self._keep()
        write_whole(self._place("table"), content)
        found = ClassTable(name, self._guessed(sheets), kept)
        self._write(found)
        return found

    def current(self) -> ClassTable | None:
        """The table that was brought last, else the class list that is there; None without both."""
        said, roster = self._said(), self._workspace.roster()
        place = self._place("table")
        if place.is_file() and said and (not said.get("taken") or said.get("taken") == file_hash(roster)):
            return self._as_said(place.read_bytes(), said)
        return self._guess_of(roster) if roster else None

    def say(self, table: ClassTable) -> None:
        """Keep what was said of the table that was brought."""
        self._write(table)

    def key(self) -> str:
        """By what the table that was brought is kept when another takes its place; '' without one."""
        return self._key() if self.is_brought() else ""

    def version(self) -> str:
        """What changes with the table, with what is said of it and with the class list."""
        own = (self._place("table"), self._place("said.json"), self._workspace.roster())
        return hashlib.sha256(" ".join(file_hash(path) for path in own).encode()).hexdigest()[:_KEY]

    def take(self, key: str) -> None:
        """Let the table of a key be the one that was brought, or none for ''; the one before is kept.

        Raises InputError for an unknown key.
        """
        place = self._place("uploads")
        if key and (not re.fullmatch(r"[0-9a-f]+", key) or not (place / key).is_file()):
            raise InputError(Problem("there is no such table", remedy="bring it again"))
        content, said = (place / key).read_bytes() if key else b"", _json(place / f"{key}.json")
        self._keep()
        if not key:
            self._place("table").unlink(missing_ok=True)
            self._place("said.json").unlink(missing_ok=True)
            return
        if said.get("taken") != file_hash(self._workspace.roster()):
            said["taken"] = ""
        write_whole(self._place("table"), content)
        write_whole(self._place("said.json"), json.dumps(said, ensure_ascii=False))

    def _key(self) -> str:
        return file_hash(self._place("table"))[:_KEY]

    def _keep(self) -> None:
        """Keep the table that is there, with what was said of it."""
        for name, kept in (("table", self._key()), ("said.json", f"{self._key()}.json")):
            if self._place(name).is_file():
                write_whole(self._workspace.state("roster", "uploads", kept), self._place(name).read_bytes())

    def adopt(self) -> ClassTable | None:
        """Treat the class list as a table that was brought, so that it can be changed by sight."""
        roster = self._workspace.roster()
        return self.bring(roster.read_bytes(), ROSTER) if roster else None

    def is_brought(self) -> bool:
        """Whether the current table is one that was brought."""
        said = self._said()
        taken = said.get("taken")
        there = self._place("table").is_file() and bool(said)
        return there and (not taken or taken == file_hash(self._workspace.roster()))

    def remember(self, table: ClassTable) -> None:
        """Note by their heads what columns were said to be, where that is not what is guessed anyway."""
        known = _texts(_json(self._place("columns.json")))
        guessed = _guesses([Worksheet(tab.rows, tab.title) for tab in table.tabs], {})
        for tab, guess in zip(table.tabs, guessed, strict=True):
            if tab.used and tab.head:
                known.pop(tab.head, None)
                if (tab.begin, tab.kinds) != (guess.begin, guess.kinds):
                    known[tab.head] = ",".join(tab.kinds)
        write_whole(self._place("columns.json"), json.dumps(dict(list(known.items())[-200:]), ensure_ascii=False))

    def _guess_of(self, roster: Path) -> ClassTable:
        return ClassTable(ROSTER, self._guessed(self._worksheets(roster.read_bytes(), ROSTER)), {}, file_hash(roster))

    def _worksheets(self, content: bytes, name: str) -> list[Worksheet]:
        """The tables of a file with rows; the last file is kept as it was read."""
        own = hashlib.sha256(content).hexdigest()
        if self._parsed[0] != own:
            place = self._place("incoming")
            write_whole(place, content)
            try:
                found = [sheet for sheet in read_worksheets(place) if sheet.rows]
            except InputError as error:
                raise InputError([replace(problem, file="") for problem in error.problems]).located(name) from None
            finally:
                place.unlink(missing_ok=True)
            if not found:
                raise InputError(Problem("the table is empty", file=name))
            self._parsed = own, found
        return self._parsed[1]

    def _guessed(self, sheets: Sequence[Worksheet]) -> tuple[Tab, ...]:
        found = _guesses(sheets, _texts(_json(self._place("columns.json"))))
        if not any(tab.used for tab in found):
            found[0] = replace(found[0], used=True)
        return tuple(found)

    def _as_said(self, content: bytes, said: Mapping[str, Any]) -> ClassTable:
        name = str(said.get("name", ""))[:_LONGEST]
        guessed = self._guessed(self._worksheets(content, name))
        own = said.get("tabs")
        tabs = [_with(tab, own[i] if isinstance(own, list) and i < len(own) else {}) for i, tab in enumerate(guessed)]
        return ClassTable(name, tuple(tabs), _texts(said.get("answers", {})), str(said.get("taken", "")))

    def _said(self) -> dict[str, Any]:
        return _json(self._place("said.json"))

    def _write(self, table: ClassTable) -> None:
        tabs = [{"begin": tab.begin, "kinds": list(tab.kinds), "used": tab.used} for tab in table.tabs]
        data = {"name": table.name, "tabs": tabs, "answers": dict(table.answers), "taken": table.taken}
        write_whole(self._place("said.json"), json.dumps(data, ensure_ascii=False))


def file_hash(path: Path | None) -> str:
    """The SHA-256 of a file; '' without one."""
    return hashlib.sha256(path.read_bytes()).hexdigest() if path and path.is_file() else ""


def _guesses(sheets: Sequence[Worksheet], known: Mapping[str, str]) -> list[Tab]:
    """Worksheets with the columns as they were said to be before, or as a build would read them.

    A build takes a column of numbers (``No``) for the id unless it only counts the rows, in all worksheets alike; a
    column that is headed as id is one, whatever it holds.
    """
    counted = only_counts([numbers for sheet in sheets if (numbers := _numbers(sheet))])
    return [_guess(sheet, known, "" if counted else "id") for sheet in sheets]


def _numbers(sheet: Worksheet) -> list[str]:
    """What stands in the column of numbers of a worksheet, of the rows that hold something else, too."""
    try:
        columns = find_columns([cells for _, cells in sheet.rows])
    except InputError:
        return []
    if "number" not in columns.places:
        return []
    rows = [
        {kind: cell_of(cells, k) for kind, k in columns.places.items()} for _, cells in sheet.rows[columns.row + 1 :]
    ]
    return [found["number"] for found in rows if any(text for kind, text in found.items() if kind != "number")]


def _guess(sheet: Worksheet, known: Mapping[str, str], number: str) -> Tab:
    """A worksheet whose column of numbers holds what ``number`` says."""
    width = max(len(cells) for _, cells in sheet.rows)
    for place in range(min(TITLE_ROWS, len(sheet.rows))):
        tab = Tab(sheet.title, sheet.rows, place + 1, ("",) * width, True)
        kinds = tuple(known.get(tab.head, "").split(","))
        if tab.head in known and len(kinds) <= width and set(kinds) <= set(KINDS):
            return replace(tab, kinds=(*kinds, *[""] * (width - len(kinds))))
    try:
        columns = find_columns([cells for _, cells in sheet.rows])
    except InputError:
        begin, kinds = by_looks([cells for _, cells in sheet.rows], width)
        return Tab(sheet.title, sheet.rows, begin, kinds, "name" in kinds)
    found = {place: kind for kind, place in columns.places.items()}
    if "number" in columns.places:
        found[columns.places["number"]] = "" if "id" in columns.places else number
    return Tab(sheet.title, sheet.rows, columns.row + 1, tuple(found.get(i, "") for i in range(width)), True)


def _with(tab: Tab, said: object) -> Tab:
    """A worksheet with what was said of it, as far as it fits."""
    if not isinstance(said, dict):
        return tab
    begin, kinds, used = said.get("begin"), said.get("kinds"), said.get("used")
    if isinstance(begin, int) and 0 <= begin <= min(len(tab.rows), TITLE_ROWS):
        tab = replace(tab, begin=begin)
    if isinstance(kinds, list) and len(kinds) == len(tab.kinds) and set(map(str, kinds)) <= set(KINDS):
        tab = replace(tab, kinds=tuple(map(str, kinds)))
    return replace(tab, used=used) if isinstance(used, bool) else tab


def _texts(data: object) -> dict[str, str]:
    """What of a table are texts by names."""
    found = data.items() if isinstance(data, dict) else ()
    return {key: text for key, text in list(found)[:_ANSWERS] if isinstance(key, str) and isinstance(text, str)}


def _json(path: Path) -> dict[str, Any]:
    """A table that was kept; empty where there is none that can be read."""
    try:
        found = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}
