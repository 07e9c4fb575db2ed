"""Text from outside as the formats of learning platforms can hold it."""

from __future__ import annotations

import re

# What XML 1.0 cannot hold, not even escaped.
_IMPOSSIBLE = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def storable(text: str) -> str:
    """The text with the replacement character for what no XML file can hold."""
    return _IMPOSSIBLE.sub("\N{REPLACEMENT CHARACTER}", text)


def one_line(text: str, most: int | None = None) -> str:
    """The text in one line, of at most ``most`` characters."""
    line = " ".join(storable(text).split())
    return line if most is None or len(line) <= most else line[: most - 1] + "…"
