"""Files for machines: the key as CSV and the manifest as JSON."""

from __future__ import annotations

import csv
import io
import json
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, BinaryIO

from msgspec.structs import asdict

from variantgen.exam.exam import Exam
from variantgen.exam.manifest import HASH, NAME, SCHEMA, EntriesHash, RecordedSheet
from variantgen.exam.sheets import Item, Sheet
from variantgen.families.reading.files import family_files
from variantgen.outputs.files.folder import file_hashes
from variantgen.version import VERSION

# Where a spreadsheet would begin a formula: at the start of a cell, be there blanks or not. Where the decimal mark is a
# comma, spreadsheets part cells at semicolons, and some do at tabs, whatever the quotes are.
_FORMULA = re.compile("(^|[;\t\r\n])(?=[\\s\u200b\u2060\ufeff]*[=+\\-@＝＋－＠]|[\t\r])")


_COLUMNS = ("id", "name", "group", "code", "problem", "family", "quantity", "value", "unit", "tolerance", "unnoticed")
RECORDED = _COLUMNS[:-1]  # those that the manifest has too
KEY = "key.csv"
RECORDS = "records"  # the name of the pieces of both files among those of the formats


def write_records(
    folder: Path,
    exam: Exam,
    made_with: Mapping[str, str],
    redrawn: Sequence[str],
    pages: Mapping[str, Mapping[int, int]],
    pieces: Mapping[str, Sequence[Path]],
    bands: Sequence[Mapping[str, Any]] = (),
) -> None:
    """Write both files from the pieces of all students, last of all: the manifest has the hashes of all other files."""
    write_key_csv(folder / KEY, pieces[KEY])
    write_manifest(
        folder / NAME, manifest_head(exam, made_with, redrawn, pages, file_hashes(folder), bands), pieces[NAME]
    )


def write_key_csv(path: Path, pieces: Iterable[Path]) -> None:
    """Write the key from the pieces of all students."""
    with path.open("wb") as file:
        file.write(("\ufeff" + csv_rows([_COLUMNS])).encode())
        for piece in pieces:
            file.write(piece.read_bytes())
        _keep(file)


def write_manifest(path: Path, head: str, pieces: Iterable[Path]) -> None:
    """Write the manifest from what stands before the students (see :func:`manifest_head`) and their pieces.

    Behind them stands the hash of their entries, by which a change of them is seen.
    """
    hashed = EntriesHash()
    with path.open("wb") as file:
        file.write(head.encode())
        for number, piece in enumerate(pieces):
            entries = piece.read_bytes()
            hashed.add(entries)
            file.write((b",\n" if number else b"\n") + entries)
        file.write(f'\n ],\n "{HASH}": "{hashed.digest()}"\n}}\n'.encode())
        _keep(file)


def _keep(file: BinaryIO) -> None:
    """See to it that a file is on the disk."""
    file.flush()
    os.fsync(file.fileno())


def key_rows(sheets: Sequence[Sheet]) -> str:
    """The key of some students as CSV, one row per answer; text that a spreadsheet would run gets an apostrophe.

    Commas part the cells and numbers have points, in every language: it is a file for programs. A spreadsheet that
    guesses what cells are takes ids like ``007`` and ``1E5`` for numbers.
    """
    return csv_rows(
        (
            *map(safe_cell, (sheet.student.id, sheet.student.name, sheet.student.group, sheet.code)),
            item.task.number,
            *map(safe_cell, (item.variant.family.name, answer.quantity.name)),
            repr(answer.value),
            safe_cell(answer.unit.name),
            repr(answer.tolerance),
            safe_cell("; ".join(answer.unnoticed)),
        )
        for sheet in sheets
        for item in sheet.items
        for answer in item.answers
    )


def recorded_rows(sheets: Iterable[RecordedSheet]) -> Iterator[list[str]]:
    """The cells of the key that a manifest has too, in the columns ``RECORDED``."""
    for sheet in sheets:
        own = [safe_cell(text) for text in (sheet.student.id, sheet.student.name, sheet.student.group, sheet.code)]
        for problem in sheet.problems:
            for answer in problem.answers:
                yield [
                    *own,
                    str(problem.number),
                    safe_cell(problem.family),
                    safe_cell(answer.quantity),
                    repr(answer.value),
                    safe_cell(answer.unit),
                    repr(answer.tolerance),
                ]


def csv_rows(rows: Iterable[Sequence[object]]) -> str:
    """Rows as CSV."""
    out = io.StringIO(newline="")
    csv.writer(out, lineterminator="\r\n").writerows(rows)
    return out.getvalue()


def safe_cell(text: str) -> str:
    """A text with an apostrophe where a spreadsheet would run it."""
    return text if text.isalnum() else _FORMULA.sub(r"\1'", text)


def manifest_head(
    exam: Exam,
    made_with: Mapping[str, str],
    redrawn: Sequence[str],
    pages: Mapping[str, Mapping[int, int]],
    files: Mapping[str, str],
    bands: Sequence[Mapping[str, Any]] = (),
) -> str:
    """What stands in the manifest before the lines of the students.

    The manifest is JSON with everything that is needed to make each sheet again. ``made_with`` says what a sheet
    depends on besides this file; ``pages`` how many students have so many pages, by document; ``files`` has the SHA-256
    of the other files, ``bands`` say how much work the variants of each form may take.
    """
    content = {
        "schema": SCHEMA,
        "program": {"name": "variantgen", "version": VERSION},
        "made_with": dict(made_with),
        "exam": {
            "title": exam.title,
            "id": exam.build_id,
            "hash": exam.hash,
            "text": exam.text,
            "language": exam.language,
            "tolerance": exam.tolerance.floor,
            "tolerance_ceiling": exam.tolerance.ceiling,
            "mistakes_screened": exam.tolerance.mistakes,
            "problem_tolerances": {
                str(task.number): task.tolerance.floor for task in exam.tasks if task.tolerance is not None
            },
        },
        # What is not a choice of words stands in the text of the exam.
        "solutions": {name: value for name, value in asdict(exam.solutions).items() if isinstance(value, str)}
        if exam.solutions.wanted
        else None,
        "notation": asdict(exam.spoken.notation),
        "formats": list(exam.formats),
        "seed": exam.seed,
        "redrawn": list(redrawn),
        "pages": {document: dict(students) for document, students in pages.items()},
        "bands": list(bands),
        **({"composed": composed} if (composed := _composed(exam)) else {}),
        "files": dict(files),
    }
    text = json.dumps(content, ensure_ascii=False, indent=1).removesuffix("\n}")
    return f'{text},\n "students": ['


def _composed(exam: Exam) -> dict[str, dict[str, str]]:
    """The files of composed families by name: no later command makes them again."""
    return {
        family.name: {file: content.decode() for file, content in family_files(family.folder).items()}
        for task in exam.tasks
        if task.composed
        for family in task.families
        if family.folder
    }


def manifest_lines(exam: Exam, sheets: Sequence[Sheet]) -> str:
    """The entries of some students in the manifest, a line for each."""
    return ",\n".join(
        json.dumps(
            {
                "id": sheet.student.id,
                "name": sheet.student.name,
                "group": sheet.student.group,
                "code": sheet.code,
                "problems": [_problem(exam, item) for item in sheet.items],
            },
            ensure_ascii=False,
        )
        for sheet in sheets
    )


def _problem(exam: Exam, item: Item) -> dict[str, Any]:
    variant = item.variant
    return {
        "problem": item.task.number,
        "family": variant.family.name,
        "form": variant.form.name,
        **({"nice": True} if item.task.nice else {}),
        "pose": {"mirrored": variant.sense < 0, "quarter_turns": variant.turns},
        "attempt": variant.attempt,
        **({"work": asdict(item.work)} if item.work else {}),
        "methods": list(item.task.methods or variant.family.solution) if exam.solutions.wanted else [],
        "parameters": {
            name: {"value": str(value), "unit": parameter.unit.name}
            if parameter.unit
            else {"value": variant.word(name)}
            for name, value in variant.printed.items()
            for parameter in (variant.form.parameters[name],)
        },
        "answers": [
            {
                "quantity": a.quantity.name,
                "value": a.value,
                "unit": a.unit.name,
                "tolerance": a.tolerance,
                "relative_tolerance": round(a.relative_tolerance, 6),
                **({"unnoticed": list(a.unnoticed)} if a.unnoticed else {}),
            }
            for a in item.answers
        ],
    }
