"""Joining of PDF parts into one file, with bounded memory and the same bytes every time.

Parts are numbered and written by several at once (:mod:`variantgen.outputs.pdf.body`), by whoever is there to do it;
what is left is to put their files one behind the other, and what there is once.
"""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pikepdf

from variantgen.outputs.pdf.body import PdfBody, WrittenBody, numbers_of, page_lengths, write_body
from variantgen.outputs.pdf.bookmarks import Bookmark, BookmarkName, renamed, write_bookmarks
from variantgen.outputs.pdf.page_copier import PageCopier
from variantgen.outputs.pdf.structure import PartsOfStructure, SharedObjects, write_structure
from variantgen.outputs.pdf.writer import PdfWriter, is_packed
from variantgen.outputs.run import Run

_NO_INFORMATION = "2.0"  # the version of PDF in which metadata alone tell of a document
_PER_BODY = 1000  # numbers from which on parts are enough for a body; the same for any number of processes
_COUNTED = 50  # parts whose pages are counted together


def join_pdfs(
    parts: Sequence[Path],
    target: Path,
    title: str,
    language: str,
    even: bool,
    names: Sequence[BookmarkName] | None = None,
    run: Run = map,
) -> list[int]:
    """Write the pages of all parts to one PDF; the number of pages from each bookmark of a part to the next.

    ``even`` pads each part but the last to an even number of pages, so that the next part starts on an odd page.
    ``names`` are given to the bookmarks of the parts (not to those inside others). Tags, metadata and output intents
    are kept, if the first part has them; then all parts need tags. ``run`` may have others do the work.
    """
    with (
        tempfile.TemporaryDirectory(prefix=".joining-", dir=target.parent) as folder,
        target.open("wb") as file,
        pikepdf.open(parts[0]) as first,
    ):
        whole = _Whole(PdfWriter(file, first.pdf_version), first)
        bodies = list(whole.bodies(parts, even, Path(folder)))
        for body, written in zip(bodies, run(write_body, bodies), strict=True):
            whole.take(body, written)
        whole.finish(title, language, names)
    return whole.lengths


def page_counts(parts: Sequence[Path], run: Run = map) -> list[int]:
    """The number of pages from each bookmark of the parts to the next, as :func:`join_pdfs` tells it."""
    some = [tuple(parts[start : start + _COUNTED]) for start in range(0, len(parts), _COUNTED)]
    return [length for lengths in run(_lengths, some) for length in lengths]


def _lengths(parts: Sequence[Path]) -> list[int]:
    found = []
    for path in parts:
        with pikepdf.open(path) as source:
            found += page_lengths(source)
    return found


class _Whole:
    """The document that is being written; ``first`` is its first part."""

    def __init__(self, writer: PdfWriter, first: pikepdf.Pdf) -> None:
        self._writer, self._first = writer, first
        self._part = PageCopier(first, writer, 0)
        self._pages = writer.reserve()
        self._shared = SharedObjects.of(self._part, writer) if "/StructTreeRoot" in first.Root else None
        self._structures: list[PartsOfStructure] = []
        self._nodes: list[tuple[int, int]] = []
        self._bookmarks: list[Bookmark] = []
        self._next_key = 0
        self.lengths: list[int] = []

    def bodies(self, parts: Sequence[Path], even: bool, folder: Path) -> Iterator[PdfBody]:
        """The parts, as many together as have enough objects; the numbers of these are reserved."""
        place = 0
        while place < len(parts):
            room, end = 0, place
            while end < len(parts) and room < _PER_BODY:
                room, end = room + numbers_of(parts[end]), end + 1
            yield PdfBody(
                tuple(parts[place:end]),
                place,
                self._writer.reserve(room),
                room,
                is_packed(self._first.pdf_version),
                self._pages,
                tuple(even and part + 1 < len(parts) for part in range(place, end)),
                self._shared,
                folder / f"{place:07}",
            )
            place = end

    def take(self, body: PdfBody, written: WrittenBody) -> None:
        """Take the next body."""
        self._writer.append(body.file, body.first, written.rows, written.digest)
        body.file.unlink()
        self._nodes += written.nodes
        self._bookmarks += written.bookmarks
        self.lengths += written.lengths
        if written.structure:
            self._structures.append(written.structure)
            self._next_key = body.first + body.room

    def finish(self, title: str, language: str, names: Sequence[BookmarkName] | None) -> None:
        """Write what there is once."""
        count, kids = sum(pages for _, pages in self._nodes), b" ".join(b"%d 0 R" % node for node, _ in self._nodes)
        self._writer.put(self._pages, b"<</Type/Pages/Count %d/Kids[%s]>>" % (count, kids))
        entries = b"/Type/Catalog/Pages %d 0 R/Lang %s" % (self._pages, _string(language))
        entries += b"/ViewerPreferences<</DisplayDocTitle true>>"
        bookmarks = self._bookmarks if names is None else renamed(self._bookmarks, names)
        if bookmarks:
            entries += b"/Outlines %d 0 R" % write_bookmarks(self._writer, bookmarks)
        if self._shared:
            root = write_structure(self._writer, self._shared, self._structures, self._next_key)
            entries += b"/MarkInfo<</Marked true>>/StructTreeRoot %d 0 R" % root
        entries += self._standing(count)
        root = self._writer.add(b"<<%s>>" % entries)
        old = self._first.pdf_version == _NO_INFORMATION
        self._writer.finish(root, None if old else self._writer.add(b"<</Title %s>>" % _string(title)))

    def _standing(self, pages: int) -> bytes:
        """What a standard wants of the whole: metadata and output intents, as the first part has them."""
        found: Any = self._first.Root.get("/OutputIntents")
        entries = b"" if found is None else b"/OutputIntents " + self._part.text(found)
        self._part.copy()
        metadata = self._first.Root.Metadata.read_bytes() if "/Metadata" in self._first.Root else b""
        if b"pdfaid:part" in metadata or b"pdfuaid:part" in metadata:
            for key, value in ((b"xmpTPg:NPages", b"%d" % pages), (b"xmpMM:[A-Za-z]+ID", self._writer.name)):
                metadata = re.sub(rb"(<%s>)[^<]*" % key, rb"\g<1>%s" % value, metadata)
            number = self._writer.reserve()
            self._writer.put_stream(number, b"/Type/Metadata/Subtype/XML", metadata)
            entries += b"/Metadata %d 0 R" % number
        return entries


def _string(text: str) -> bytes:
    found: bytes = pikepdf.String(text).unparse()
    return found
