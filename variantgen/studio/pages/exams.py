"""The first page: the exams of the folder, a new one; and what changes an exam from any page."""

from __future__ import annotations

from functools import partial
from typing import Any
from urllib.parse import quote

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, RedirectResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError, Problem
from variantgen.limits import TOML_BYTES
from variantgen.studio.deeds import change
from variantgen.studio.documents.document import Document
from variantgen.studio.documents.edits import read_operations, written
from variantgen.studio.documents.journal import FileChange
from variantgen.studio.frame import command, language_of, render, step_words
from variantgen.studio.messages import in_language
from variantgen.studio.requests import WINDOW, document_of, read_json, studio_of, text_of
from variantgen.studio.studio import Studio
from variantgen.studio.summary import problems_of, summary
from variantgen.studio.words import PageWords, page_words
from variantgen.studio.workspace import write_whole


async def exams(request: Request) -> Response:
    """The page; with one exam, straight to it."""
    studio = studio_of(request)
    found = studio.workspace.exams()
    language = language_of(request)
    unreadable = {name: in_language(reason, language) for name, reason in studio.workspace.unreadable().items()}
    if len(found) == 1 and not unreadable and "all" not in request.query_params:
        key = next(iter(found))
        page = "compose" if problems_of(studio.document(key)) else "choose"
        return RedirectResponse(f"/{key}/{page}", 303)
    words = page_words(language)
    listed = [_row(studio.document(key), words) for key in found]
    line = command("variantgen", "new", "exam", "exam")
    return render(request, "exams", studio, command=line, listed=listed, unreadable=unreadable)


async def create(request: Request) -> Response:
    """A new exam file."""
    workspace, data = studio_of(request).workspace, await read_json(request)
    title, language = text_of(data, "title", 200).strip(), text_of(data, "language")
    if not title:
        raise InputError(Problem("missing, expected a title", key="title"))
    if language not in ("en", "ru"):
        raise InputError(Problem("unknown language", key="language", value=language))
    path = workspace.new_exam_path(title)
    lines = ["schema = 1", f"title = {written(title)}", f"language = {written(language)}", "seed = 2026"]
    write_whole(path, "\n".join([*lines, "tolerance = 0.02", ""]))
    key = next(key for key, known in workspace.exams().items() if known == path)
    return JSONResponse({"address": f"/{key}/choose"})


async def edit(request: Request) -> Response:
    """Change values of an exam, made on the version that is told."""
    studio, document, data = studio_of(request), document_of(request), await read_json(request)
    operations = read_operations(data.get("operations"))
    window, version = text_of(data, "window", WINDOW), text_of(data, "version")
    merged = document.edit(operations, version, window, text_of(data, "about"))
    studio.tell_changed(document, window)
    return JSONResponse({**answer(request, studio, document), "merged": merged})


async def text(request: Request) -> Response:
    """Replace the whole text of an exam."""
    studio, document, data = studio_of(request), document_of(request), await read_json(request)
    window = text_of(data, "window", WINDOW)
    document.replace(text_of(data, "text", TOML_BYTES), text_of(data, "version"), window)
    studio.workspace.state("drafts", f"{document.key}.json").unlink(missing_ok=True)
    studio.tell_changed(document, window)
    return JSONResponse(answer(request, studio, document))


async def state(request: Request) -> Response:
    """The version of an exam, what undo takes back, the numbers under the steps."""
    return JSONResponse(answer(request, studio_of(request), document_of(request)))


async def undo(request: Request) -> Response:
    """Take the last change of an exam back."""
    return await _moved(request, -1)


async def redo(request: Request) -> Response:
    """Do again what was taken back."""
    return await _moved(request, +1)


async def _moved(request: Request, by: int) -> Response:
    studio, document, data = studio_of(request), document_of(request), await read_json(request)
    version, position = text_of(data, "version"), text_of(data, "position") or None
    step = await run_in_threadpool(document.undo, by, version, partial(change, studio, document), position)
    studio.tell_changed(document, text_of(data, "window", WINDOW))
    return JSONResponse(
        {**answer(request, studio, document), "done": step is not None, "place": _place(document, step)}
    )


def _place(document: Document, step: FileChange | None) -> dict[str, Any]:
    """Where a step is seen: the pages that show it, the first of them as an address; nothing for none."""
    if step is None:
        return {}
    if step.deed.get("kind") == "list":
        return {"pages": ["roster"], "address": f"/{document.key}/roster"}
    if step.deed:
        about = step.deed.get("code", ""), step.deed.get("problem", ""), step.deed.get("quantity", "")
        build = quote(step.deed.get("build", ""))
        return {
            "pages": ["mark"],
            "address": f"/{document.key}/mark?build={build}#{quote('.'.join(filter(None, about)))}",
        }
    pages = {"insert": ["compose", "choose"], "remove": ["compose", "choose"], "changed": ["compose", "build"]}
    number = quote(step.about.get("number", ""))
    return {"pages": pages.get(step.words, ["compose"]), "address": f"/{document.key}/compose#{number}"}


def answer(request: Request, studio: Studio, document: Document) -> dict[str, Any]:
    """The state of an exam after a change: its version, what undo takes back, the numbers under the steps."""
    words, state = page_words(language_of(request)), document.state()
    return {
        "version": state.version,
        "position": document.journal.position,
        "undo": step_words(words, document.journal.undoable),
        "redo": step_words(words, document.journal.redoable),
        "under": summary(words, studio, document),
    }


def _row(document: Document, words: PageWords) -> dict[str, str]:
    """An exam in the list of all."""
    state = document.state()
    title = state.data.get("title")
    return {
        "key": document.key,
        "file": document.path.name,
        "title": title if isinstance(title, str) and title else document.path.stem,
        "under": in_language(state.broken, words.language) or words.counted(len(problems_of(document)), "problem"),
        "page": "compose" if problems_of(document) else "choose",
    }


ROUTES = [
    Route("/", exams),
    Route("/exams", create, methods=["POST"]),
    Route("/{exam}/state", state),
    Route("/{exam}/edit", edit, methods=["POST"]),
    Route("/{exam}/text", text, methods=["POST"]),
    Route("/{exam}/undo", undo, methods=["POST"]),
    Route("/{exam}/redo", redo, methods=["POST"]),
]
