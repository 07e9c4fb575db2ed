"""The server: a port of this machine for one browser, and its lock, so that a folder has one studio at a time."""

from __future__ import annotations

import asyncio
import html
import json
import os
import re
import secrets
import socket
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h11
import uvicorn
from uvicorn.protocols.http.h11_impl import H11Protocol

from variantgen.errors import InputError, Problem
from variantgen.studio.app import make_app
from variantgen.studio.studio import Studio
from variantgen.studio.workspace import Workspace

ADDRESS = "127.0.0.1"
PORT = 8765
_TRIED = 20  # ports, where none is asked for
_LOCK = "running.json"
_DOOR = "open.html"
_LEADS = (
    '<!doctype html><meta charset="utf-8"><meta http-equiv="refresh" content="0; url={address}">'
    "<title>variantgen</title>"
)
HEADER_SECONDS = 20.0  # in which the headers of a request must have come
_OWN_ADDRESS = re.compile(rf"http://{re.escape(ADDRESS)}:([0-9]{{1,5}})/\?t=[A-Za-z0-9_-]+")
_LAST_PORT = 65_535


def serve(folder: Path, port: int | None, browser: bool, say: Callable[[str], None]) -> None:
    """Serve a folder until it is interrupted; ``say`` is told the address. Raises InputError."""
    workspace = Workspace(folder)
    running = _running(workspace)
    if running:
        _open(workspace, running, browser, say)
        return
    with listening(port) as listener:
        own_port, token = listener.getsockname()[1], secrets.token_urlsafe(24)
        address = f"http://{ADDRESS}:{own_port}/?t={token}"
        lock = workspace.state(_LOCK)
        _write_lock(lock, address)
        try:
            _run(
                make_app(Studio(workspace), token, own_port), listener, lambda: _open(workspace, address, browser, say)
            )
        finally:
            lock.unlink(missing_ok=True)
            workspace.state(_DOOR).unlink(missing_ok=True)


def _run(app: Any, listener: socket.socket, started: Callable[[], None]) -> None:
    """Answer requests until a signal comes."""
    config = uvicorn.Config(
        app,
        log_level="error",
        access_log=False,
        server_header=False,
        ws="none",
        http=PatientProtocol,
        timeout_keep_alive=30,
        timeout_graceful_shutdown=1,
        h11_max_incomplete_event_size=32_000,
        limit_concurrency=200,
    )
    server = uvicorn.Server(config)

    async def running() -> None:
        asyncio.get_running_loop().call_soon(started)
        await server.serve(sockets=[listener])

    asyncio.run(running())


class PatientProtocol(H11Protocol):
    """HTTP whose headers must have come in time, from the first byte of a connection on; slow bodies are the app's."""

    _waiting: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]  # as in its base
        """A connection has been opened."""
        super().connection_made(transport)
        self._wait()

    def data_received(self, data: bytes) -> None:
        """A piece of a request has come."""
        begins = self._waiting is None and self.conn.their_state is h11.IDLE
        if begins:  # the next request of a connection that was idle
            self._wait()
        super().data_received(data)
        if self._waiting is not None and self.conn.their_state is not h11.IDLE:
            self._waiting.cancel()
            self._waiting = None

    def connection_lost(self, exc: Exception | None) -> None:
        """The connection has ended."""
        if self._waiting is not None:
            self._waiting.cancel()
            self._waiting = None
        super().connection_lost(exc)

    def _wait(self) -> None:
        self._waiting = self.loop.call_later(HEADER_SECONDS, self.transport.close)


def _open(workspace: Workspace, address: str, browser: bool, say: Callable[[str], None]) -> None:
    """Tell the address, and open it in a browser by a file that only its owner can read.

    A program that is started with the address as argument would show the token in the list of processes.
    """
    say(address)
    if not browser:
        return
    import webbrowser

    path = workspace.state(_DOOR)
    path.unlink(missing_ok=True)
    handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    with os.fdopen(handle, "w", encoding="utf-8") as file:
        file.write(_LEADS.format(address=html.escape(address)))
    webbrowser.open(path.resolve().as_uri())


def listening(port: int | None) -> socket.socket:
    """A socket of this machine alone: at the port, or at the first that is free.

    Raises InputError where the port is taken.
    """
    for number in [port] if port is not None else [*range(PORT, PORT + _TRIED), 0]:
        # With the protocol asyncio sends at once; without it a body waits some 40 ms for the head to be acknowledged.
        listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
        if sys.platform != "win32":  # there it would let two programs have one port
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            listener.bind((ADDRESS, number))
            listener.listen(128)
        except OSError as error:
            listener.close()
            if port is not None:
                text = f"cannot be used: {error.strerror}"
                raise InputError(Problem(text, key="--port", value=str(port), remedy="choose another one")) from None
        else:
            return listener
    raise InputError(Problem("no port is free", key="--port"))


def _write_lock(path: Path, address: str) -> None:
    """Note who serves the folder; only its owner may read it, because the address lets in."""
    path.unlink(missing_ok=True)
    handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    with os.fdopen(handle, "w", encoding="utf-8") as file:
        json.dump({"process": os.getpid(), "address": address}, file)


def _running(workspace: Workspace) -> str:
    """The address of the studio that serves the folder already; '' if there is none."""
    try:
        path = workspace.state(_LOCK)
        if hasattr(os, "getuid") and path.stat().st_uid != os.getuid():
            return ""
        found = json.loads(path.read_text("utf-8"))
        address, process = found["address"], found["process"]
        match = _OWN_ADDRESS.fullmatch(address)
        if match is None or not isinstance(process, int) or process < 1 or int(match[1]) > _LAST_PORT:
            return ""
        if os.name == "posix":
            os.kill(process, 0)  # raises where there is no such process of this user
    except (OSError, ValueError, KeyError, TypeError, OverflowError, RecursionError):
        return ""
    return address if _answers(int(match[1]), address) else ""


def _answers(port: int, address: str) -> bool:
    """Whether a studio lets in at its first address."""
    import http.client

    connection = http.client.HTTPConnection(ADDRESS, port, timeout=2)
    try:
        connection.request("GET", address.partition(f":{port}")[2])
        return connection.getresponse().status == 303
    except (OSError, http.client.HTTPException):
        return False
    finally:
        connection.close()
