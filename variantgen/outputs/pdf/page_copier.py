"""A part of a PDF, whose objects are copied with new numbers."""

from __future__ import annotations

import re
from collections import deque
from typing import Any

import pikepdf

from variantgen.outputs.pdf.writer import ObjectWriter

# Strings are matched to be left alone; then references, and keys of the number tree of the structure.
_TOKEN = re.compile(rb"\((?:[^()\\]|\\.)*\)|<[0-9A-Fa-f]+>|(\d+) 0 R|(/StructParents? )(\d+)", re.DOTALL)


class PageCopier:
    """Copies what is reachable from what is asked for.

    ``new`` are the numbers in the whole by those in the part; what is in it beforehand is not copied. ``first_key`` is
    added to the keys by which pages and annotations are found in the structure.
    """

    def __init__(self, source: pikepdf.Pdf, writer: ObjectWriter, first_key: int) -> None:
        self.source = source
        self.new: dict[int, int] = {}
        self._writer, self._first_key = writer, first_key
        self._waiting: deque[int] = deque()

    def text(self, found: Any) -> bytes:
        """An object of the part as it is written in the whole."""
        return _TOKEN.sub(self._token, found.unparse())

    def content(self, found: Any) -> bytes:
        """What an object is, though it has a number, as it is written in the whole."""
        return _TOKEN.sub(self._token, found.unparse(resolved=True))

    def copy(self) -> None:
        """Write everything that has been named since, and what is named in that."""
        while self._waiting:
            old = self._waiting.popleft()
            found, number = self.source.get_object((old, 0)), self.new[old]
            if isinstance(found, pikepdf.Stream):
                entries = pikepdf.Dictionary(dict(found.stream_dict.items()))
                del entries["/Length"]
                body = _TOKEN.sub(self._token, entries.unparse(resolved=True)).strip()
                self._writer.put_stream(number, body.removeprefix(b"<<").removesuffix(b">>"), found.read_raw_bytes())
            else:
                self._writer.put(number, self.content(found))

    def _token(self, match: re.Match[bytes]) -> bytes:
        old = match[1]
        if old:
            return b"%d 0 R" % self._number(int(old))
        return match[2] + b"%d" % (int(match[3]) + self._first_key) if match[2] else match[0]

    def _number(self, old: int) -> int:
        number = self.new.get(old)
        if number is None:
            number = self.new[old] = self._writer.reserve()
            self._waiting.append(old)
        return number
