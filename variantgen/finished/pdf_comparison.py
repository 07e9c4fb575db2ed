"""The pages of a student against those in a file of the class, which may be damaged or made to harm.

A stream of a few kilobytes can unpack to gigabytes, doubly packed to more: streams are read as this program writes
them, packed once, and only so far.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from variantgen.limits import PDF_PAGE_BYTES, PDF_STREAM_BYTES


def compared(content: bytes, joined: Path, place: int, problems_inside: bool) -> tuple[range, list[str]]:
    """The place of the student's pages in the file of the class, and the pages that differ.

    ``problems_inside``: a bookmark of a student has those of problems in it.
    """
    import pikepdf

    try:
        with _careful(), pikepdf.open(joined) as whole:
            return _compared(content, joined.name, whole, list(_starts(whole, problems_inside)), place)
    except (pikepdf.PdfError, LookupError, TypeError, ValueError, AttributeError) as error:
        reason = str(error).removeprefix(str(joined)).strip(": ")
        return range(0), [f"{joined.name} cannot be read ({reason}): restore it from a copy"]


def _compared(content: bytes, name: str, whole: Any, starts: list[int], place: int) -> tuple[range, list[str]]:
    import io

    import pikepdf

    with pikepdf.open(io.BytesIO(content)) as own:
        if place >= len(starts):
            return range(0), [f"{name} has no bookmark of the student"]
        there = range(starts[place], starts[place] + len(own.pages))
        if there.stop > len(whole.pages):
            return there, [f"{name} has too few pages"]
        different = [
            f"page {number + 1} of {name} is another one"
            for number, page in zip(there, own.pages, strict=True)
            if page_digest(page) != page_digest(whole.pages[number])
        ]
        return there, different


@contextmanager
def _careful() -> Iterator[None]:
    """No stream is unpacked twice or without bound; the bounds of the library are those of the process."""
    from pikepdf import settings

    before: dict[str, Any] = settings.set_qpdf_limits(
        flate_max_memory=PDF_STREAM_BYTES, run_length_max_memory=PDF_STREAM_BYTES, max_stream_filters=1
    )
    try:
        yield
    finally:
        settings.set_qpdf_limits(**before)


def destination(item: Any) -> Any:
    """The page that a bookmark leads to."""
    return item.destination[0]


def _starts(whole: Any, problems_inside: bool) -> Iterator[int]:
    """The first page of each student in a joined file, where bookmarks of groups hold those of students."""
    places = {page.obj.objgen: number for number, page in enumerate(whole.pages)}
    with whole.open_outline() as outline:
        for item in outline.root:
            is_group = any(inner.children for inner in item.children) if problems_inside else bool(item.children)
            for student in item.children if is_group else [item]:
                yield places[destination(student).objgen]


def page_digest(page: Any) -> str:
    """A digest of what is drawn on a page, and of the fonts with which it is. Raises ValueError for too much of it."""
    content = _drawn(page)
    digest = hashlib.sha256(content)
    size = len(content)
    fonts = page.obj.get("/Resources", {}).get("/Font", {})
    for name in sorted(fonts.keys()):
        for inner in fonts[name].get("/DescendantFonts", []):
            file = inner.FontDescriptor
            for key in ("/FontFile", "/FontFile2", "/FontFile3"):
                if key in file:
                    font = file[key].read_bytes()
                    size = _within(size + len(font))
                    digest.update(name.encode() + font)
    return digest.hexdigest()


def is_used(page: Any) -> bool:
    """Whether anything is drawn on a page."""
    return bool(_drawn(page).strip())


def _drawn(page: Any) -> bytes:
    """The content of a page, which may be in several streams; a page without is empty."""
    found = b""
    for stream in page.obj.get("/Contents", []) if _is_list(page) else [page.obj.Contents]:
        found += stream.read_bytes()
        _within(len(found))
    return found


def _is_list(page: Any) -> bool:
    """Whether the content of a page is a list of streams, or there is none."""
    import pikepdf

    return "/Contents" not in page.obj or isinstance(page.obj.Contents, pikepdf.Array)


def _within(size: int) -> int:
    """The size of what a page needs. Raises ValueError if it is too large."""
    if size > PDF_PAGE_BYTES:
        raise ValueError(f"a page needs more than {PDF_PAGE_BYTES // 1_000_000} MB")
    return size
