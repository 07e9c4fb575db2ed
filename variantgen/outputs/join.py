"""Joining of PDF parts into one file, with bounded memory and the same bytes every time."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path


def join_pdfs(parts: Sequence[Path], target: Path, title: str, even: bool) -> None:
    """Write the pages of all parts to one PDF; ``even`` pads each part but the last to an even number of pages."""
    import pikepdf

    with pikepdf.new() as whole:
        for part in parts:
            with pikepdf.open(part) as source:
                size = source.pages[0].mediabox
                whole.pages.extend(source.pages)
                if even and len(source.pages) % 2 and part is not parts[-1]:
                    whole.add_blank_page(page_size=(float(size[2]), float(size[3])))
        for page in whole.pages:
            page.obj.pop("/StructParents", None)
        whole.docinfo["/Title"] = title
        whole.save(target, deterministic_id=True, object_stream_mode=pikepdf.ObjectStreamMode.generate)
