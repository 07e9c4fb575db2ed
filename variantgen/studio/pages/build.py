"""Build: formats, progress, stop; next year's exam."""

from __future__ import annotations

from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError, Problem
from variantgen.studio.documents.document import Document
from variantgen.studio.documents.edits import apply, read_operations
from variantgen.studio.frame import build_command, render
from variantgen.studio.requests import number_of, read_json, text_of
from variantgen.studio.studio import Studio
from variantgen.studio.summary import USUAL_CLASS, problems_of, students
from variantgen.studio.workspace import write_whole

FORMATS = ("pdf", "xlsx", "html", "moodle", "canvas", "qti21", "qti30", "latex", "prairielearn")
_MOST = 1_000_000


def routes(studio: Studio) -> list[Route]:
    """The addresses of this page; they raise InputError for requests that do not fit."""
    builds = studio.builds

    def opened(request: Request) -> Document:
        return studio.document(request.path_params["exam"])

    async def build(request: Request) -> Response:
        document = opened(request)
        try:
            known, fault = students(studio), ""
        except InputError as error:
            known, fault = 0, str(error)
        formats = document.state().data.get("formats", ["pdf"])
        context: dict[str, Any] = {
            "formats": FORMATS,
            "chosen": formats if isinstance(formats, list) else [],
            "roster": known,
            "usual": USUAL_CLASS,
            "running": builds.state(document.key),
            "ready": bool(problems_of(document)),
            "fault": fault,
        }
        return render(request, "build", studio, document, build_command(studio, document), **context)

    async def start(request: Request) -> Response:
        data, document = await read_json(request), opened(request)
        known = students(studio)
        variants = None if known is not None else number_of(data.get("variants"), "variants", 1, _MOST)
        await run_in_threadpool(document.exam)  # its mistakes are told before anything is begun
        await builds.start(document.key, document.path, variants)
        return JSONResponse(builds.state(document.key))

    async def stop(request: Request) -> Response:
        builds.stop(opened(request).key)
        return JSONResponse({})

    async def progress(request: Request) -> Response:
        document = opened(request)
        found = len(await run_in_threadpool(document.mistakes)) if problems_of(document) else 0
        return JSONResponse({"state": builds.state(document.key), "mistakes": found})

    async def next_year(request: Request) -> Response:
        data, document = await read_json(request), opened(request)
        seed = text_of(data, "seed", 40).strip()
        if not seed:
            raise InputError(Problem("missing, expected another series", key="seed"))
        value = int(seed) if seed.isascii() and seed.isdigit() and len(seed) < 16 else seed
        text = apply(document.state().text, read_operations([{"op": "set", "path": "seed", "value": value}]))
        path = studio.workspace.new_exam_path(f"{document.path.stem}-{seed}")
        write_whole(path, text)
        key = next(key for key, known in studio.workspace.exams().items() if known == path)
        return JSONResponse({"address": f"/{key}/compose", "file": path.name})

    return [
        Route("/{exam}/build", build),
        Route("/{exam}/progress", progress),
        Route("/{exam}/start", start, methods=["POST"]),
        Route("/{exam}/stop", stop, methods=["POST"]),
        Route("/{exam}/next", next_year, methods=["POST"]),
    ]
