"""Mark: answers brought or typed, one student or one question at a time, doubtful scans, the rules, the class."""

from __future__ import annotations

import json
import os
import secrets
from typing import TYPE_CHECKING

from starlette.background import BackgroundTask
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import FileResponse, HTMLResponse, JSONResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError, Problem
from variantgen.studio.building.preview import KINDS
from variantgen.studio.frame import command, language_of, part, render
from variantgen.studio.messages import command_text, error_text
from variantgen.studio.pages.archive import run_command
from variantgen.studio.pages.mark_changes import marking_of
from variantgen.studio.requests import document_of, number_of, read_json, studio_of
from variantgen.studio.studio import UnknownKeyError
from variantgen.studio.summary import built_words
from variantgen.studio.words import page_words

if TYPE_CHECKING:
    from variantgen.studio.marking.folder import MarkingFolder
    from variantgen.studio.marking.marked import MarkedClass

_VIEWS = ("students", "questions", "class")


async def mark(request: Request) -> Response:
    """The page; what it shows comes in pieces."""
    from variantgen.studio.marking.changes import command_of

    studio, document = studio_of(request), document_of(request)
    builds = await run_in_threadpool(studio.builds.finished, document.key)
    chosen = builds.get(request.query_params.get("build", "")) or next(iter(builds.values()), None)
    words = page_words(language_of(request))
    listed = [
        {"key": one.key, "name": built_words(words, one.day), "folder": one.folder.name} for one in builds.values()
    ]
    line = command_of(studio, studio.marking(chosen)[0]) if chosen else command("variantgen", "mark", "--help")
    view = request.query_params.get("view", "")
    view = view if view in _VIEWS else _VIEWS[0]
    return render(request, "mark", studio, document, line, builds=listed, build=chosen and chosen.key, view=view)


async def listing(request: Request) -> Response:
    """The class or the questions in a list, the files, what is wrong with them."""
    folder, marked = marking_of(request)
    found, language = await run_in_threadpool(marked.current), language_of(request)
    return HTMLResponse(await run_in_threadpool(_listing, request, folder, found, language))


async def shown(request: Request) -> Response:
    """One student, one question or the class."""
    folder, marked = marking_of(request)
    found, language = await run_in_threadpool(marked.current), language_of(request)
    return HTMLResponse(await run_in_threadpool(_shown, request, folder, found, language))


async def find(request: Request) -> Response:
    """The sheet that is meant by a code that was scanned or typed, a name or an id."""
    from variantgen.finished.find import find_among

    _, marked = marking_of(request)
    found = await run_in_threadpool(marked.current)
    record = found.finished.record
    place = find_among(record.sheets, record.exam_id, request.query_params.get("who", "")[:200])
    return JSONResponse({"code": record.sheets[place].code})


async def write(request: Request) -> Response:
    """Write the marks by the command that the page shows."""
    from variantgen.studio.marking.changes import command_of, words_of_command

    await read_json(request)
    folder, marked = marking_of(request)
    if not folder.every():
        raise InputError(Problem("there are no answers yet", remedy="type some, or bring a table or scans"))
    found = await run_in_threadpool(marked.current)
    if faults := _faults(folder, found, language_of(request)):  # the command stops at them, in English
        raise InputError(map(Problem, map(": ".join, faults.items())))
    words = words_of_command(studio_of(request), folder)
    code, _, said = await run_command(*words)
    if code:
        raise InputError(Problem(command_text(said.decode("utf-8", "replace"), language_of(request))[-600:]))
    files = [path.name for path in folder.result()]
    return JSONResponse({"files": files, "command": command_of(studio_of(request), folder)})


async def result(request: Request) -> Response:
    """One of the files that the command has written, or all of them."""
    from variantgen.studio.marking.changes import pack

    folder, _ = marking_of(request)
    files = folder.result()
    if request.path_params["number"] == "all":
        packed = studio_of(request).workspace.state("marks", f"all-{secrets.token_hex(8)}.zip")
        await run_in_threadpool(pack, folder, packed)
        return FileResponse(
            packed, filename=f"{folder.build.folder.name}-marks.zip", background=BackgroundTask(packed.unlink)
        )
    number = number_of(request.path_params["number"], "file", 0, len(files) - 1)
    return FileResponse(files[number], filename=f"{folder.build.folder.name}-{files[number].name}")


async def sheet(request: Request) -> Response:
    """The pages of the sheet of a student, or of its solution."""
    _, marked = marking_of(request)
    studio, kind = studio_of(request), request.query_params.get("kind", "sheet")
    if kind not in KINDS:
        raise InputError(Problem("unknown kind", key="kind", value=kind[:20]))
    found = await run_in_threadpool(marked.current)
    place = _place(found, request)
    name, pages = await studio.typeset(lambda: studio.previews.finished_pages(found.finished, place, kind))
    return JSONResponse({"name": name, "pages": pages})


async def scan(request: Request) -> Response:
    """The pages of the scan of a student, with the boxes that were read; pictures come one by one."""
    from variantgen.studio.marking.doubts import scan_pages
    from variantgen.studio.marking.views import MarkWords

    folder, marked = marking_of(request)
    found, language = await run_in_threadpool(marked.current), language_of(request)
    place, words, names = _place(found, request), MarkWords(found, language), folder.names()
    pages = scan_pages(found, place)
    for page in pages:
        page |= {key: words.explained(page[key], names) for key in ("where", "why")}
    code = found.marked.totals[place].code
    context = {"pages": pages, "code": code, "build": folder.build.key, "exam": request.path_params["exam"]}
    return HTMLResponse(part(request, "mark_scan", "mark", **context))


async def scanned(request: Request) -> Response:
    """The picture of a page of the scan of a student, taken out of its file for this request."""
    from variantgen.studio.marking.doubts import version_of

    _, marked = marking_of(request)
    found = await run_in_threadpool(marked.current)
    pages = found.pages.get(_place(found, request), [])
    number = number_of(request.path_params["number"], "page", 0, 100_000)
    if number >= len(pages):
        raise UnknownKeyError("page")
    lasts = version_of(pages[number]) == request.query_params.get("v")
    headers = {"cache-control": "private, max-age=31536000, immutable"} if lasts else {}
    content = await run_in_threadpool(marked.picture, pages[number])
    return Response(content, media_type="image/png", headers=headers)


async def lost(request: Request) -> Response:
    """The picture of a page that could not be read."""
    _, marked = marking_of(request)
    found = await run_in_threadpool(marked.current)
    number = number_of(request.path_params["number"], "page", 0, 100_000)
    if number >= len(found.lost) or not found.lost[number].picture:
        raise UnknownKeyError("page")
    return Response(found.lost[number].picture, media_type="image/png")


async def picture(request: Request) -> Response:
    """The picture of an answer on a scan."""
    _, marked = marking_of(request)
    found = await run_in_threadpool(marked.current)
    number = number_of(request.query_params.get("problem"), "problem", 1, 999)
    scan = found.scanned.get((_place(found, request), number, request.query_params.get("quantity", "")))
    if scan is None or not scan.picture:
        raise UnknownKeyError("picture")
    return Response(scan.picture, media_type="image/png")


def _place(found: MarkedClass, request: Request) -> int:
    """The place of the student whom an address names. Raises UnknownKeyError."""
    code = request.query_params.get("code", "")
    try:
        return found.place(code)
    except KeyError:
        raise UnknownKeyError(code[:40]) from None


def _listing(request: Request, folder: MarkingFolder, found: MarkedClass, language: str) -> str:
    from variantgen.studio.marking.views import MarkWords, questions, queue

    words = MarkWords(found, language)
    students = queue(found, words)
    names = folder.names()
    faults = _faults(folder, found, language)
    files = [
        {"file": path.name, "name": names.get(path.name, path.name), "fault": faults.pop(path.name, "")}
        for path in folder.brought()
    ]
    handed_in = sum(bool(one["handed_in"]) for one in students)
    _note(request, folder, {"handed_in": handed_in, "students": len(students)})
    context = {
        "students": students,
        "questions": questions(found, words),
        "files": files,
        "faults": faults,
        "lost": [
            {
                "where": words.explained(page.where, names),
                "why": words.explained(page.why, names),
                "picture": bool(page.picture),
            }
            for page in found.lost
        ],
        "binned": [{"kept": kept, "name": name} for kept, name in folder.binned()],
        "left": len(found.marked.not_matched),
        "doubts": len(found.doubtful),
        "handed_in": handed_in,
        "written": [path.name for path in folder.result()],
        "build": folder.build.key,
        "exam": request.path_params["exam"],
    }
    return part(request, "mark_list", "mark", **context)


def _faults(folder: MarkingFolder, found: MarkedClass, language: str) -> dict[str, str]:
    """Why files cannot be read, by their names in the folder of the marking."""
    return {
        name: error_text(error, language).replace(f"{folder.path / name}: ", "").replace(f"{folder.path}{os.sep}", "")
        for name, error in found.faults.items()
    }


def _note(request: Request, folder: MarkingFolder, state: dict[str, int]) -> None:
    """Note how far the marking is, for the head of all pages."""
    place = studio_of(request).workspace.state("marks", f"{folder.build.key}-state.json")
    place.write_text(json.dumps(state), "utf-8")


def _shown(request: Request, folder: MarkingFolder, found: MarkedClass, language: str) -> str:
    from variantgen.studio.marking import views

    words, query = views.MarkWords(found, language), request.query_params
    common = {
        "build": folder.build.key,
        "exam": request.path_params["exam"],
        "marking": words.marking,
        "review": words.language.words("review"),
    }
    view = query.get("view", "")
    if view == "class":
        return part(request, "mark_class", "mark", **common, **views.class_view(found, words, folder.names()))
    if view == "questions":
        number, name = number_of(query.get("problem"), "problem", 1, 999), query.get("quantity", "")[:80]
        rows = views.question(found, number, name, words)
        if not rows:
            raise UnknownKeyError(f"{number}.{name}")
        return part(request, "mark_question", "mark", **common, rows=rows, problem=views.class_in(found, number, words))
    place = _place(found, request)
    one = views.student(found, found.marked.totals[place].code, words)
    problems = {own["number"]: views.class_in(found, own["number"], words) for own in one["problems"]}
    return part(request, "mark_student", "mark", **common, student=one, problems=problems)


ROUTES = [
    Route("/{exam}/mark", mark),
    Route("/{exam}/mark/list", listing),
    Route("/{exam}/mark/shown", shown),
    Route("/{exam}/mark/find", find),
    Route("/{exam}/mark/write", write, methods=["POST"]),
    Route("/{exam}/mark/result/{number}", result),
    Route("/{exam}/mark/sheet", sheet),
    Route("/{exam}/mark/picture", picture),
    Route("/{exam}/mark/scan", scan),
    Route("/{exam}/mark/scan/{number}", scanned),
    Route("/{exam}/mark/lost/{number}", lost),
]
