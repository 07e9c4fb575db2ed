"""Requests to the studio without a server: whole, in pieces, with any headers."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

PORT = 8765
HOST = f"127.0.0.1:{PORT}"
BROKEN = b"the connection is broken"


@dataclass(frozen=True)
class Answer:
    """What came back."""

    status: int
    headers: Mapping[str, str]
    content: bytes

    @property
    def text(self) -> str:
        return self.content.decode()

    def json(self) -> Any:
        return json.loads(self.content)


class Asking:
    """A browser that was let in, unless it has no ``cookie``."""

    def __init__(self, app: Any, cookie: str = "") -> None:
        self.app, self.cookie = app, cookie

    def get(self, path: str, **headers: str | None) -> Answer:
        return self.ask("GET", path, **headers)

    def post(self, path: str, data: Any, **headers: str | None) -> Answer:
        return self.ask("POST", path, (json.dumps(data).encode(),), **{"content-type": "application/json", **headers})

    def ask(self, method: str, path: str, pieces: Sequence[bytes] = (b"",), **headers: str | None) -> Answer:
        """One request; a header that is None is left out."""
        usual: dict[str, str | None] = {"host": HOST, "cookie": self.cookie or None}
        if method != "GET":
            usual["origin"] = f"http://{HOST}"
        named = {**usual, **{name.replace("_", "-"): value for name, value in headers.items()}}
        raw = [(name.encode(), value.encode("latin-1")) for name, value in named.items() if value is not None]
        return self.raw(method, path, raw, pieces)

    def raw(
        self, method: str, path: str, headers: list[tuple[bytes, bytes]], pieces: Sequence[bytes | None] = (b"",)
    ) -> Answer:
        """One request with these headers and no others; a piece that is None never comes, at BROKEN the line breaks."""
        bare, _, query = path.partition("?")
        scope = {
            "type": "http", "asgi": {"version": "3.0"}, "http_version": "1.1", "method": method, "scheme": "http",
            "path": bare, "raw_path": bare.encode(), "query_string": query.encode(), "headers": headers,
            "client": ("127.0.0.1", 50000), "server": ("127.0.0.1", PORT), "root_path": "",
        }  # fmt: skip
        started: dict[str, Any] = {}
        content = bytearray()
        left = list(pieces)

        async def receive() -> dict[str, Any]:
            if not left:
                await asyncio.sleep(3600)
            piece = left.pop(0)
            if piece is BROKEN:
                left.append(BROKEN)
                return {"type": "http.disconnect"}
            if piece is None:
                await asyncio.sleep(3600)
            return {"type": "http.request", "body": piece, "more_body": bool(left)}

        async def send(message: dict[str, Any]) -> None:
            if message["type"] == "http.response.start":
                started.update(message)
            else:
                content.extend(message.get("body", b""))

        # In a thread of its own: a browser that is open keeps the loop of this one.
        with ThreadPoolExecutor(1) as pool:
            pool.submit(lambda: asyncio.run(self.app(scope, receive, send))).result()
        found = {name.decode().lower(): value.decode("latin-1") for name, value in started["headers"]}
        return Answer(started["status"], found, bytes(content))
