"""Objects of a PDF written one by one, and a file of them (ISO 32000-1, 7.5)."""

from __future__ import annotations

import hashlib
import zlib
from array import array
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

_BINARY = b"%\xe2\xe3\xcf\xd3\n"  # tells programs that the file is not text
_PER_STREAM = 200
_BLOCK = 1 << 20
# A row of the table of a file: what a number stands for (below), the offset or the number of a stream, the place in it.
_ROW = np.dtype([("kind", "u1"), ("at", ">u8"), ("place", ">u2")])
_FREE, _ALONE, _PACKED = range(3)
_NEVER = 0xFFFF  # the generation of numbers that stay free


def is_packed(version: str) -> bool:
    """Whether files of a version of PDF have compressed streams of objects."""
    return version != "1.4"


def spare(objects: int) -> int:
    """How many more numbers than it has objects a part takes at most: for pages, streams, leaves of trees."""
    return objects // _PER_STREAM + 8


class ObjectWriter:
    """Writes objects with numbers from ``first`` on as they come; only where they are is kept in memory.

    Objects without data of their own go together into compressed streams, if they are to be ``packed``.
    """

    def __init__(self, file: BinaryIO, first: int, packed: bool) -> None:
        self._file, self._first, self._packed = file, first, packed
        self._size, self._digest = 0, hashlib.sha256()
        self._kind, self._at, self._place = array("B"), array("Q"), array("H")  # by number, from the first on
        self._waiting: list[tuple[int, bytes]] = []

    def reserve(self, count: int = 1) -> int:
        """The number of an object that is put later, or the first of several."""
        number = self._first + len(self._kind)
        self._kind.extend([_FREE] * count)
        self._at.extend([0] * count)
        self._place.extend([_NEVER] * count)
        return number

    def put(self, number: int, body: bytes) -> None:
        """Write an object that has no stream."""
        if not self._packed:
            self._write_object(number, body)
            return
        self._waiting.append((number, body))
        if len(self._waiting) == _PER_STREAM:
            self.flush()

    def add(self, body: bytes) -> int:
        """Write an object that has no stream, with a new number."""
        number = self.reserve()
        self.put(number, body)
        return number

    def put_stream(self, number: int, entries: bytes, data: bytes) -> None:
        """Write a stream: the entries of its dictionary but for the length, and its data as they are."""
        self._write_object(number, b"<<%s/Length %d>>stream\n%s\nendstream" % (entries, len(data), data))

    def flush(self) -> None:
        """Write the waiting objects into a stream."""
        if not self._waiting:
            return
        number = self.reserve()
        heads, bodies, length = [], [], 0
        for place, (own, body) in enumerate(self._waiting):
            self._note(own, _PACKED, number, place)
            heads.append(b"%d %d" % (own, length))
            bodies.append(body)
            length += len(body) + 1
        head = b" ".join(heads) + b"\n"
        data = zlib.compress(head + b"\n".join(bodies))
        entries = b"/Type/ObjStm/N %d/First %d/Filter/FlateDecode" % (len(heads), len(head))
        self._waiting.clear()
        self.put_stream(number, entries, data)

    @property
    def digest(self) -> bytes:
        """A digest of what has been written until now."""
        return self._digest.digest()

    def rows(self) -> NDArray[Any]:
        """Where all numbers from the first on are, shape (N,): rows of the table of the file."""
        found = np.empty(len(self._kind), _ROW)
        found["kind"], found["at"], found["place"] = self._kind, self._at, self._place
        return found

    def _write_object(self, number: int, body: bytes) -> None:
        self._note(number, _ALONE, self._size, 0)
        self._write(b"%d 0 obj\n%s\nendobj\n" % (number, body))

    def _note(self, number: int, kind: int, at: int, place: int) -> None:
        own = number - self._first
        self._kind[own], self._at[own], self._place[own] = kind, at, place

    def _write(self, data: bytes) -> None:
        self._file.write(data)
        self._size += len(data)
        self._digest.update(data)


class PdfWriter(ObjectWriter):
    """A file of such objects. Its identifier is a digest of what is in it."""

    def __init__(self, file: BinaryIO, version: str) -> None:
        super().__init__(file, 0, is_packed(version))
        self._others: list[tuple[int, NDArray[Any]]] = []
        self.reserve()  # no object has the number zero
        self._write(b"%%PDF-%s\n" % version.encode() + _BINARY)

    @property
    def name(self) -> bytes:
        """A digest of what has been written until now, in hexadecimal digits."""
        return self.digest.hex()[:32].encode()

    def append(self, path: Path, first: int, rows: NDArray[Any], digest: bytes) -> None:
        """Take a file of objects that an :class:`ObjectWriter` has written, with reserved numbers from ``first`` on;
        ``rows`` has one for each number, shape (N,).
        """
        rows["at"][rows["kind"] == _ALONE] += self._size
        self._others.append((first, rows))
        self._digest.update(digest)
        with path.open("rb") as file:
            while block := file.read(_BLOCK):
                self._file.write(block)
                self._size += len(block)

    def finish(self, root: int, info: int | None) -> None:
        """Write where everything is; ``root`` is the catalogue, ``info`` the document information."""
        self.flush()
        entries = b"/Root %d 0 R" % root + (b"/Info %d 0 R" % info if info else b"")
        entries += b"/ID[<%s><%s>]" % (self.name, self.name)
        start = self._size
        if self._packed:
            number = self.reserve()
            self._note(number, _ALONE, start, 0)
            rows = self.rows()
            entries += b"/Type/XRef/W[1 8 2]/Filter/FlateDecode/Size %d" % len(rows)
            self.put_stream(number, entries, zlib.compress(rows.tobytes()))
        else:
            rows = self.rows()
            listed = zip(rows["at"].tolist(), rows["kind"].tolist(), strict=True)
            body = b"".join(
                b"%010d 00000 n \n" % at if kind == _ALONE else b"0000000000 65535 f \n" for at, kind in listed
            )
            self._write(b"xref\n0 %d\n" % len(rows) + body + b"trailer\n<<%s/Size %d>>\n" % (entries, len(rows)))
        self._write(b"startxref\n%d\n%%%%EOF\n" % start)

    def rows(self) -> NDArray[Any]:
        """Where all numbers are, shape (N,): those of the files that were taken, too."""
        found = super().rows()
        for first, rows in self._others:
            found[first : first + len(rows)] = rows
        return found
