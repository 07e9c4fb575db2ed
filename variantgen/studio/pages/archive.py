"""What was built: its files, a check of them, the sheet that somebody lost."""

from __future__ import annotations

import asyncio
import json
import os
import sys
import tempfile
import zipfile
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import Any

from starlette.background import BackgroundTask
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import FileResponse, HTMLResponse, JSONResponse, Response
from starlette.routing import Route

from variantgen.errors import InputError, Problem
from variantgen.studio.building.builds import FinishedBuild
from variantgen.studio.frame import command, language_of, part
from variantgen.studio.messages import command_text
from variantgen.studio.requests import document_of, number_of, read_json, studio_of, text_of
from variantgen.studio.studio import UnknownKeyError
from variantgen.studio.summary import built_words
from variantgen.studio.words import page_words

_SECONDS = 600  # that a check may take
_KINDS = ("sheets", "key", "solutions", "grading")  # of files, each of which is there for the class or for every group


_WHOLE = "\0"  # the row of the whole class, which is no group


def finished(request: Request) -> FinishedBuild:
    """The build that an address names. Raises UnknownKeyError."""
    found = studio_of(request).builds.finished().get(request.path_params["build"])
    if found is None:
        raise UnknownKeyError(request.path_params["build"])
    return found


async def archive(request: Request) -> Response:
    """The builds of an exam, as markup."""
    words = page_words(language_of(request))
    builds = await run_in_threadpool(studio_of(request).builds.finished, document_of(request).key)
    found = [_shown(build, words) for build in builds.values()]
    return HTMLResponse(part(request, "archive", "build", builds=found))


async def download(request: Request) -> Response:
    """A file of a build."""
    found = finished(request)
    number = number_of(request.path_params["number"], "file", 0, len(found.files) - 1)
    name = found.files[number][0]
    return FileResponse(found.folder / name, filename=f"{found.folder.name}-{Path(name).name}")


async def everything(request: Request) -> Response:
    """All files of a build in one."""
    found = finished(request)
    handle, name = tempfile.mkstemp(suffix=".zip")
    os.close(handle)
    await run_in_threadpool(_pack, found, Path(name))
    return FileResponse(name, filename=f"{found.folder.name}.zip", background=BackgroundTask(Path(name).unlink))


async def verify(request: Request) -> Response:
    """What the command verify finds in a build."""
    await read_json(request)
    code, said, _ = await run_command(
        "verify", str(finished(request).folder), "--json", *studio_of(request).workspace.families_option()
    )
    try:
        found = json.loads(said)
    except ValueError:
        raise InputError(Problem("the build cannot be checked", value=said[-200:].decode("utf-8", "replace"))) from None
    return JSONResponse({"right": code == 0, "faults": found["faults"][:20], "answers": found["answers"]})


async def search(request: Request) -> Response:
    """The student of a name, an id or a code of a sheet."""
    from variantgen.exam.manifest import read_manifest
    from variantgen.finished.find import find

    who, build = request.query_params.get("who", "").strip()[:200], finished(request)
    record = await run_in_threadpool(read_manifest, build.folder)
    sheet = record.sheets[find(record, who)]
    student = {"name": sheet.student.name or sheet.student.id, "group": sheet.student.group, "code": sheet.code}
    day = built_words(page_words(language_of(request)), build.day)
    return JSONResponse({**student, "title": build.title, "day": day})


async def lost(request: Request) -> Response:
    """The sheet that somebody lost, set again."""
    who = request.query_params.get("who", "")[:200]
    handle, name = tempfile.mkstemp(suffix=".pdf")
    os.close(handle)
    path = Path(name)
    own = studio_of(request).workspace.families_option()
    code, _, said = await run_command("remake", str(finished(request).folder), "--student", who, "--out", name, *own)
    if code:
        path.unlink(missing_ok=True)
        raise InputError(Problem(command_text(_text(said), language_of(request))[-600:]))
    return FileResponse(path, filename="sheet.pdf", background=BackgroundTask(path.unlink))


async def run_command(*words: str) -> tuple[int, bytes, bytes]:
    """A command of the program in a process of its own: its code, what it has said. Raises InputError if too slow."""
    process = await asyncio.create_subprocess_exec(
        sys.executable, "-m", "variantgen", *words,
        stdin=asyncio.subprocess.DEVNULL, stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.PIPE,
    )  # fmt: skip
    try:
        out, err = await asyncio.wait_for(process.communicate(), _SECONDS)
    except TimeoutError:
        process.kill()
        raise InputError(Problem("it takes too long", remedy="run the command in a terminal")) from None
    return process.returncode or 0, out, err


def _text(said: bytes) -> str:
    return said.decode("utf-8", "replace").strip()


def _pack(build: FinishedBuild, path: Path) -> None:
    """All files of a build in one."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as packed:
        for name, _ in build.files:
            packed.write(build.folder / name, f"{build.folder.name}/{name}")


def _shown(build: FinishedBuild, words: Any) -> dict[str, Any]:
    """A build in the list: a table of its files, by groups and kinds; those that are in none; how many are left."""
    rows: dict[str, dict[str, list[dict[str, Any]]]] = {}
    other, more = [], 0
    for number, (name, size) in enumerate(build.files):
        file = {"number": number, "name": name, "size": _size(size, words.language)}
        file["kind"] = Path(name).suffix[1:].upper()
        group, kind = _place(build, name)
        if kind:
            rows.setdefault(group, {}).setdefault(kind, []).append(file)
        elif "/" in name:
            more += 1
        else:
            other.append(file)
    kinds = [kind for kind in _KINDS if any(kind in row for row in rows.values())]
    order = [_WHOLE, *(group for group, _ in build.groups)]
    return {
        "kinds": kinds,
        "rows": [(None if group == _WHOLE else group, rows[group]) for group in order if group in rows],
        "key": build.key,
        "day": built_words(words, build.day),
        "name": build.folder.name,
        "title": build.title,
        "students": words.counted(build.students, "student"),
        "seed": build.seed,
        "size": _size(build.size, words.language),
        "files": other,
        "more": more,
    }


def _place(build: FinishedBuild, name: str) -> tuple[str, str]:
    """The row and the column of a file in the table of a build: the group and the kind; no kind for other files."""
    *above, last = Path(name).parts
    if above[:1] in (["html"], ["latex"]):
        del above[0]
    stem = last.partition(".")[0] if not above else Path(last).stem
    if not above and stem in _KINDS:
        return _WHOLE, stem
    if len(above) == 1 and above[0] in _KINDS:
        for group, own in build.groups:
            if own == stem:
                return group, above[0]
    return _WHOLE, ""


def _size(size: int, language: str) -> str:
    units = ("кБ", "МБ") if language == "ru" else ("kB", "MB")
    text = f"{size / 1e6:.1f} {units[1]}" if size >= 1e6 else f"{max(1, round(size / 1e3))} {units[0]}"
    return text.replace(".", ",") if language == "ru" else text


async def rekey(request: Request) -> Response:
    """Another tolerance for a build: its key is made again by the command, its sheets stay."""
    data = await read_json(request)
    build, text = finished(request), text_of(data, "tolerance", 12).replace(",", ".").replace("%", "").strip()
    try:
        share = Decimal(text) / 100
    except InvalidOperation:
        share = Decimal(0)
    if not share.is_finite() or not 0 < share < 1:
        raise InputError(Problem("expected a number of per cent above 0", key="tolerance", value=text))
    problem = number_of(data["problem"], "problem", 1, 100) if data.get("problem") else 0
    given = f"{problem}={share:f}" if problem else f"{share:f}"
    words = ("rekey", str(build.folder), "--tolerance", given, *studio_of(request).workspace.families_option())
    code, _, said = await run_command(*words)
    if code:
        raise InputError(Problem(command_text(_text(said), language_of(request))[-600:]))
    return JSONResponse({"command": command("variantgen", *words), "said": _text(said)[-400:]})


ROUTES = [
    Route("/builds/{build}/rekey", rekey, methods=["POST"]),
    Route("/{exam}/archive", archive),
    Route("/builds/{build}/file/{number}", download),
    Route("/builds/{build}/all.zip", everything),
    Route("/builds/{build}/verify", verify, methods=["POST"]),
    Route("/builds/{build}/search", search),
    Route("/builds/{build}/sheet.pdf", lost),
]
