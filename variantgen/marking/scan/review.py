"""What a person has to look at: ``review.html`` with pictures, ``review.csv`` to type into.

Whoever looks types what is on paper into the column ``reading`` of ``review.csv``, and marks again with this file among
the answers. What has been typed before stands in it again.
"""

from __future__ import annotations

import base64
import csv
import io
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import Any

from markupsafe import Markup

from variantgen.errors import InputError, Problem
from variantgen.finished.restore import Finished
from variantgen.marking.answer_tables import HandedIn
from variantgen.marking.key import Key
from variantgen.marking.scan.collecting import LostPage, Question
from variantgen.marking.scan.copies import ScannedAnswer
from variantgen.marking.typed_number import read_number
from variantgen.outputs.files.records import safe_cell
from variantgen.outputs.html.pages import write_page
from variantgen.wording.mathml import to_mathml

PAGE, TABLE = "review.html", "review.csv"
FILES = (PAGE, TABLE)
_HEAD = ("student", "problem", "quantity", "reading", "read", "why", "where")


def typed_before(key: Key, answers: Sequence[HandedIn]) -> dict[Question, str]:
    """What was typed by question: these answers stand, whatever is on the scans."""
    found: dict[Question, str] = {}
    for item in answers:
        if not item.text.strip() or not item.who:
            continue
        try:
            place = key.student(item.who)
        except InputError:
            continue  # told where answers are matched
        name, _ = key.quantity(place, item.problem, item.quantity)
        if name:
            found.setdefault((place, item.problem, name), item.text)
    return found


def check_readings_kept(out: Path, tables: Sequence[Path]) -> None:
    """Raise InputError where readings of an earlier review would be lost: its table is not among those given."""
    table = out / TABLE
    if not table.is_file() or any(path.exists() and path.samefile(table) for path in tables):
        return
    try:
        text = table.read_text("utf-8-sig")
        rows = list(csv.DictReader(io.StringIO(text), delimiter=";" if ";" in text.partition("\n")[0] else ","))
    except (OSError, UnicodeDecodeError, csv.Error):
        return
    if any((row.get("reading") or "").strip() for row in rows):
        remedy = "name it among the answers, or choose another folder"
        raise InputError(Problem("holds readings that would be replaced", file=str(table), remedy=remedy))


def write_review(
    folder: Path,
    finished: Finished,
    doubtful: Mapping[Question, ScannedAnswer],
    typed: Mapping[Question, str],
    lost: Collection[LostPage],
    anonymous: bool,
) -> None:
    """Write both files: all doubtful answers with what was typed of them, and pages that could not be read.

    Pages have the names of students in their heads, and where the head of such a page is nobody knows: ``anonymous``
    leaves their pictures out.
    """
    _write_table(folder, finished, doubtful, typed)
    words = finished.exam.spoken.words("review")
    rows = [
        _row(finished, question, answer, words)
        for question, answer in doubtful.items()
        if question not in typed and answer.picture  # what has no picture is on a page that is lost
    ]
    write_page(
        folder / PAGE,
        "review.html.j2",
        lang=finished.exam.language,
        course=finished.exam.course,
        heading=finished.exam.title,
        words=words,
        table=TABLE,
        answers=rows,
        typed=len(typed.keys() & doubtful.keys()),
        lost=[
            {"where": page.where, "why": page.why, "picture": "" if anonymous else _data(page.picture)} for page in lost
        ],
    )


def _write_table(
    folder: Path, finished: Finished, doubtful: Mapping[Question, ScannedAnswer], typed: Mapping[Question, str]
) -> None:
    """The table in which readings are typed."""
    mark, sheets = finished.exam.spoken.decimal_mark, finished.record.sheets
    with (folder / TABLE).open("w", encoding="utf-8-sig", newline="") as file:
        writer = csv.writer(file, delimiter=";" if mark == "," else ",", lineterminator="\r\n")
        writer.writerow(_HEAD)
        for (place, problem, name), answer in doubtful.items():
            reading = _cell(typed.get((place, problem, name), ""))
            own = _cell(answer.read.text.replace(".", mark)), ", ".join(answer.read.why)
            writer.writerow([sheets[place].code, problem, name, reading, *own, safe_cell(answer.where)])


def _row(finished: Finished, question: Question, answer: ScannedAnswer, words: Mapping[str, str]) -> dict[str, Any]:
    """A doubtful answer as the page shows it."""
    place, problem, name = question
    language, variant = finished.exam.spoken, finished.variant(place, problem)
    key = next(a for a in Key(finished.record).answers(place, problem) if a.quantity.name == name)
    symbol = language.quantity(key.quantity, dict(variant.form.symbols))
    return {
        "code": finished.record.sheets[place].code,
        "problem": problem,
        "quantity": name,
        "symbol": Markup(to_mathml(symbol)),  # noqa: S704
        "read": answer.read.text.replace(".", language.decimal_mark).replace("-", "\N{MINUS SIGN}"),
        "why": [words[f"why.{why.replace(' ', '_')}"] for why in answer.read.why],
        "where": answer.where,
        "picture": _data(answer.picture),
    }


def _cell(text: str) -> str:
    """A text that no spreadsheet runs; a number, be it negative, stays one."""
    return text if read_number(text) else safe_cell(text)


def _data(picture: bytes) -> str:
    return f"data:image/png;base64,{base64.b64encode(picture).decode()}" if picture else ""
