"""Roster: a class list brought as a file or pasted, its columns named by sight, compared with the last build."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError, Problem
from variantgen.exam.manifest import Manifest, read_manifest
from variantgen.exam.roster import Student, read_class
from variantgen.finished.late import Changes, changes
from variantgen.limits import ROSTER_BYTES
from variantgen.studio.documents.document import Document
from variantgen.studio.frame import build_command, language_of, part, render
from variantgen.studio.requests import number_of, read_json, read_upload, text_of
from variantgen.studio.roster.students import ANSWERS, ClassReading, read_students, roster_csv
from variantgen.studio.roster.table import KINDS, ClassTable, ClassTables, Tab, file_hash
from variantgen.studio.studio import Studio
from variantgen.studio.summary import built_words, summary
from variantgen.studio.words import page_words
from variantgen.studio.workspace import ROSTER, write_whole

_SHOWN = 300  # rows of a worksheet, besides those with questions
_LISTED = 60  # changes of a kind
_WIDEST = 40  # columns


@dataclass(frozen=True)
class _Page:
    """What the addresses of this page share."""

    studio: Studio
    tables: ClassTables

    def opened(self, request: Request) -> Document:
        return self.studio.document(request.path_params["exam"])


def routes(studio: Studio) -> list[Route]:
    """The addresses of this page; they raise InputError for requests that do not fit."""
    page = _Page(studio, ClassTables(studio.workspace))
    return [
        Route("/{exam}/roster", partial(_roster, page)),
        Route("/{exam}/roster/shown", partial(_shown, page)),
        Route("/{exam}/roster/table", partial(_bring, page), methods=["PUT"]),
        Route("/{exam}/roster/say", partial(_say, page), methods=["POST"]),
        Route("/{exam}/roster/use", partial(_use, page), methods=["POST"]),
        Route("/{exam}/roster/back", partial(_back, page), methods=["POST"]),
    ]


async def _roster(page: _Page, request: Request) -> Response:
    """The whole page; its table comes afterwards."""
    document = page.opened(request)
    return render(request, "roster", page.studio, document, build_command(page.studio, document))


async def _shown(page: _Page, request: Request) -> Response:
    """The table, the changes and what is left to do, as a piece of the page."""
    document, language = page.opened(request), language_of(request)
    tab = number_of(request.query_params.get("tab", "0"), "tab", 0, 10_000)
    found = await run_in_threadpool(_look, page, document, tab, language)
    return HTMLResponse(part(request, "roster_table", "roster", exam=document.key, **found))


async def _bring(page: _Page, request: Request) -> Response:
    """A table in place of the one before; its name is shown and names nothing on disk."""
    page.opened(request)
    name = request.query_params.get("name", "")[:200]
    content = await read_upload(request, ROSTER_BYTES)
    await run_in_threadpool(page.tables.bring, content, name)
    return JSONResponse({})


async def _say(page: _Page, request: Request) -> Response:
    """What a column, a row, a worksheet is, or the answer to a question."""
    data = await read_json(request)
    page.opened(request)
    await run_in_threadpool(_said, page, data)
    return JSONResponse({})


async def _use(page: _Page, request: Request) -> Response:
    """Write the class list; the one before can be taken back."""
    await read_json(request)
    document, language = page.opened(request), language_of(request)
    count = await run_in_threadpool(_written, page, document)
    return JSONResponse({"students": count, **_frame(page, document, language)})


async def _back(page: _Page, request: Request) -> Response:
    """Put the class list back that was there before."""
    await read_json(request)
    document = page.opened(request)
    await run_in_threadpool(_put_back, page)
    return JSONResponse(_frame(page, document, language_of(request)))


def _frame(page: _Page, document: Document, language: str) -> dict[str, Any]:
    """What changes around the page with the class list."""
    words = page_words(language)
    return {"under": summary(words, page.studio, document), "command": build_command(page.studio, document)}


def _said(page: _Page, data: Mapping[str, Any]) -> None:
    if not page.tables.is_brought():
        page.tables.adopt()
    table = page.tables.current()
    if table is None:
        raise InputError(Problem("there is no table", remedy="bring one"))
    answer, key = text_of(dict(data), "answer"), text_of(dict(data), "question", 1000)
    if key:
        if answer not in {"", *(known for own in ANSWERS.values() for known in own)}:
            raise InputError(Problem("unknown answer", key=key, value=answer))
        answers = {**table.answers, key: answer} if answer else {k: v for k, v in table.answers.items() if k != key}
        page.tables.say(replace(table, answers=answers, taken=""))
        return
    place = number_of(data.get("tab", 0), "tab", 0, len(table.tabs) - 1)
    changed = _changed(table.tabs[place], data)
    tabs = (*table.tabs[:place], changed, *table.tabs[place + 1 :])
    page.tables.say(replace(table, tabs=tabs, taken=""))


def _changed(tab: Tab, data: Mapping[str, Any]) -> Tab:
    """A worksheet with one thing that is said of it."""
    if isinstance(data.get("used"), bool):
        return replace(tab, used=data["used"])
    if "begin" in data:
        return replace(tab, begin=number_of(data["begin"], "begin", 0, len(tab.rows)))
    column = number_of(data.get("column"), "column", 0, len(tab.kinds) - 1)
    kind = text_of(dict(data), "kind")
    if kind not in KINDS:
        raise InputError(Problem("unknown kind", key="kind", value=kind))
    kinds = ["" if kind and other == kind else other for other in tab.kinds]  # each stands once
    kinds[column] = kind
    return replace(tab, kinds=tuple(kinds))


def _written(page: _Page, document: Document) -> int:
    """Write the class list of the table that was brought; the number of students. Raises InputError."""
    table = page.tables.current()
    record = _last(page, document)
    reading = read_students(table, _before(record)) if table else None
    if table is None or reading is None or not reading.is_ready:
        raise InputError(Problem("the table still has questions", remedy="answer them first"))
    workspace = page.studio.workspace
    before, path, trial = workspace.roster(), workspace.folder / ROSTER, workspace.state("roster", "trial.csv")
    text = roster_csv(reading.students)
    write_whole(trial, text)
    try:
        found = read_class(trial)  # as a build reads it: what it would refuse is not written
    finally:
        trial.unlink(missing_ok=True)
    old = workspace.state("roster", "before.csv")
    if before is None:
        old.unlink(missing_ok=True)
    else:
        write_whole(old, before.read_bytes())
    write_whole(path, text)
    page.tables.remember(table)
    if page.tables.is_brought():
        page.tables.say(replace(table, taken=file_hash(path)))
    return len(found.students)


def _put_back(page: _Page) -> None:
    workspace = page.studio.workspace
    old, path = workspace.state("roster", "before.csv"), workspace.roster()
    table = page.tables.current() if page.tables.is_brought() else None
    if old.is_file():
        write_whole(workspace.folder / ROSTER, old.read_bytes())
        old.unlink()
    elif path is not None:
        path.unlink()
    if table is not None:
        page.tables.say(replace(table, taken=""))


def _last(page: _Page, document: Document) -> Manifest | None:
    """The manifest of the last build of an exam; None without one that can be read."""
    for build in page.studio.builds.finished(document.key).values():
        try:
            return read_manifest(build.folder)
        except InputError:
            continue
    return None


def _before(record: Manifest | None) -> tuple[Student, ...]:
    return tuple(sheet.student for sheet in record.sheets) if record else ()


def _look(page: _Page, document: Document, place: int, language: str) -> dict[str, Any]:
    """What the table shows."""
    try:
        table, fault = page.tables.current(), ""
    except InputError as error:
        table, fault = None, str(error)
    if table is None:
        return {"table": None, "fault": fault}
    record = _last(page, document)
    reading = read_students(table, _before(record))
    words = page_words(language)
    taken = table.taken == file_hash(page.studio.workspace.roster()) != ""
    shown = min(place, len(table.tabs) - 1)
    return {
        "table": table,
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
        "since": _since(record, reading, page, document, language),
    }


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
        "hidden": max(len(table.tabs[0].rows) - _SHOWN, 0) if len(table.tabs) == 1 else 0,
    }


def _since(
    record: Manifest | None, reading: ClassReading, page: _Page, document: Document, language: str
) -> dict[str, Any] | None:
    """The changes of the class since the last build; None without one."""
    if record is None:
        return None
    words = page_words(language)
    found: Changes = changes([record], reading.students)
    same = len(reading.students) - len(found.new)
    day = next(iter(page.studio.builds.finished(document.key).values())).day
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
