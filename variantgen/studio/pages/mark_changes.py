"""What the page Mark changes: files brought and removed, answers said, rules; each is a step of the exam's undo."""

from __future__ import annotations

import secrets
from functools import partial
from typing import TYPE_CHECKING, Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from variantgen.studio.building.builds import FinishedBuild
from variantgen.studio.deeds import of_file
from variantgen.studio.frame import language_of
from variantgen.studio.requests import WINDOW, document_of, read_json, save_upload, studio_of, text_of
from variantgen.studio.security import SCANS_BYTES
from variantgen.studio.studio import UnknownKeyError

if TYPE_CHECKING:
    from variantgen.studio.marking.folder import MarkingFolder
    from variantgen.studio.marking.marked import MarkedBuild


async def bring(request: Request) -> Response:
    """A table or a scan; its name is shown and names nothing on disk."""
    from variantgen.studio.marking.changes import command_of, take

    folder, marked = marking_of(request)
    name = request.query_params.get("name", "")[:200]
    incoming = studio_of(request).workspace.state("marks", f"incoming-{secrets.token_hex(8)}")
    await save_upload(request, incoming, SCANS_BYTES)
    done = partial(_noted, request, folder, "file_brought", kept="")
    await run_in_threadpool(take, folder, marked, incoming, name, done)
    return JSONResponse({"command": command_of(studio_of(request), folder)})


async def drop(request: Request) -> Response:
    """Put a file into the bin."""
    from variantgen.studio.marking.changes import command_of

    data, (folder, _) = await read_json(request), marking_of(request)
    kept = await run_in_threadpool(_removed, request, folder, text_of(data, "file"))
    return JSONResponse({"kept": kept, "command": command_of(studio_of(request), folder)})


def _removed(request: Request, folder: MarkingFolder, file: str) -> str:
    with folder.lock:
        kept = folder.remove(file)
        _noted(request, folder, "file_removed", file, kept)
    return kept


async def stop(request: Request) -> Response:
    """Stop reading scans; those that were not read to the end go into the bin."""
    from variantgen.studio.marking.changes import command_of

    await read_json(request)
    folder, marked = marking_of(request)
    files = await run_in_threadpool(marked.stop, partial(_noted, request, folder, "file_removed"))
    return JSONResponse({"files": files, "command": command_of(studio_of(request), folder)})


async def restore(request: Request) -> Response:
    """Take a file out of the bin."""
    from variantgen.studio.marking.changes import command_of

    data, (folder, _) = await read_json(request), marking_of(request)
    await run_in_threadpool(_restored, request, folder, text_of(data, "kept"))
    return JSONResponse({"command": command_of(studio_of(request), folder)})


def _restored(request: Request, folder: MarkingFolder, kept: str) -> None:
    with folder.lock:
        other = folder.restore(kept)
        _noted(request, folder, "file_restored", kept.partition("-")[2], other)


async def say(request: Request) -> Response:
    """An answer that was typed, or the decision on a doubtful reading; its verdict comes back at once."""
    from variantgen.studio.marking.changes import command_of, said

    data, (folder, marked) = await read_json(request), marking_of(request)
    found = await run_in_threadpool(said, folder, marked, data, partial(_answered, request, folder, data))
    return JSONResponse({**found, "command": command_of(studio_of(request), folder)})


def _answered(request: Request, folder: MarkingFolder, data: dict[str, Any], before: str, text: str) -> None:
    if before == text:
        return
    deed = {"kind": "answer", "build": folder.build.key, "before": before, "after": text}
    deed |= {name: str(data[name]) for name in ("code", "problem", "quantity")}
    about = {"code": deed["code"], "what": f"{deed['problem']}.{deed['quantity']}"}
    _note(request, "answer_said", about, deed)


async def policy(request: Request) -> Response:
    """What other rules would change; they are written if it is wished."""
    from variantgen.studio.marking.changes import command_of, with_policy
    from variantgen.studio.marking.folder import POLICY

    data, (folder, marked) = await read_json(request), marking_of(request)
    language = language_of(request)
    done = partial(_noted, request, folder, "rules_used", POLICY)
    found = await run_in_threadpool(with_policy, folder, marked, data, language, done)
    return JSONResponse({**found, "command": command_of(studio_of(request), folder)})


def _build(request: Request) -> FinishedBuild:
    """The build that an address names. Raises UnknownKeyError."""
    document = document_of(request)
    key = request.query_params.get("build", "")
    found = studio_of(request).builds.finished(document.key).get(key)
    if found is None:
        raise UnknownKeyError(key[:80])
    return found


def marking_of(request: Request) -> tuple[MarkingFolder, MarkedBuild]:
    """The marking that an address names. Raises UnknownKeyError."""
    return studio_of(request).marking(_build(request))


def _noted(request: Request, folder: MarkingFolder, words: str, file: str, kept: str) -> None:
    """Note that a file of a marking has come, gone or been replaced; ``kept`` is what is in the bin instead."""
    _note(request, words, {"file": folder.names().get(file, file)}, of_file(folder, file, kept))


def _note(request: Request, words: str, about: dict[str, str], deed: dict[str, str]) -> None:
    window = request.query_params.get("window", "")[:WINDOW]
    studio_of(request).note(document_of(request), words, about, deed, window)


ROUTES = [
    Route("/{exam}/mark/answers", bring, methods=["PUT"]),
    Route("/{exam}/mark/drop", drop, methods=["POST"]),
    Route("/{exam}/mark/stop", stop, methods=["POST"]),
    Route("/{exam}/mark/restore", restore, methods=["POST"]),
    Route("/{exam}/mark/say", say, methods=["POST"]),
    Route("/{exam}/mark/policy", policy, methods=["POST"]),
]
