"""The files of a marking: ``marks.csv``, ``totals.csv``, ``not_matched.csv``.

They are files for programs: commas part the cells, numbers have points, texts that a spreadsheet would run get an
apostrophe.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from pathlib import Path

from msgspec.structs import replace

from variantgen.exam.manifest import Manifest
from variantgen.marking.answer_tables import NotMatched
from variantgen.marking.diagnosis.causes import Cause
from variantgen.marking.marks import Marked, MarkedAnswer, Verdict
from variantgen.outputs.files.records import csv_rows, safe_cell

MARKS, TOTALS, NOT_MATCHED = "marks.csv", "totals.csv", "not_matched.csv"
FILES = (MARKS, TOTALS, NOT_MATCHED)
_MARK_COLUMNS = (
    "id", "name", "group", "code", "problem", "form", "quantity", "answer", "value", "unit", "key", "verdict", "cause",
    "points", "of",
)  # fmt: skip


def write_marks(folder: Path, record: Manifest, marked: Marked, anonymous: bool) -> None:
    """Write the files into a folder; ``anonymous`` leaves out ids, names and groups."""
    _write(folder / MARKS, [_MARK_COLUMNS, *(_row(record, item, anonymous) for item in marked.marks)])
    numbers = sorted({number for total in marked.totals for number in total.problems})
    head = ("id", "name", "group", "code", *map(str, numbers), "points", "of", "percent", "grade", "answers", "open")
    rows: list[Sequence[object]] = [head]
    for total in marked.totals:
        own = [shown(total.problems[number]) if number in total.problems else "" for number in numbers]
        percent = f"{float(100 * total.points / total.of):.1f}" if total.of else ""
        student = _who(total.student.id, total.student.name, total.student.group, anonymous)
        sums = (shown(total.points), shown(total.of), percent, safe_cell(total.grade), total.handed_in, total.open)
        rows.append((*student, total.code, *own, *sums))
    _write(folder / TOTALS, rows)
    shown_items = not_matched(marked, anonymous)
    left = [tuple(map(safe_cell, (item.where, item.text, item.why, item.remedy))) for item in shown_items]
    _write(folder / NOT_MATCHED, [("where", "text", "why", "remedy"), *left])


def not_matched(marked: Marked, anonymous: bool) -> list[NotMatched]:
    """What was not matched; ``anonymous`` leaves out what the cells say, and remedies that may name a student."""
    if not anonymous:
        return list(marked.not_matched)
    return [replace(item, text="", remedy="" if item.names_student else item.remedy) for item in marked.not_matched]


def without_words(marked: Marked) -> Marked:
    """Marks in which answers that are no numbers have no text: where columns are shifted a name may stand there."""
    found = [
        replace(item, text="…") if item.verdict is Verdict.UNREADABLE and not item.waiting else item
        for item in marked.marks
    ]
    return replace(marked, marks=tuple(found))


@lru_cache(maxsize=1000)
def shown(points: Fraction) -> str:
    """Points as a decimal number of at most four places."""
    return f"{float(points):.4f}".rstrip("0").rstrip(".")


def cause_text(cause: Cause | None) -> str:
    """A cause as ``marks.csv`` has it: ``mistake: normal acceleration of AB forgotten``."""
    if cause is None:
        return ""
    return f"{cause.name}: {cause.detail}" if cause.detail else cause.name


def _row(record: Manifest, item: MarkedAnswer, anonymous: bool) -> Sequence[object]:
    sheet = record.sheets[item.place]
    student = sheet.student
    return (
        *_who(student.id, student.name, student.group, anonymous),
        sheet.code,
        item.problem,
        safe_cell(item.form),
        item.answer.quantity.name,
        safe_cell(item.text),
        "" if item.value is None else repr(item.value),
        item.answer.unit.name,
        repr(item.answer.value),
        item.verdict.value,
        safe_cell(cause_text(item.cause)),
        shown(item.points),
        shown(item.of),
    )


def _who(id_: str, name: str, group: str, anonymous: bool) -> tuple[str, str, str]:
    return ("", "", "") if anonymous else (safe_cell(id_), safe_cell(name), safe_cell(group))


def _write(path: Path, rows: Sequence[Sequence[object]]) -> None:
    path.write_bytes(("\ufeff" + csv_rows(rows)).encode())
