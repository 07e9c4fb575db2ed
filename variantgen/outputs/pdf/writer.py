"""A PDF file that is written object by object (ISO 32000-1, 7.5)."""

from __future__ import annotations

import hashlib
import zlib
from array import array
from typing import BinaryIO

_BINARY = b"%\xe2\xe3\xcf\xd3\n"  # tells programs that the file is not text
_PER_STREAM = 200


class PdfWriter:
    """Writes objects as they come; only where they are is kept in memory.

    Objects without data of their own go together into compressed streams, except in files of version 1.4, which has no
    such streams. The identifier of the file is a digest of what is in it.
    """

    def __init__(self, file: BinaryIO, version: str) -> None:
        self._file, self._packed = file, version != "1.4"
        self._size = 0
        self._digest = hashlib.sha256()
        # For every number: the offset in the file, or the number of the stream and the place in it plus one.
        self._at, self._place = array("Q", [0]), array("L", [0])
        self._waiting: list[tuple[int, bytes]] = []
        self._write(b"%%PDF-%s\n" % version.encode() + _BINARY)

    @property
    def name(self) -> bytes:
        """A digest of what has been written until now, in hexadecimal digits."""
        return self._digest.hexdigest()[:32].encode()

    def reserve(self) -> int:
        """The number of an object that is put later."""
        self._at.append(0)
        self._place.append(0)
        return len(self._at) - 1

    def put(self, number: int, body: bytes) -> None:
        """Write an object that has no stream."""
        if not self._packed:
            self._write_object(number, body)
            return
        self._waiting.append((number, body))
        if len(self._waiting) == _PER_STREAM:
            self._flush()

    def add(self, body: bytes) -> int:
        """Write an object that has no stream, with a new number."""
        number = self.reserve()
        self.put(number, body)
        return number

    def put_stream(self, number: int, entries: bytes, data: bytes) -> None:
        """Write a stream: the entries of its dictionary but for the length, and its data as they are."""
        self._write_object(number, b"<<%s/Length %d>>stream\n%s\nendstream" % (entries, len(data), data))

    def finish(self, root: int, info: int | None) -> None:
        """Write where everything is; ``root`` is the catalogue, ``info`` the document information."""
        self._flush()
        entries = b"/Root %d 0 R" % root + (b"/Info %d 0 R" % info if info else b"")
        entries += b"/ID[<%s><%s>]" % (self.name, self.name)
        start = self._size
        if self._packed:
            number = self.reserve()
            self._at[number] = start
            entries += b"/Type/XRef/W[1 8 2]/Filter/FlateDecode/Size %d" % len(self._at)
            self.put_stream(number, entries, zlib.compress(self._table()))
        else:
            rows = b"".join(b"%010d 00000 n \n" % at for at in self._at[1:])
            head = b"xref\n0 %d\n0000000000 65535 f \n" % len(self._at)
            self._write(head + rows + b"trailer\n<<%s/Size %d>>\n" % (entries, len(self._at)))
        self._write(b"startxref\n%d\n%%%%EOF\n" % start)

    def _table(self) -> bytes:
        rows = [b"\0" * 9 + b"\xff\xff"]
        for at, place in zip(self._at[1:], self._place[1:], strict=True):
            kind, index = (2, place - 1) if place else (1, 0)
            rows.append(bytes((kind,)) + at.to_bytes(8, "big") + index.to_bytes(2, "big"))
        return b"".join(rows)

    def _flush(self) -> None:
        """Write the waiting objects into a stream."""
        if not self._waiting:
            return
        number = self.reserve()
        heads, bodies, length = [], [], 0
        for place, (own, body) in enumerate(self._waiting, start=1):
            self._at[own], self._place[own] = number, place
            heads.append(b"%d %d" % (own, length))
            bodies.append(body)
            length += len(body) + 1
        head = b" ".join(heads) + b"\n"
        data = zlib.compress(head + b"\n".join(bodies))
        entries = b"/Type/ObjStm/N %d/First %d/Filter/FlateDecode" % (len(heads), len(head))
        self._waiting.clear()
        self.put_stream(number, entries, data)

    def _write_object(self, number: int, body: bytes) -> None:
        self._at[number] = self._size
        self._write(b"%d 0 obj\n%s\nendobj\n" % (number, body))

    def _write(self, data: bytes) -> None:
        self._file.write(data)
        self._digest.update(data)
        self._size += len(data)
