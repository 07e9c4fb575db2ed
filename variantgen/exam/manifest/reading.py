"""The manifest of a finished exam, read and checked: who got which variant, with which answers, made with what."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from decimal import Decimal
from pathlib import Path
from typing import Any

from msgspec import Struct, field

from variantgen.errors import InputError, Problem
from variantgen.exam.exam import Exam
from variantgen.exam.manifest.recorded_sheets import RecordedSheet, read_sheet
from variantgen.exam.manifest.streamed_json import entries
from variantgen.exam.sections.named_families import read_recorded
from variantgen.exam.sections.tolerance import LARGEST, Tolerance
from variantgen.families.reading.files import family_hash
from variantgen.resources import folder_hash, templates_dir
from variantgen.tables import Table
from variantgen.version import VERSION

SCHEMA = 2
NAME = "manifest.json"
HASH = "students_hash"
_STUDENTS = "students"
_WORDS = {
    "program": "the version of variantgen",
    "engine": "the version of the typesetting engine",
    "templates": "the templates of the program",
}


class Manifest(Struct, frozen=True):
    """A manifest. ``made_with`` are versions and hashes by name, ``files`` SHA-256 by path in the folder.

    ``exam_id`` is the short name of the build that QR codes have. ``tolerance`` is the marking, which may have been
    changed since the build, ``floors`` has the least tolerances of problems with one of their own. ``redrawn`` are ids
    of students who drew again, ``pages`` how many students have so many pages, by document,
    ``bands`` how much work variants of each form may take, ``composed`` the files of families that were composed for
    it, by the names of the families and of the files. ``students_changed``: the students are not those of the build
    (never so where the hash of their entries is not recorded).
    """

    path: Path
    made_with: Mapping[str, str]
    exam_text: str
    exam_hash: str
    solutions: Mapping[str, str] | None
    formats: tuple[str, ...]
    seed: str
    sheets: tuple[RecordedSheet, ...]
    files: Mapping[str, str]
    exam_id: str = ""
    tolerance: Tolerance = Tolerance()
    floors: Mapping[int | None, float] = field(default_factory=dict)
    redrawn: tuple[str, ...] = ()
    pages: Mapping[str, Mapping[int, int]] = field(default_factory=dict)
    bands: tuple[Mapping[str, Any], ...] = ()
    composed: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    students_changed: bool = False

    def differences(self, exam: Exam) -> list[str]:
        """The versions and files that differ from those the exam was made with, in words."""
        now = made_with(exam)
        found = []
        for name in sorted(self.made_with.keys() | now.keys()):
            then, here = self.made_with.get(name, "nothing"), now.get(name, "nothing")
            if then != here:
                what = _WORDS.get(name) or f"the folder of the {name.replace(':', ' ')}"
                found.append(f"{what}: {then} when the exam was made, {here} now")
        return found


def made_with(exam: Exam) -> dict[str, str]:
    """The inputs of an exam besides its manifest: versions, and hashes of templates and families."""
    import typst  # it tells its version sooner than importlib.metadata, which reads all that is known of the package

    used = {family.name: family.folder for task in exam.tasks for family in task.families if family.folder}
    engine: str = typst.__version__  # type: ignore[attr-defined]  # left out in its list of names
    found = {"program": VERSION, "engine": engine, "templates": folder_hash(templates_dir())}
    return {**found, **{f"family:{name}": family_hash(used[name]) for name in sorted(used)}}


def read_manifest(folder: Path) -> Manifest:
    """The manifest of an output folder. Raises InputError with every problem found.

    It is read student by student, and what is kept of each is small (see :class:`.recorded_sheets.PackedProblems`).
    """
    path = folder / NAME
    problems: list[Problem] = []
    of_sheets: list[Problem] = []
    head, sheets, hashed = _read(path, of_sheets)
    record = _manifest(Table(head, "", problems), sheets, path, hashed)
    if problems := [*problems, *(of_sheets if head.get("schema") == SCHEMA else ())]:
        raise InputError(problem.located(str(path)) for problem in problems)
    return record


def _read(path: Path, problems: list[Problem]) -> tuple[dict[str, Any], list[RecordedSheet], str]:
    """All but the students as plain data, the sheets, and the hash of their entries; what is wrong is noted."""
    if path.exists() and not path.is_file():
        raise InputError(Problem("expected a file", file=str(path), remedy="restore the manifest from a copy"))
    head: dict[str, Any] = {}
    sheets: list[RecordedSheet] = []
    lines = EntriesHash()
    try:
        with path.open(encoding="utf-8-sig") as file:
            for key, number, value in entries(file, _STUDENTS):
                if number:
                    lines.add(json.dumps(value, ensure_ascii=False, default=float).encode())  # as they are written
                    sheets.append(read_sheet(Table(value, f"{_STUDENTS}[{number}]", problems)))
                head[key] = value if not number else []
    except FileNotFoundError:
        remedy = "name the folder that  variantgen build  has made"
        raise InputError(Problem("there is no manifest", file=str(path), remedy=remedy)) from None
    except OSError as error:
        raise InputError(Problem(f"cannot be read: {error.strerror}", file=str(path))) from None
    except (ValueError, ArithmeticError, RecursionError) as error:
        remedy = "it has been changed since the build; restore it from a copy"
        raise InputError(Problem(f"is not valid JSON: {error}", file=str(path), remedy=remedy)) from None
    return head, sheets, lines.digest()


class EntriesHash:
    """The hash of the entries of students, which a manifest has behind them under ``HASH``."""

    def __init__(self) -> None:
        self._hash, self._between = hashlib.sha256(), b""

    def add(self, entries: bytes) -> None:
        """Take one entry more, or some with a comma and the end of a line between them."""
        self._hash.update(self._between + entries)
        self._between = b",\n"

    def digest(self) -> str:
        """SHA-256 of all of them."""
        return self._hash.hexdigest()


def _manifest(top: Table, sheets: Sequence[RecordedSheet], path: Path, hashed: str) -> Manifest:
    schema = top.need("schema", int, SCHEMA)
    if schema != SCHEMA:
        top.problem(
            f"expected schema {SCHEMA}", "schema", schema, "the exam was made by another version of the program"
        )
        return Manifest(path, {}, "", "", None, (), "", (), {})
    exam = top.table("exam")
    solutions = top.table("solutions") if top.data.get("solutions") is not None else None
    top.expect("solutions", "program", "notation")
    top.tables(_STUDENTS)
    return Manifest(
        path,
        _strings(top.table("made_with")),
        exam.need("text", str, ""),
        exam.need("hash", str, ""),
        _strings(solutions) if solutions else None,
        top.strings("formats"),
        top.need("seed", str, ""),
        tuple(sheets),
        _strings(top.table("files")),
        exam.take("id", str, ""),
        _tolerance(exam),
        _floors(exam.table("problem_tolerances")),
        top.strings("redrawn"),
        _pages(top.table("pages")),
        tuple(_band(table) for table in top.tables("bands")),
        read_recorded(top.table("composed")),
        top.take(HASH, str, hashed) != hashed,
    )


def _tolerance(exam: Table) -> Tolerance:
    """The marking; that of the usual tolerance where it is not recorded."""
    usual = Tolerance()
    floor = _floor(exam, "tolerance", usual.floor)
    ceiling = exam.data.get("tolerance_ceiling")
    return Tolerance(
        floor,
        None if ceiling is None else float(exam.number("tolerance_ceiling", 0)),
        exam.take("mistakes_screened", bool, usual.mistakes),
    )


def _pages(table: Table) -> dict[str, dict[int, int]]:
    """How many students have so many pages, by document."""
    return {
        document: {int(pages): own.need(pages, int, 0) for pages in own.data if pages.isascii() and pages.isdigit()}
        for document in table.data
        for own in (table.table(document),)
    }


def _band(table: Table) -> dict[str, Any]:
    """The band of a form as it is recorded: whole numbers, spans of them, names."""
    for name, value in table.data.items():
        if not (value is None or isinstance(value, str | int) or _is_span(value)):
            table.problem("expected a whole number, two of them, or a name", name, value)
    return dict(table.data)


def _is_span(value: object) -> bool:
    return isinstance(value, list) and len(value) == 2 and all(type(number) is int for number in value)


def _floors(table: Table) -> dict[int | None, float]:
    """The least tolerances of problems with one of their own, by their numbers."""
    return {int(name): _floor(table, name) for name in table.data if name.isascii() and name.isdigit()}


def _floor(table: Table, name: str, usual: float = Tolerance().floor) -> float:
    """A least tolerance; one that cannot be is noted."""
    found = float(table.number(name, Decimal(str(usual))))
    if not 0 < found <= LARGEST:
        table.problem(f"expected a number between 0 and {LARGEST:g}", name, found)
        return usual
    return found


def _strings(table: Table) -> dict[str, str]:
    return {name: table.take(name, str, "") for name in table.data}
