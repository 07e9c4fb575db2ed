"""The bookmarks of a PDF: read from its parts, named anew, written as an outline."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Any

import pikepdf
from msgspec import Struct, field

from variantgen.outputs.pdf.page_copier import PageCopier
from variantgen.outputs.pdf.writer import PdfWriter


class BookmarkName(Struct, frozen=True):
    """The name of a bookmark, and of the group that it is in (if any)."""

    title: str
    group: str = ""


class Bookmark(Struct):
    """A bookmark; ``title`` and ``target`` as they are written in the file."""

    title: bytes
    target: bytes
    inside: list[Bookmark] = field(default_factory=list)


def read_bookmarks(part: PageCopier, within: Any = None) -> Iterator[Bookmark]:
    """The bookmarks of a part in order."""
    item = (part.source.Root.get("/Outlines") if within is None else within) or {}
    item = item.get("/First")
    while item is not None:
        yield Bookmark(item.Title.unparse(), part.text(item.Dest), list(read_bookmarks(part, item)))
        item = item.get("/Next")


def renamed(found: Sequence[Bookmark], names: Sequence[BookmarkName]) -> list[Bookmark]:
    """Bookmarks with other names, under their groups if there are groups.

    Those of one group that follow each other are put together.
    """
    named = [
        (name.group, Bookmark(_string(name.title), old.target, old.inside))
        for old, name in zip(found, names, strict=True)
    ]
    if not any(group for group, _ in named):
        return [bookmark for _, bookmark in named]
    whole: list[Bookmark] = []
    for group, items in groupby(named, key=lambda item: item[0]):
        own = [bookmark for _, bookmark in items]
        whole += [Bookmark(_string(group), own[0].target, own)] if group else own
    return whole


def write_bookmarks(writer: PdfWriter, found: Sequence[Bookmark]) -> int:
    """Write an outline whose bookmarks are folded; its number."""
    root = writer.reserve()
    first, last = _write_level(writer, found, root)
    writer.put(root, b"<</Type/Outlines/First %d 0 R/Last %d 0 R/Count %d>>" % (first, last, len(found)))
    return root


def _write_level(writer: PdfWriter, found: Sequence[Bookmark], parent: int) -> tuple[int, int]:
    """Write bookmarks beside each other; the numbers of the first and the last."""
    numbers = [writer.reserve() for _ in found]
    for i, (number, bookmark) in enumerate(zip(numbers, found, strict=True)):
        entries = b"/Title %s/Parent %d 0 R/Dest %s" % (bookmark.title, parent, bookmark.target)
        if i:
            entries += b"/Prev %d 0 R" % numbers[i - 1]
        if i + 1 < len(numbers):
            entries += b"/Next %d 0 R" % numbers[i + 1]
        if bookmark.inside:
            first, last = _write_level(writer, bookmark.inside, number)
            entries += b"/First %d 0 R/Last %d 0 R/Count -%d" % (first, last, len(bookmark.inside))
        writer.put(number, b"<<%s>>" % entries)
    return numbers[0], numbers[-1]


def _string(text: str) -> bytes:
    found: bytes = pikepdf.String(text).unparse()
    return found
