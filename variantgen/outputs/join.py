"""Joining of PDF parts into one file, with bounded memory and the same bytes every time."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path

# Parts stay open until the whole is written; systems allow about a thousand open files.
_GROUP = 200


def join_pdfs(
    parts: Sequence[Path], target: Path, title: str, language: str, even: bool, pad_last: bool = False
) -> None:
    """Write the pages of all parts to one PDF.

    ``even`` pads each part to an even number of pages, the last one only with ``pad_last``, so that the next part
    starts on an odd page.
    """
    import pikepdf

    if len(parts) > _GROUP:
        groups = [parts[i : i + _GROUP] for i in range(0, len(parts), _GROUP)]
        joined = [target.with_name(f"{target.stem}-{i}.pdf") for i in range(len(groups))]
        for group, path in zip(groups, joined, strict=True):
            join_pdfs(group, path, title, language, even, pad_last=True)
        join_pdfs(joined, target, title, language, False)
        for path in joined:
            path.unlink()
        return
    with ExitStack() as stack:
        whole = stack.enter_context(pikepdf.new())
        for part in parts:
            source = stack.enter_context(pikepdf.open(part))
            size = source.pages[0].mediabox
            for page in source.pages:
                # The structure trees of the parts cannot be joined; what points to them would dangle.
                if "/StructParents" in page.obj:
                    del page.obj["/StructParents"]
            whole.pages.extend(source.pages)
            if even and len(source.pages) % 2 and (pad_last or part is not parts[-1]):
                whole.add_blank_page(page_size=(float(size[2]), float(size[3])))
        whole.docinfo["/Title"] = title
        whole.Root["/Lang"] = pikepdf.String(language)
        whole.save(target, deterministic_id=True, object_stream_mode=pikepdf.ObjectStreamMode.generate)
