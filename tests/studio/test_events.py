"""Windows that come back are sent what they have missed, or are told to load again."""

from __future__ import annotations

import asyncio
import re
from concurrent.futures import ThreadPoolExecutor

import pytest

from variantgen.studio.events import Events


async def _sent(told: int, last: int | None, count: int) -> list[str]:
    """What a window is sent at first that has got events up to ``last``, after so many were told."""
    events = Events()
    events.start()
    for number in range(1, told + 1):
        events.tell("doc", number=number)
    await asyncio.sleep(0)
    window = events.listen(last)
    found = [await anext(window)]  # the greeting, with the number of the last event
    assert f"id: {told}\n" in found[0] and "event: hello" in found[0]
    if count:
        found += [await anext(window) for _ in range(count)]
    events.tell("doc", number=told + 1)
    found.append(await anext(window))
    await window.aclose()
    assert events.listening == 0
    return [re.sub(r"\s+", " ", text).strip() for text in found[1:]]


@pytest.mark.parametrize(
    ("told", "last", "missed"),
    [
        (3, None, []),  # a new window: nothing of what was before it
        (3, 3, []),
        (3, 1, [2, 3]),
        (3, 0, [1, 2, 3]),
        (600, 100, list(range(101, 601))),  # the last 500 are kept
        (600, 99, None),
        (3, 7, None),  # the numbers of another server
    ],
)
def test_events_that_were_missed(told: int, last: int | None, missed: list[int] | None) -> None:
    count = 1 if missed is None else len(missed)
    with ThreadPoolExecutor(1) as pool:  # a browser that is open keeps the loop of this thread
        found = pool.submit(lambda: asyncio.run(_sent(told, last, count))).result()
    wanted = ["event: reload data: {}"] if missed is None else [_text(number) for number in missed]
    assert found == [*wanted, _text(told + 1)]


def _text(number: int) -> str:
    return f'id: {number} event: doc data: {{"number": {number}}}'
