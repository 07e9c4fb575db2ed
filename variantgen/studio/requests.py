"""What requests hold, read with messages."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request

from variantgen.errors import InputError, Problem
from variantgen.studio.documents.document import Document
from variantgen.studio.studio import Studio

WINDOW = 40  # letters of the name of a window


def studio_of(request: Request) -> Studio:
    """The studio that a request is to."""
    found: Studio = request.app.state.studio
    return found


def document_of(request: Request) -> Document:
    """The exam that an address names. Raises UnknownKeyError."""
    return studio_of(request).document(request.path_params["exam"])


async def read_json(request: Request) -> dict[str, Any]:
    """The table that a script sends. Raises InputError for something else."""
    if request.headers.get("content-type", "").partition(";")[0].strip() != "application/json":
        raise InputError(Problem("expected JSON"))
    try:
        found = json.loads(await request.body(), parse_constant=_no_number)
        json.dumps(found, ensure_ascii=False).encode()  # letters that no file can hold
    except (ValueError, RecursionError):
        raise InputError(Problem("expected JSON")) from None
    if not isinstance(found, dict):
        raise InputError(Problem("expected a table"))
    return found


async def read_upload(request: Request, most: int) -> bytes:
    """A file that is sent as the whole body. Raises InputError for an empty or too large one."""
    content = bytearray()
    async for piece in request.stream():
        content += piece
        if len(content) > most:
            raise InputError(Problem(f"is larger than {most // 1_000_000} MB", remedy="bring a smaller file"))
    if not content:
        raise InputError(Problem("the file is empty"))
    return bytes(content)


async def save_upload(request: Request, path: Path, most: int) -> None:
    """Write a file that is sent as the whole body. Raises InputError for an empty or too large one."""
    size = 0
    try:
        with path.open("wb") as file:
            async for piece in request.stream():
                size += len(piece)
                if size > most:
                    raise InputError(Problem(f"is larger than {most // 1_000_000} MB", remedy="bring a smaller file"))
                await run_in_threadpool(file.write, piece)
        if not size:
            raise InputError(Problem("the file is empty"))
    except BaseException:
        path.unlink(missing_ok=True)
        raise


def _no_number(name: str) -> None:
    """NaN and infinities, which Python reads as numbers of JSON."""
    raise ValueError(name)


def text_of(data: dict[str, Any], name: str, most: int = 200) -> str:
    """A text of a table; '' if there is none. Raises InputError for something else."""
    found = data.get(name, "")
    if not isinstance(found, str):
        raise InputError(Problem("expected a text", key=name))
    if len(found) > most:
        raise InputError(Problem("is too long", key=name))
    return found


def number_of(text: object, key: str, low: int, high: int) -> int:
    """A whole number between two others. Raises InputError."""
    try:
        found = int(text) if isinstance(text, int | str) and len(str(text)) < 12 else None
    except ValueError:
        found = None
    if found is None or not low <= found <= high:
        raise InputError(Problem(f"expected a whole number, {low} to {high}", key=key, value=str(text)[:40]))
    return found
