"""Build: formats, progress, stop; next year's exam."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

from msgspec.structs import replace
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError, Problem
from variantgen.studio.building.preview import class_of
from variantgen.studio.documents.document import Document
from variantgen.studio.documents.edits import apply, read_operations
from variantgen.studio.frame import build_command, language_of, render
from variantgen.studio.messages import command_text, error_text
from variantgen.studio.requests import document_of, number_of, read_json, studio_of, text_of
from variantgen.studio.studio import Studio
from variantgen.studio.summary import groups, problems_of, students
from variantgen.studio.workspace import USUAL_CLASS, write_whole

GROUPED = ("pdf", "xlsx", "html", "latex")  # formats that can have a file for each group
FORMATS = ("pdf", "xlsx", "html", "moodle", "canvas", "qti21", "qti30", "latex", "prairielearn")
_MOST = 1_000_000
_NEEDED = {"xlsx": ("xlsxwriter", "xlsx"), "latex": ("pylatex", "latex")}  # the packages of formats, and their extras


def _install(extra: str) -> str:
    """The command that installs what a format needs."""
    return f'pip install ".[{extra}]"'


async def build(request: Request) -> Response:
    """The page."""
    studio, document = studio_of(request), document_of(request)
    try:
        known, fault = students(studio), ""
    except InputError as error:
        known, fault = 0, error_text(error, language_of(request))
    data = document.state().data
    formats = data.get("formats", ["pdf"])
    tables = [data[name] for name in GROUPED if isinstance(data.get(name), dict)]
    context: dict[str, Any] = {
        "formats": FORMATS,
        "chosen": formats if isinstance(formats, list) else [],
        "missing": {name: _install(extra) for name, (package, extra) in _NEEDED.items() if find_spec(package) is None},
        "grouped": GROUPED,
        "by_groups": any(table.get("files") == "groups" for table in tables),
        "groups": 0 if fault else len(groups(studio)),
        "roster": known,
        "usual": USUAL_CLASS,
        "running": _state(studio, document, language_of(request)),
        "ready": bool(problems_of(document)),
        "fault": fault,
    }
    return render(request, "build", studio, document, build_command(studio, document), **context)


async def start(request: Request) -> Response:
    """Begin a build."""
    studio, document, data = studio_of(request), document_of(request), await read_json(request)
    known = students(studio)
    variants = None if known is not None else number_of(data.get("variants"), "variants", 1, _MOST)
    await run_in_threadpool(document.exam)  # its mistakes are told before anything is begun
    await studio.builds.start(document.key, document.path, variants)
    return JSONResponse(studio.builds.state(document.key))


async def stop(request: Request) -> Response:
    """Stop a build; what is finished of it is kept."""
    await read_json(request)
    studio_of(request).builds.stop(document_of(request).key)
    return JSONResponse({})


async def progress(request: Request) -> Response:
    """How far the build is, how many mistakes the exam has, the command of the next build."""
    document = document_of(request)
    found = len(await run_in_threadpool(document.mistakes)) if problems_of(document) else 0
    studio = studio_of(request)
    line = build_command(studio, document)
    state = _state(studio, document, language_of(request))
    return JSONResponse({"state": state, "mistakes": found, "command": line})


def _state(studio: Studio, document: Document, language: str) -> dict[str, Any]:
    """How far the build is; why it has failed in the language of the page."""
    state = studio.builds.state(document.key)
    return {**state, "text": command_text(state["text"], language)} if "text" in state else state


async def next_year(request: Request) -> Response:
    """The same exam with another series, as a new file."""
    workspace, document, data = studio_of(request).workspace, document_of(request), await read_json(request)
    seed = text_of(data, "seed", 40).strip()
    if not seed:
        raise InputError(Problem("missing, expected another series", key="seed"))
    value = int(seed) if seed.isascii() and seed.isdigit() and len(seed) < 16 else seed
    text = apply(document.state().text, read_operations([{"op": "set", "path": "seed", "value": value}]))
    path = workspace.new_exam_path(f"{document.path.stem}-{seed}")
    write_whole(path, text)
    key = next(key for key, known in workspace.exams().items() if known == path)
    return JSONResponse({"address": f"/{key}/compose", "file": path.name})


async def overlap(request: Request) -> Response:
    """How many variants of another series were handed out in the builds of this exam."""
    studio, document = studio_of(request), document_of(request)
    seed = request.query_params.get("seed", "").strip()[:40]
    if not seed:
        raise InputError(Problem("missing, expected another series", key="seed"))
    return JSONResponse(await studio.typeset(lambda: _overlap(studio, document, seed)))


def _overlap(studio: Studio, document: Document, seed: str) -> dict[str, int]:
    """The variants of the class with another series, those that a build has had, and how many builds there are."""
    from variantgen.builder.preview import DrawnClass
    from variantgen.exam.manifest import read_manifest
    from variantgen.families.reading.folders import family_folders
    from variantgen.finished.overlap import overlap
    from variantgen.finished.restore import restore

    builds = studio.builds.finished(document.key).values()
    variants = DrawnClass(replace(document.exam(), seed=seed), class_of(studio.workspace)).variants()
    folders = family_folders((studio.workspace.folder,))
    same = overlap(variants, (restore(read_manifest(build.folder), folders) for build in builds))
    return {"variants": len(variants), "same": same, "builds": len(builds)}


ROUTES = [
    Route("/{exam}/overlap", overlap),
    Route("/{exam}/build", build),
    Route("/{exam}/progress", progress),
    Route("/{exam}/start", start, methods=["POST"]),
    Route("/{exam}/stop", stop, methods=["POST"]),
    Route("/{exam}/next", next_year, methods=["POST"]),
]
