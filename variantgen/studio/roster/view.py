"""What the page Roster shows of a table: its rows, its questions, what changed since the last build."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from variantgen.errors import InputError
from variantgen.exam.manifest import Manifest, read_manifest
from variantgen.exam.roster import Student
from variantgen.exam.roster.columns import cell_of
from variantgen.exam.roster.reading import only_counts
from variantgen.finished.late import Changes, changes
from variantgen.studio.documents.document import Document
from variantgen.studio.messages import error_text
from variantgen.studio.roster.students import ANSWERS, ClassReading, read_students
from variantgen.studio.roster.table import KINDS, ClassTable, Tab, file_hash
from variantgen.studio.studio import Studio
from variantgen.studio.summary import built_words
from variantgen.studio.words import page_words
from variantgen.studio.workspace import ROSTER

_SHOWN = 300  # rows of a worksheet, besides those with questions
_LISTED = 60  # changes of a kind
_WIDEST = 40  # columns


def last_build(studio: Studio, document: Document) -> Manifest | None:
    """The manifest of the last build of an exam; None without one that can be read."""
    for build in studio.builds.finished(document.key).values():
        try:
            return read_manifest(build.folder)
        except InputError:
            continue
    return None


def students_of(record: Manifest | None) -> tuple[Student, ...]:
    """The students of a build."""
    return tuple(sheet.student for sheet in record.sheets) if record else ()


def look(studio: Studio, document: Document, place: int, language: str) -> dict[str, Any]:
    """What the table shows."""
    try:
        table, fault = studio.class_tables.current(), ""
    except InputError as error:
        table, fault = None, error_text(error, language)
    seen = {"key": studio.class_tables.key(), "version": studio.class_tables.version()}
    if table is None:
        return {"table": None, "fault": fault, **seen}
    record = last_build(studio, document)
    reading = read_students(table, students_of(record))
    words = page_words(language)
    taken = table.taken == file_hash(studio.workspace.roster()) != ""
    shown = min(place, len(table.tabs) - 1)
    return {
        "table": table,
        **seen,
        "fault": "",
        "file": ROSTER,
        "kinds": KINDS,
        "tab": shown,
        "rows": _rows(table.tabs[shown], shown, reading),
        "letters": [_letter(column) for column in range(len(table.tabs[shown].kinds))][:_WIDEST],
        "reading": reading,
        "answers": ANSWERS,
        "asked": words.counted(len(reading.questions) + len(reading.nameless), "question"),
        "taken": taken,
        "students": words.counted(len(reading.students), "student"),
        "counts": _counts(table, reading),
        "hidden": max(len(table.tabs[shown].rows) - _SHOWN, 0),
        "boxes": _boxes(reading.students),
        "since": _since(record, reading, studio, document, language),
    }


def _boxes(students: Sequence[Student]) -> list[str]:
    """The names with a letter that the fonts for paper lack: a build with PDF would refuse them."""
    from variantgen.outputs.typst.coverage import absent_letters

    absent = absent_letters(text for student in students for text in (student.name, student.group))
    return [student.name for student in students if absent & {*student.name, *student.group}]


def _rows(tab: Tab, place: int, reading: ClassReading) -> list[dict[str, Any]]:
    """The rows of a worksheet: titles, students, those left out, each with its questions."""
    asked = {question.row: question for question in reading.questions if question.row[0] == place}
    found: list[dict[str, Any]] = []
    for i, (number, cells) in enumerate(tab.rows):
        question = asked.get((place, number))
        if i >= _SHOWN and question is None:
            continue
        filled = [cells[k] if k < len(cells) else "" for k in range(len(tab.kinds))][:_WIDEST]
        state = "title" if i < tab.begin else "left" if (place, number) in reading.left or not tab.used else ""
        kept = (place, number)
        found.append({"i": i, "number": number, "cells": filled, "state": state, "question": question, "row": kept})
    return found


def _letter(column: int) -> str:
    """The name of a column in a spreadsheet: A, B, ..., AA."""
    text = ""
    column += 1
    while column:
        column, rest = divmod(column - 1, 26)
        text = chr(ord("A") + rest) + text
    return text


def _counts(table: ClassTable, reading: ClassReading) -> dict[str, Any]:
    """What is counted of a table: rows of each worksheet, questions of each kind, groups."""
    kinds: dict[str, int] = {}
    for question in reading.questions:
        kinds[question.kind] = kinds.get(question.kind, 0) + 1
    rows = [max(len(tab.rows) - tab.begin, 0) for tab in table.tabs]
    first = {question.kind: question.row[1] for question in reversed(reading.questions)}
    groups = sorted((name, count) for name, count in reading.groups.items() if name)
    return {
        "rows": rows,
        "kinds": kinds,
        "first": first,
        "groups": groups,
        "with_id": any("id" in tab.kinds for tab in table.tabs if tab.used),
        "counting": only_counts(_ids(table)),
    }


def _ids(table: ClassTable) -> list[list[str]]:
    """What stands in the columns of ids, by worksheet."""
    used = [tab for tab in table.tabs if tab.used and "id" in tab.kinds]
    return [[cell_of(cells, tab.kinds.index("id")) for _, cells in tab.rows[tab.begin :]] for tab in used]


def _since(
    record: Manifest | None, reading: ClassReading, studio: Studio, document: Document, language: str
) -> dict[str, Any] | None:
    """The changes of the class since the last build; None without one."""
    if record is None or not reading.students:
        return None
    words = page_words(language)
    found: Changes = changes([record], reading.students)
    same = len(reading.students) - len(found.new)
    day = next(iter(studio.builds.finished(document.key).values())).day
    asked = {question.now.id for question in reading.questions if question.now}
    questioned = {question.before.id for question in reading.questions if question.before}
    new = [student for student in found.new if student.id not in asked]
    gone = [student for student in found.gone if student.id not in questioned]
    return {
        "day": built_words(words, day),
        "then": words.counted(len(record.sheets), "student"),
        "now": words.counted(len(reading.students), "student"),
        "same": words.counted(same, "sheet"),
        "asked": [question for question in reading.questions if question.kind == "same"][:_LISTED],
        "new": new[:_LISTED],
        "gone": gone[:_LISTED],
        "changed": found.changed[:_LISTED],
        "more": max(len(new), len(gone), len(found.changed), 0) > _LISTED,
    }
