"""Roster: a class list brought as a file or pasted, its columns named by sight, compared with the last build."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

from msgspec.structs import replace
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import HTMLResponse, JSONResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError, Problem
from variantgen.limits import ROSTER_BYTES
from variantgen.studio.documents.document import ConflictError, Document
from variantgen.studio.frame import build_command, language_of, part, render
from variantgen.studio.pages.exams import answer
from variantgen.studio.requests import WINDOW, document_of, number_of, read_json, read_upload, studio_of, text_of
from variantgen.studio.studio import Studio
from variantgen.studio.workspace import write_whole

if TYPE_CHECKING:
    from variantgen.studio.roster.table import ClassTables, Tab

P = ParamSpec("P")
T = TypeVar("T")


async def roster(request: Request) -> Response:
    """The whole page; its table comes afterwards."""
    studio, document = studio_of(request), document_of(request)
    return render(request, "roster", studio, document, build_command(studio, document))


async def shown(request: Request) -> Response:
    """The table, the changes and what is left to do, as a piece of the page."""
    from variantgen.studio.roster.view import look

    document, language = document_of(request), language_of(request)
    tab = number_of(request.query_params.get("tab", "0"), "tab", 0, 10_000)
    found = await run_in_threadpool(
        _alone, studio_of(request).class_tables, look, studio_of(request), document, tab, language
    )
    return HTMLResponse(
        part(
            request,
            "roster_table",
            "roster",
            exam=document.key,
            command=build_command(studio_of(request), document),
            **found,
        )
    )


async def bring(request: Request) -> Response:
    """A table in place of the one before; its name is shown and names nothing on disk."""
    document_of(request)
    name = request.query_params.get("name", "")[:200]
    content = await read_upload(request, ROSTER_BYTES)
    tables = studio_of(request).class_tables
    return JSONResponse(await run_in_threadpool(_alone, tables, _brought, tables, content, name))


async def say(request: Request) -> Response:
    """What a column, a row, a worksheet is, or the answer to a question."""
    data = await read_json(request)
    document_of(request)
    studio = studio_of(request)
    version = await run_in_threadpool(_alone, studio.class_tables, _said, studio, data)
    return JSONResponse({"version": version})


async def take(request: Request) -> Response:
    """Let a table that was brought before be the one that is looked at, or none."""
    data = await read_json(request)
    document_of(request)
    tables = studio_of(request).class_tables
    await run_in_threadpool(_alone, tables, _taken, tables, data)
    return JSONResponse({})


async def use(request: Request) -> Response:
    """Write the class list; the one before can be taken back."""
    data = await read_json(request)
    studio, document = studio_of(request), document_of(request)
    count = await run_in_threadpool(_alone, studio.class_tables, _written, studio, document, data)
    return JSONResponse({"students": count, **answer(request, studio, document)})


def _alone(tables: ClassTables, work: Callable[P, T], *given: P.args, **named: P.kwargs) -> T:
    """Do work on the table while no other window does."""
    with tables.lock:
        return work(*given, **named)


def _compare(tables: ClassTables, data: dict[str, Any]) -> None:
    """Raise ConflictError where the table is no longer as the window that asks has seen it."""
    if text_of(data, "version") != tables.version():
        now = tables.current()
        raise ConflictError("table", "", now.name if now else "")


def _brought(tables: ClassTables, content: bytes, name: str) -> dict[str, str]:
    """Bring a table; the key of the one before."""
    before = tables.key()
    tables.bring(content, name)
    return {"before": before}


def _taken(tables: ClassTables, data: dict[str, Any]) -> None:
    """Put another table in the place of the one that the window has seen. Raises ConflictError, InputError."""
    _compare(tables, data)
    tables.take(text_of(data, "table"))


def _said(studio: Studio, data: dict[str, Any]) -> str:
    """Keep what is said of the table; its new version. Raises ConflictError, InputError for what does not fit."""
    _compare(studio.class_tables, data)
    _say(studio, data)
    return studio.class_tables.version()


def _say(studio: Studio, data: dict[str, Any]) -> None:
    from variantgen.studio.roster.students import ANSWERS

    if not studio.class_tables.is_brought():
        studio.class_tables.adopt()
    table = studio.class_tables.current()
    if table is None:
        raise InputError(Problem("there is no table", remedy="bring one"))
    answer, key = text_of(data, "answer"), text_of(data, "question", 1000)
    if key:
        if answer not in {"", *(known for own in ANSWERS.values() for known in own)}:
            raise InputError(Problem("unknown answer", key=key, value=answer))
        answers = {**table.answers, key: answer} if answer else {k: v for k, v in table.answers.items() if k != key}
        studio.class_tables.say(replace(table, answers=answers, taken=""))
        return
    place = number_of(data.get("tab", 0), "tab", 0, len(table.tabs) - 1)
    own, changed = table.tabs[place], _changed(table.tabs[place], data)
    alike = {i for i, tab in enumerate(table.tabs) if tab.head == own.head != "" and tab.kinds == own.kinds}
    if own.kinds == changed.kinds:  # what columns hold is said once for all tabs with the same heads
        alike = set()
    tabs = (
        changed if i == place else replace(tab, kinds=changed.kinds) if i in alike else tab
        for i, tab in enumerate(table.tabs)
    )
    studio.class_tables.say(replace(table, tabs=tuple(tabs), taken=""))


def _changed(tab: Tab, data: dict[str, Any]) -> Tab:
    """A worksheet with one thing that is said of it."""
    from variantgen.studio.roster.table import KINDS

    if isinstance(data.get("used"), bool):
        return replace(tab, used=data["used"])
    if "begin" in data:
        return replace(tab, begin=number_of(data["begin"], "begin", 0, len(tab.rows)))
    column = number_of(data.get("column"), "column", 0, len(tab.kinds) - 1)
    kind = text_of(data, "kind")
    if kind not in KINDS:
        raise InputError(Problem("unknown kind", key="kind", value=kind))
    kinds = ["" if kind and other == kind else other for other in tab.kinds]  # each stands once
    kinds[column] = kind
    return replace(tab, kinds=tuple(kinds))


def _written(studio: Studio, document: Document, data: dict[str, Any]) -> int:
    """Write the class list of the table that was brought; the number of students.

    Raises ConflictError where the window has seen another table, InputError.
    """
    from variantgen.exam.roster import read_class
    from variantgen.studio.roster.lists import write_list
    from variantgen.studio.roster.students import read_students, roster_csv
    from variantgen.studio.roster.view import last_build, students_of

    _compare(studio.class_tables, data)
    table = studio.class_tables.current()
    reading = read_students(table, students_of(last_build(studio, document))) if table else None
    if table is None or reading is None or not reading.is_ready:
        raise InputError(Problem("the table still has questions", remedy="answer them first"))
    trial, text = studio.workspace.state("roster", "trial.csv"), roster_csv(reading.students)
    write_whole(trial, text)
    try:
        found = read_class(trial)  # as a build reads it: what it would refuse is not written
    finally:
        trial.unlink(missing_ok=True)
    is_brought = studio.class_tables.is_brought()
    before, written = write_list(studio.workspace, text)
    if before != written:
        deed = {"kind": "list", "before": before, "after": written}
        about = {"count": str(len(found.students))}
        studio.note(document, "class_list", about, deed, text_of(data, "window", WINDOW))
    studio.class_tables.remember(table)
    if is_brought:
        studio.class_tables.say(replace(table, taken=written))
    return len(found.students)


ROUTES = [
    Route("/{exam}/roster", roster),
    Route("/{exam}/roster/shown", shown),
    Route("/{exam}/roster/table", bring, methods=["PUT"]),
    Route("/{exam}/roster/say", say, methods=["POST"]),
    Route("/{exam}/roster/take", take, methods=["POST"]),
    Route("/{exam}/roster/use", use, methods=["POST"]),
]
