"""Joining of PDF parts into one file, with bounded memory and the same bytes every time."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import pikepdf

from variantgen.outputs.pdf.bookmarks import Bookmark, BookmarkName, read_bookmarks, renamed, write_bookmarks
from variantgen.outputs.pdf.page_copier import PageCopier
from variantgen.outputs.pdf.structure import Structure
from variantgen.outputs.pdf.writer import PdfWriter

_NO_INFORMATION = "2.0"  # the version of PDF in which metadata alone tell of a document


def join_pdfs(
    parts: Sequence[Path],
    target: Path,
    title: str,
    language: str,
    even: bool,
    names: Sequence[BookmarkName] | None = None,
) -> list[int]:
    """Write the pages of all parts to one PDF; the number of pages from each bookmark of a part to the next.

    ``even`` pads each part but the last to an even number of pages, so that the next part starts on an odd page.
    ``names`` are given to the bookmarks of the parts (not to those inside others). Tags, metadata and output intents
    are kept, if the first part has them; then all parts need tags.
    """
    with target.open("wb") as file, pikepdf.open(parts[0]) as first:
        whole = _Whole(PdfWriter(file, first.pdf_version), first)
        for number, path in enumerate(parts, start=1):
            with pikepdf.open(path) as source:
                whole.add(source, even and number < len(parts))
        whole.finish(title, language, names)
    return whole.lengths


def page_counts(parts: Sequence[Path]) -> list[int]:
    """The number of pages from each bookmark of the parts to the next, as :func:`join_pdfs` tells it."""
    found = []
    for path in parts:
        with pikepdf.open(path) as source:
            found += _lengths(source)
    return found


class _Whole:
    """The document that is being written; ``first`` is its first part."""

    def __init__(self, writer: PdfWriter, first: pikepdf.Pdf) -> None:
        self._writer, self._first = writer, first
        self._pages = writer.reserve()
        self._structure = Structure(writer) if "/StructTreeRoot" in first.Root else None
        self._nodes: list[int] = []
        self._count = 0
        self._bookmarks: list[Bookmark] = []
        self.lengths: list[int] = []

    def add(self, source: pikepdf.Pdf, even: bool) -> None:
        """Write what a part holds."""
        part = PageCopier(source, self._writer, self._structure.next_key if self._structure else 0)
        node = self._writer.reserve()
        for page in source.pages:
            part.new[page.obj.Parent.objgen[0]] = node
        kids = [part.text(page.obj) for page in source.pages]
        if even and len(kids) % 2:
            size = part.text(source.pages[0].obj.MediaBox)
            blank = b"<</Type/Page/Parent %d 0 R/MediaBox %s/Resources<<>>>>" % (node, size)
            kids.append(b"%d 0 R" % self._writer.add(blank))
        self._writer.put(
            node, b"<</Type/Pages/Parent %d 0 R/Count %d/Kids[%s]>>" % (self._pages, len(kids), b" ".join(kids))
        )
        if self._structure:
            self._structure.add(part)
        self._bookmarks += read_bookmarks(part)
        self.lengths += _lengths(source)
        part.copy()
        self._nodes.append(node)
        self._count += len(kids)

    def finish(self, title: str, language: str, names: Sequence[BookmarkName] | None) -> None:
        """Write what there is once."""
        kids = b" ".join(b"%d 0 R" % node for node in self._nodes)
        self._writer.put(self._pages, b"<</Type/Pages/Count %d/Kids[%s]>>" % (self._count, kids))
        entries = b"/Type/Catalog/Pages %d 0 R/Lang %s" % (self._pages, _string(language))
        entries += b"/ViewerPreferences<</DisplayDocTitle true>>"
        bookmarks = self._bookmarks if names is None else renamed(self._bookmarks, names)
        if bookmarks:
            entries += b"/Outlines %d 0 R" % write_bookmarks(self._writer, bookmarks)
        if self._structure:
            entries += b"/MarkInfo<</Marked true>>/StructTreeRoot %d 0 R" % self._structure.write()
        entries += self._standing()
        root = self._writer.add(b"<<%s>>" % entries)
        old = self._first.pdf_version == _NO_INFORMATION
        self._writer.finish(root, None if old else self._writer.add(b"<</Title %s>>" % _string(title)))

    def _standing(self) -> bytes:
        """What a standard wants of the whole: metadata and output intents, as the first part has them."""
        part = PageCopier(self._first, self._writer, 0)
        found: Any = self._first.Root.get("/OutputIntents")
        entries = b"" if found is None else b"/OutputIntents " + part.text(found)
        part.copy()
        metadata = self._first.Root.Metadata.read_bytes() if "/Metadata" in self._first.Root else b""
        if b"pdfaid:part" in metadata or b"pdfuaid:part" in metadata:
            for key, value in ((b"xmpTPg:NPages", b"%d" % self._count), (b"xmpMM:[A-Za-z]+ID", self._writer.name)):
                metadata = re.sub(rb"(<%s>)[^<]*" % key, rb"\g<1>%s" % value, metadata)
            number = self._writer.reserve()
            self._writer.put_stream(number, b"/Type/Metadata/Subtype/XML", metadata)
            entries += b"/Metadata %d 0 R" % number
        return entries


def _lengths(source: pikepdf.Pdf) -> list[int]:
    """The number of pages from each bookmark of a part to the next."""
    places = {page.obj.objgen: place for place, page in enumerate(source.pages)}
    starts = []
    outlines: Any = source.Root.get("/Outlines", {})
    item = outlines.get("/First")
    while item is not None:
        starts.append(places[item.Dest[0].objgen])
        item = item.get("/Next")
    return [end - start for start, end in pairwise((*starts, len(source.pages)))]


def _string(text: str) -> bytes:
    found: bytes = pikepdf.String(text).unparse()
    return found
