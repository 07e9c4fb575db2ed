"""Sums of a class as files that the gradebooks of Moodle and Canvas import.

Moodle (grades, import, CSV file) finds a student by the column that the teacher maps, takes points with a decimal
point, and ``-`` for no grade. Canvas (gradebook, import) finds one by the SIS id, looks for ``Student`` in the first
head, ``ID`` in the second and ``Section`` before the marks, and takes a number in brackets at the end of a head for
the number of an assignment. Who handed in nothing has no grade in either, nor
has anybody while answers have to be looked at: the sum is not final.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from variantgen.marking.marks import Marked, StudentTotal
from variantgen.marking.records import shown
from variantgen.outputs.files.records import csv_rows, safe_cell

MOODLE, CANVAS = "gradebook_moodle.csv", "gradebook_canvas.csv"
FILES = (MOODLE, CANVAS)
_NUMBER_AT_END = re.compile(r"\((\d+)\)$")


def write_gradebooks(folder: Path, title: str, marked: Marked) -> None:
    """Write the files; ``title`` heads the column with the points."""
    name = " ".join(title.split()) or "Exam"
    head: Sequence[str] = ("ID number", "Name", "Group", safe_cell(name))
    rows = [(*_texts(total, "id", "name", "group"), _points(total, "-")) for total in marked.totals]
    _write(folder / MOODLE, [head, *rows])
    most = max((total.of for total in marked.totals), default=None)
    column = _NUMBER_AT_END.sub(r"[\1]", name)
    rows = [
        ("Student", "ID", "SIS User ID", "SIS Login ID", "Section", safe_cell(column)),
        ("    Points Possible", "", "", "", "", shown(most) if most is not None else ""),
    ]
    for total in marked.totals:
        student, id_, group = _texts(total, "name", "id", "group")
        rows.append((student, "", id_, "", group, _points(total, "")))
    _write(folder / CANVAS, rows)


def _texts(total: StudentTotal, *names: str) -> tuple[str, ...]:
    return tuple(safe_cell(getattr(total.student, name)) for name in names)


def _points(total: StudentTotal, nothing: str) -> str:
    return shown(total.points) if total.handed_in and not total.open else nothing


def _write(path: Path, rows: Sequence[Sequence[str]]) -> None:
    path.write_bytes(csv_rows(rows).encode())
