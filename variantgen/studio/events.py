"""Events for the open windows of browsers (server-sent events): numbered, the last of them kept for who returns."""

from __future__ import annotations

import asyncio
import contextlib
import json
from collections import deque
from collections.abc import AsyncIterator
from typing import Any

_KEPT = 500
_BEAT_SECONDS = 15.0
_WAITING = 1000  # events that a window may be behind


class Events:
    """The events of a server; may be told from any thread."""

    def __init__(self) -> None:
        self._sent: deque[tuple[int, str]] = deque(maxlen=_KEPT)
        self._number = 0
        self._queues: set[asyncio.Queue[str | None]] = set()
        self._loop: asyncio.AbstractEventLoop | None = None

    @property
    def listening(self) -> int:
        """How many windows listen."""
        return len(self._queues)

    def start(self) -> None:
        """Begin, on the loop of the server."""
        self._loop = asyncio.get_running_loop()

    def tell(self, event: str, **data: Any) -> None:
        """Tell all windows."""
        if self._loop is not None and not self._loop.is_closed():
            with contextlib.suppress(RuntimeError):  # the server ends just now
                self._loop.call_soon_threadsafe(self._tell, event, data)

    def _tell(self, event: str, data: dict[str, Any]) -> None:
        self._number += 1
        text = f"id: {self._number}\nevent: {event}\ndata: {json.dumps(data, ensure_ascii=False)}\n\n"
        self._sent.append((self._number, text))
        for queue in self._queues:
            with contextlib.suppress(asyncio.QueueFull):
                queue.put_nowait(text)

    def end(self) -> None:
        """Let all windows go."""
        for queue in self._queues:
            with contextlib.suppress(asyncio.QueueFull):
                queue.put_nowait(None)

    async def listen(self, last: int | None) -> AsyncIterator[str]:
        """What a window is sent that has got events up to ``last`` (None: it is new)."""
        queue: asyncio.Queue[str | None] = asyncio.Queue(_WAITING)
        self._queues.add(queue)
        try:
            yield f"retry: 1000\nid: {self._number}\nevent: hello\ndata: {{}}\n\n"
            if last is not None and last != self._number:
                first = self._sent[0][0] if self._sent else self._number + 1
                if last > self._number or last + 1 < first:
                    yield "event: reload\ndata: {}\n\n"
                else:
                    for text in [text for number, text in self._sent if number > last]:
                        yield text
            while True:
                try:
                    text_or_end = await asyncio.wait_for(queue.get(), _BEAT_SECONDS)
                except TimeoutError:
                    yield ": beat\n\n"
                    continue
                if text_or_end is None:
                    return
                yield text_or_end
        finally:
            self._queues.discard(queue)
