"""Joining of PDFs: what the parts hold is kept, whatever is written in them."""

from __future__ import annotations

import pickle
import tracemalloc
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import pikepdf
import pytest

from tests.pdf_text import page_texts
from variantgen.outputs import join
from variantgen.outputs.join import join_pdfs, page_counts
from variantgen.outputs.pdf.bookmarks import BookmarkName

# What looks like references and keys of a PDF inside strings must not change.
STRANGE = ["(1 0 R) /StructParents 7", "\\) 12 0 R", "Ж 3 0 R", "<41> 5 0 R", "a\r\nb\x80", ""]


def part(path: Path, pages: int, title: str) -> Path:
    """A PDF that a library has made: pages, a link between the first two, a bookmark, a strange string."""
    pdf = pikepdf.new()
    for number in range(pages):
        pdf.add_blank_page(page_size=(200, 100 + number))
        page = pdf.pages[number]
        page.Contents = pdf.make_stream(b"BT /F 12 Tf 10 10 Td (%s %d) Tj ET" % (path.stem.encode(), number))
        font = pikepdf.Dictionary(Type=pikepdf.Name.Font, Subtype=pikepdf.Name.Type1, BaseFont=pikepdf.Name.Helvetica)
        page.Resources = pikepdf.Dictionary(Font=pikepdf.Dictionary(F=pdf.make_indirect(font)))
    if pages > 1:
        link = pikepdf.Dictionary(
            Type=pikepdf.Name.Annot,
            Subtype=pikepdf.Name.Link,
            Rect=[0, 0, 10, 10],
            Dest=[pdf.pages[1].obj, pikepdf.Name.Fit],
            Contents=pikepdf.String(title),
        )
        pdf.pages[0].obj.Annots = pdf.make_indirect(pikepdf.Array([pdf.make_indirect(link)]))
    with pdf.open_outline() as outline:
        outline.root.append(pikepdf.OutlineItem(title or "-", 0))
    pdf.Root.Metadata = pdf.make_stream(b"<x/>")
    pdf.save(path, object_stream_mode=pikepdf.ObjectStreamMode.generate)
    return path


@pytest.mark.parametrize("numbers", [1, 1000])  # each part by itself, or all together
def test_pages_links_and_strings_are_kept(numbers: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(join, "_PER_BODY", numbers)
    parts = [part(tmp_path / f"p{i}.pdf", i + 1, text) for i, text in enumerate(STRANGE)]
    join_pdfs(parts, tmp_path / "whole.pdf", "T (1 0 R) Ж", "ru", even=True)
    texts = page_texts(tmp_path / "whole.pdf")
    wanted = []
    for i in range(len(STRANGE)):
        wanted += [f"p{i} {number}" for number in range(i + 1)]
        wanted += [""] if i % 2 == 0 and i + 1 < len(STRANGE) else []
    assert texts == wanted
    with pikepdf.open(tmp_path / "whole.pdf") as pdf:
        assert pdf.check_pdf_syntax() == []
        assert str(pdf.docinfo["/Title"]) == "T (1 0 R) Ж"
        assert "/StructTreeRoot" not in pdf.Root
        assert "/Metadata" not in pdf.Root
        links = [(index, page.obj.Annots[0]) for index, page in enumerate(pdf.pages) if "/Annots" in page.obj]
        assert [str(link.Contents) for _, link in links] == STRANGE[1:]
        for index, link in links:
            assert link.Dest[0].objgen == pdf.pages[index + 1].obj.objgen
        with pdf.open_outline() as outline:
            assert [item.title for item in outline.root] == [text or "-" for text in STRANGE]
        assert [float(page.mediabox[3]) for page in pdf.pages[4:8]] == [100, 101, 102, 100]


def test_whoever_writes_the_bodies_makes_the_same_bytes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(join, "_PER_BODY", 30)
    parts = [part(tmp_path / f"p{i}.pdf", 3, "x") for i in range(9)]
    asked: list[int] = []

    def others(function: Callable[[Any], Any], given: Iterable[Any]) -> Iterator[Any]:
        """The last first, as other processes might do them, and sent to and fro."""
        sent = [pickle.dumps(one) for one in given]
        asked.append(len(sent))
        done = [pickle.dumps(function(pickle.loads(one))) for one in reversed(sent)]
        return map(pickle.loads, reversed(done))

    lengths = join_pdfs(parts, tmp_path / "here.pdf", "T", "en", even=True)
    assert lengths == [3] * 9
    assert join_pdfs(parts, tmp_path / "there.pdf", "T", "en", even=True, run=others) == lengths
    assert page_counts(parts, others) == lengths
    assert (tmp_path / "here.pdf").read_bytes() == (tmp_path / "there.pdf").read_bytes()
    assert asked[0] > 2, "several bodies"
    assert {path.suffix for path in tmp_path.iterdir()} == {".pdf"}, "nothing else is left"


def test_bookmarks_are_named_one_by_one(tmp_path: Path) -> None:
    parts = [part(tmp_path / f"p{i}.pdf", 1, "x") for i in range(3)]
    names = [BookmarkName("a"), BookmarkName("b", "G"), BookmarkName("c", "G")]
    join_pdfs(parts, tmp_path / "whole.pdf", "T", "en", False, names)
    with pikepdf.open(tmp_path / "whole.pdf") as pdf, pdf.open_outline() as outline:
        assert [(item.title, [child.title for child in item.children]) for item in outline.root] == [
            ("a", []),
            ("G", ["b", "c"]),
        ]
    with pytest.raises(ValueError, match="shorter"):
        join_pdfs(parts, tmp_path / "whole.pdf", "T", "en", False, names[:2])


def test_the_name_of_a_file_is_a_digest_of_it(tmp_path: Path) -> None:
    one, two = (part(tmp_path / f"p{i}.pdf", 1, "x") for i in range(2))
    found = []
    for parts in ([one], [one], [two]):
        join_pdfs(parts, tmp_path / "whole.pdf", "T", "en", False)
        with pikepdf.open(tmp_path / "whole.pdf") as pdf:
            found.append(bytes(pdf.trailer.ID[0]))
    assert found[0] == found[1] != found[2]
    assert len(found[0]) == 16


def test_memory_does_not_grow_with_the_number_of_parts(tmp_path: Path) -> None:
    # More parts than a system has open files, with more objects than go into one stream.
    one = part(tmp_path / "one.pdf", 1, "x")
    peaks = []
    for count in (200, 1200):
        tracemalloc.start()
        join_pdfs([one] * count, tmp_path / "whole.pdf", "T", "en", True)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    with pikepdf.open(tmp_path / "whole.pdf") as pdf:
        assert len(pdf.pages) == 2 * 1200 - 1
    assert (peaks[1] - peaks[0]) / 1000 < 3000, "bytes for a part of two pages: numbers and a bookmark"
