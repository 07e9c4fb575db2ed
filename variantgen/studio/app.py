"""The application: the pages, what they share, and the checks around all of it."""

from __future__ import annotations

import asyncio
import contextlib
import importlib
from collections.abc import AsyncIterator

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import JSONResponse, Response, StreamingResponse
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp

from variantgen.errors import InputError, VariantgenError
from variantgen.studio.documents.document import ConflictError, RefusedError
from variantgen.studio.documents.edits import plain
from variantgen.studio.frame import error_page, language_of, wants_page
from variantgen.studio.messages import error_text, explained, in_language
from variantgen.studio.pages import PAGES
from variantgen.studio.requests import studio_of
from variantgen.studio.security import BodyError, Guard
from variantgen.studio.studio import Studio, UnknownKeyError
from variantgen.studio.words import ASSETS

_FIRST_PAGE = 1.0  # seconds in which the first page has come


def make_app(studio: Studio, token: str, port: int) -> ASGIApp:
    """The application of a studio for a server on a port; the token opens it."""

    @contextlib.asynccontextmanager
    async def life(_: Starlette) -> AsyncIterator[None]:
        studio.events.start()
        tasks = [asyncio.create_task(studio.watch()), asyncio.create_task(_warm(studio))]
        try:
            yield
        finally:
            for task in tasks:
                task.cancel()
            studio.close()

    handlers = {VariantgenError: _refusal, BodyError: _given_up, 404: _not_found, Exception: _failed}
    app = Starlette(
        routes=[
            Mount("/static", StaticFiles(directory=ASSETS / "static")),
            Route("/events", _events),
            *(route for page in PAGES for route in page.ROUTES),
        ],
        exception_handlers=handlers,  # type: ignore[arg-type]  # handlers are more special than their type says
        lifespan=life,
    )
    app.state.studio = studio
    return Guard(app, token, port)


async def _warm(studio: Studio) -> None:
    """Load what figures need, a second of work, while the first page is looked at."""
    await asyncio.sleep(_FIRST_PAGE)
    await studio.draw(lambda: importlib.import_module("variantgen.studio.composition"))
    await studio.draw(lambda: importlib.import_module("variantgen.figure.build"))


async def _events(request: Request) -> Response:
    """What happens from now on; for a window that returns, what happened since."""
    last = request.headers.get("last-event-id", "")
    number = int(last) if last.isascii() and last.isdigit() and len(last) < 12 else None
    return StreamingResponse(studio_of(request).events.listen(number), media_type="text/event-stream")


async def _refusal(request: Request, error: VariantgenError) -> Response:
    """What a mistake is answered: a page for who looks at one, else its problems."""
    if isinstance(error, ConflictError):
        values = {"mine": plain(error.mine), "theirs": plain(error.theirs)}
        return JSONResponse({"conflict": error.path, **values, "moved": error.moved}, 409)
    language = language_of(request)
    if isinstance(error, RefusedError):
        return JSONResponse({"problems": [explained(problem, language) for problem in error.problems]}, 422)
    status = 404 if isinstance(error, UnknownKeyError) else 400
    if wants_page(request):
        return error_page(request, status, error_text(error, language))
    problems = error.problems if isinstance(error, InputError) else ()
    found = [explained(problem, language) for problem in problems]
    text = error_text(error, language)
    return JSONResponse({"problems": found or [{"key": "", "message": text, "remedy": "", "line": 0}]}, status)


async def _given_up(_: Request, __: BodyError) -> Response:
    return JSONResponse({"problems": [{"key": "", "message": "the request is too large or too slow"}]}, 413)


async def _failed(request: Request, error: Exception) -> Response:
    """What a fault of the program is answered; its name helps who is told of it."""
    message = in_language(f"the program has a fault here: {type(error).__name__}", language_of(request))
    if wants_page(request):
        return error_page(request, 500, message)
    return JSONResponse({"problems": [{"key": "", "message": message, "remedy": "", "line": 0}]}, 500)


async def _not_found(request: Request, _: Exception) -> Response:
    if wants_page(request):
        return error_page(request, 404, "")
    return JSONResponse({"problems": [{"key": "", "message": "there is nothing at this address"}]}, 404)
