"""The objects of some parts of a PDF, with the numbers that they have in the whole, in a file of their own.

Where each part's numbers begin is known before any part is written, so this can be done anywhere, in any order.
"""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path
from typing import Any

import pikepdf
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.outputs.pdf.bookmarks import Bookmark, read_bookmarks
from variantgen.outputs.pdf.page_copier import PageCopier
from variantgen.outputs.pdf.structure import PartsOfStructure, SharedObjects, StructureReader
from variantgen.outputs.pdf.writer import ObjectWriter, spare

_TAIL = 1024  # bytes at the end of a file in which its trailer is
_TRAILER = re.compile(rb"trailer\s*<<\s*/Size (\d+)")


class PdfBody(Struct, frozen=True):
    """Parts of a whole, the first of which is the one at ``place``, and the file for their objects.

    The objects are numbered from ``first`` on, ``room`` numbers at most. ``pages`` is the number of the root of the
    tree of pages; ``even`` says which parts get a blank page behind an odd number of pages.
    """

    parts: tuple[Path, ...]
    place: int
    first: int
    room: int
    packed: bool
    pages: int
    even: tuple[bool, ...]
    shared: SharedObjects | None
    file: Path


class WrittenBody(Struct, frozen=True):
    """What the whole has to know of a body: where its objects are, a digest of them, the nodes of the tree of pages and
    how many pages each has, the bookmarks, the number of pages from each to the next, and what is of the structure.
    """

    rows: NDArray[Any]
    digest: bytes
    nodes: list[tuple[int, int]]
    bookmarks: list[Bookmark]
    lengths: list[int]
    structure: PartsOfStructure | None


def numbers_of(path: Path) -> int:
    """A bound of the numbers that the objects of a part need."""
    with path.open("rb") as file:
        file.seek(max(0, path.stat().st_size - _TAIL))
        found = _TRAILER.findall(file.read())
    if found:
        size = int(found[-1])
    else:
        with pikepdf.open(path) as source:
            size = int(source.trailer.Size)
    return size + spare(size)


def write_body(body: PdfBody) -> WrittenBody:
    """Write the objects of some parts. Raises ValueError if there is no room for their numbers."""
    with body.file.open("wb") as file:
        writer = ObjectWriter(file, body.first, body.packed)
        # As there are no more keys than objects, keys begin where numbers do.
        structure = StructureReader(writer, body.shared, body.place, body.first) if body.shared else None
        nodes, bookmarks, lengths = [], list[Bookmark](), list[int]()
        for path, even in zip(body.parts, body.even, strict=True):
            with pikepdf.open(path) as source:
                part = PageCopier(source, writer, structure.next_key if structure else 0)
                nodes.append(_write_pages(part, writer, body.pages, even))
                if structure:
                    structure.add(part)
                bookmarks += read_bookmarks(part)
                lengths += page_lengths(source)
                part.copy()
        found = structure.finish() if structure else None
        writer.flush()
    rows = writer.rows()
    if len(rows) > body.room or (structure and structure.next_key > body.first + body.room):
        raise ValueError(f"no room for the objects of {body.parts[0].name}: {len(rows)} in place of {body.room}")
    return WrittenBody(rows, writer.digest, nodes, bookmarks, lengths, found)


def _write_pages(part: PageCopier, writer: ObjectWriter, root: int, even: bool) -> tuple[int, int]:
    """Write the node of the tree of pages for a part: its number, and that of its pages."""
    node = writer.reserve()
    for page in part.source.pages:
        part.new[page.obj.Parent.objgen[0]] = node
    kids = [part.text(page.obj) for page in part.source.pages]
    if even and len(kids) % 2:
        size = part.text(part.source.pages[0].obj.MediaBox)
        kids.append(b"%d 0 R" % writer.add(b"<</Type/Page/Parent %d 0 R/MediaBox %s/Resources<<>>>>" % (node, size)))
    writer.put(node, b"<</Type/Pages/Parent %d 0 R/Count %d/Kids[%s]>>" % (root, len(kids), b" ".join(kids)))
    return node, len(kids)


def page_lengths(source: pikepdf.Pdf) -> list[int]:
    """The number of pages from each bookmark of a part to the next."""
    places = {page.obj.objgen: place for place, page in enumerate(source.pages)}
    starts = []
    outlines: Any = source.Root.get("/Outlines", {})
    item = outlines.get("/First")
    while item is not None:
        starts.append(places[item.Dest[0].objgen])
        item = item.get("/Next")
    return [end - start for start, end in pairwise((*starts, len(source.pages)))]
