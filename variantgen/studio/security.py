"""Who may speak to the server: a browser of this machine that was opened with the address that the command printed.

The checks, in their order, for every method:

- Host has to be this server, so that a foreign name which is made to point here (DNS rebinding) is refused;
- Sec-Fetch-Site and, for what changes anything, Origin have to be those of a page of this server, but for the first
  address with the right token, which a file of this machine may open;
- a cookie, SameSite=Strict, has the random token of the first address ``/?t=TOKEN``;
- bodies have a size, and times in which the next piece and the whole must have come.

Answers get a policy under which no page runs a script or a style that is not a file of the studio.
"""

from __future__ import annotations

import asyncio
import logging
import secrets
import time
from http.cookies import CookieError, SimpleCookie
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import HTMLResponse, JSONResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from variantgen.limits import ROSTER_BYTES

POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; form-action 'self'; "
    "base-uri 'none'; frame-ancestors 'none'"
)
# A figure is opened by itself at times; its style is inside, and it can do nothing else.
FIGURE_POLICY = "default-src 'none'; style-src 'unsafe-inline'; sandbox"
_HEADERS = {
    "content-security-policy": POLICY,
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "cache-control": "no-store",
}
EDIT_BYTES = 1_000_000  # of the body of an edit
UPLOAD_BYTES = ROSTER_BYTES  # of an upload (PUT)
SCANS_BYTES = 1_000_000_000  # of an upload of scans
BODY_SECONDS = 20.0  # in which the next piece of a body must have come
WHOLE_SECONDS = 60.0  # in which a whole body must have come, besides the time that its bytes take
_SLOWEST = 100_000  # bytes a second
_LOG = logging.getLogger("variantgen.studio")
_READING = ("GET", "HEAD")
_OWN_SITES = ("same-origin", "none")
_LED_ON = '<!doctype html><meta charset="utf-8"><meta http-equiv="refresh" content="0; url=/"><title>variantgen</title>'
_METHODS = (*_READING, "POST", "PUT")


class Guard:
    """The checks of this module around an application, for a server on a ``port`` with a ``token``."""

    def __init__(self, app: ASGIApp, token: str, port: int) -> None:
        self._app, self._token = app, token
        self.cookie = f"variantgen-{port}"
        self._hosts = frozenset(f"{name}:{port}" for name in ("127.0.0.1", "localhost", "[::1]"))

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request, or refuse it."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
        elif scope["type"] == "http":
            refused = self._refusal(scope)
            if refused is not None:
                await refused(scope, receive, _with_headers(send))
            else:
                try:
                    await self._app(scope, _bounded(scope, receive), _with_headers(send))
                except Exception as error:  # noqa: BLE001  # it has been answered; the next request is not its fault
                    _LOG.error("%s %s: %s: %s", scope["method"], scope["path"], type(error).__name__, error)
        elif scope["type"] == "websocket":
            await send({"type": "websocket.close", "code": 1008})

    def _refusal(self, scope: Scope) -> Response | None:
        """What a request is answered that goes no further."""
        headers, method = Headers(scope=scope), scope["method"]
        hosts = headers.getlist("host")
        if len(hosts) != 1 or hosts[0] not in self._hosts:
            return _refused("this server answers only to its own address", 421)
        if method not in _METHODS:
            return _refused("unknown method", 405)
        if headers.get("sec-fetch-site", "none") not in _OWN_SITES:
            return self._door(scope) or _refused("another site asks", 403)
        if method not in _READING and headers.getlist("origin") != [f"http://{hosts[0]}"]:
            return _refused("another site asks", 403)
        if not self._is_known(headers):
            return self._door(scope) or _refused("open the address that  variantgen studio  has printed", 403)
        return _size_refusal(headers, scope)

    def _is_known(self, headers: Headers) -> bool:
        """Whether the cookie has the token."""
        try:
            cookies = SimpleCookie(headers.get("cookie", ""))
        except CookieError:
            return False
        found = cookies.get(self.cookie)
        return found is not None and self._is_token(found.value)

    def _is_token(self, text: str) -> bool:
        return secrets.compare_digest(text.encode(), self._token.encode())

    def _door(self, scope: Scope) -> Response | None:
        """The first address: its token becomes a cookie, and is no longer seen."""
        if scope["path"] != "/" or scope["method"] not in _READING:
            return None
        given = parse_qs(scope["query_string"].decode("latin-1")).get("t", [])
        if len(given) != 1 or not self._is_token(given[0]):
            return None
        own = Headers(scope=scope).get("sec-fetch-site", "none") in _OWN_SITES
        # Whoever comes from a file of this machine is led on by a page: a redirection would come without the cookie.
        answer: Response = RedirectResponse("/", 303) if own else HTMLResponse(_LED_ON)
        answer.set_cookie(self.cookie, self._token, httponly=True, samesite="strict")
        return answer


def _size_refusal(headers: Headers, scope: Scope) -> Response | None:
    """What a body that is too large is answered, if it tells its size; the others are counted."""
    size = headers.get("content-length", "0")
    if not size.isascii() or not size.isdigit():
        return _refused("a size is a number", 400)
    return _refused("too large", 413) if len(size) > 12 or int(size) > _most(scope) else None


def _most(scope: Scope) -> int:
    """Bytes that a body may have."""
    if scope["method"] != "PUT":
        return EDIT_BYTES
    return SCANS_BYTES if scope["path"].endswith("/mark/answers") else UPLOAD_BYTES


def _refused(text: str, status: int) -> Response:
    return JSONResponse({"problems": [{"key": "", "message": text, "remedy": "", "line": 0}]}, status)


class BodyError(Exception):
    """A body that is too large or too slow; its connection is given up."""


def _bounded(scope: Scope, receive: Receive) -> Receive:
    """What receives a body in time and not more than is read. Raises BodyError."""
    begun = time.monotonic()
    most, got, done = _most(scope), 0, scope["method"] in _READING

    async def next_message() -> Message:
        nonlocal got, done
        rest = begun + WHOLE_SECONDS + got / _SLOWEST - time.monotonic()
        if done:  # only that the browser has gone can come
            return await receive()
        try:
            message = await asyncio.wait_for(receive(), max(0.0, min(BODY_SECONDS, rest)))
        except TimeoutError:
            raise BodyError("too slow") from None
        got += len(message.get("body", b""))
        done = not message.get("more_body", False)
        if got > most:
            raise BodyError("too large")
        return message

    return next_message


def _with_headers(send: Send) -> Send:
    """What sends answers with the headers that they do not have yet."""

    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in _HEADERS.items():
                headers.setdefault(name, value)
        await send(message)

    return sending
