"""Whose mark is another than in an earlier marking of the same exam: after another policy, or more answers."""

from __future__ import annotations

import csv
from collections.abc import Collection, Iterator, Mapping, Sequence
from pathlib import Path

from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.exam.manifest import Manifest
from variantgen.marking.marks import Marked
from variantgen.marking.records import MARKS, TOTALS, shown
from variantgen.outputs.files.records import csv_rows, safe_cell

CHANGES = "changes.csv"
_COLUMNS = ("id", "name", "group", "code", "answer", "verdict before", "verdict", "points before", "points")

Entry = tuple[str, str]  # verdict (of a sum its grade), points
Earlier = Mapping[tuple[str, str], Entry]  # by the code of the sheet and the answer, '' for the sum


class Change(Struct, frozen=True):
    """A mark that is another one: of an answer (``1.v_B``) or, where that is '', of the sum."""

    place: int
    answer: str
    before: Entry
    now: Entry


def read_marking(folder: Path, codes: Collection[str]) -> Earlier:
    """The marks of an earlier marking of the exam with these sheets, from its folder. Raises InputError."""
    found: dict[tuple[str, str], Entry] = {}
    for row in _rows(folder / MARKS, ("code", "problem", "quantity", "verdict", "points")):
        found[row["code"], f"{row['problem']}.{row['quantity']}"] = row["verdict"], row["points"]
    for row in _rows(folder / TOTALS, ("code", "grade", "points")):
        found[row["code"], ""] = row["grade"], row["points"]
    if foreign := sorted({code for code, _ in found} - set(codes)):
        remedy = "name the folder of an earlier marking of the same exam"
        raise InputError(
            Problem("has sheets that this exam does not have", str(folder), value=foreign[0], remedy=remedy)
        )
    return found


def _rows(path: Path, columns: Sequence[str]) -> list[dict[str, str]]:
    remedy = "name the folder of an earlier  variantgen mark"
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            table = csv.DictReader(file)
            rows, heads = list(table), table.fieldnames or ()
    except (OSError, UnicodeDecodeError, csv.Error):
        raise InputError(Problem("is not the table of a marking", file=str(path), remedy=remedy)) from None
    if not set(columns) <= set(heads) or any(
        None in row or None in (row.get(column) for column in columns) for row in rows
    ):
        raise InputError(Problem("is not the table of a marking", file=str(path), remedy=remedy))
    return rows


def changes(record: Manifest, marked: Marked, earlier: Earlier) -> list[Change]:
    """What has changed, the sum of a student before the answers."""
    found = []
    for place, answer, now in _now(marked):
        before = earlier.get((record.sheets[place].code, answer), ("", ""))
        if before != now:
            found.append(Change(place, answer, before, now))
    return sorted(found, key=lambda change: (change.place, change.answer != ""))


def _now(marked: Marked) -> Iterator[tuple[int, str, Entry]]:
    for place, total in enumerate(marked.totals):
        yield place, "", (safe_cell(total.grade), shown(total.points))
    for item in marked.marks:
        yield item.place, f"{item.problem}.{item.answer.quantity.name}", (item.verdict.value, shown(item.points))


def write_changes(folder: Path, record: Manifest, found: Sequence[Change], anonymous: bool) -> None:
    """Write ``changes.csv``: an empty answer stands for the sum of a student, with grades in place of verdicts."""
    rows: list[Sequence[str]] = [_COLUMNS]
    for change in found:
        sheet = record.sheets[change.place]
        student = sheet.student
        who = ("", "", "") if anonymous else tuple(map(safe_cell, (student.id, student.name, student.group)))
        (verdict_before, points_before), (verdict, points) = change.before, change.now
        rows.append((*who, sheet.code, change.answer, verdict_before, verdict, points_before, points))
    (folder / CHANGES).write_bytes(("\ufeff" + csv_rows(rows)).encode())
