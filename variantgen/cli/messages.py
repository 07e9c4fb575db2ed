r"""The only place that writes to the terminal: results to stdout, messages to stderr.

What they say may come from exam files, manifests, rosters and names of files of other people. Control characters and
others that cannot be seen are spelled out (``\u001b``): no such text clears the screen, hides a line or types a
command.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TextIO

from variantgen.letters import spelled_out

_NAMED = 12  # students that a message names


def say(text: object = "") -> None:
    """A result, on stdout."""
    _write(sys.stdout, text)


def tell(text: object) -> None:
    """A message, on stderr."""
    _write(sys.stderr, text)


def counted(number: int, one: str, many: str = "") -> str:
    """``1 sheet``, ``2 sheets``; ``many`` is the plural where it is not made with an s."""
    return f"{number} {one if number == 1 else many or one + 's'}"


def some_of(ids: Sequence[str], mark: str = ", ", listed: str = "") -> str:
    """Some students; of many the count, some of them and where all are ``listed``."""
    if len(ids) <= _NAMED:
        return mark.join(ids)
    return f"{len(ids)} students ({mark.join(ids[:3])}{mark}...)" + (f", {listed}" if listed else "")


def _write(stream: TextIO, text: object) -> None:
    """A text as lines; letters that the stream does not have are spelled out too."""
    shown, encoding = spelled_out(str(text)), stream.encoding or "utf-8"
    stream.write(shown.encode(encoding, "backslashreplace").decode(encoding) + "\n")
    stream.flush()
