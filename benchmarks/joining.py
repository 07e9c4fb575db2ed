"""Joining of PDF parts: the own joiner beside what pikepdf does by itself, in time, memory and what is kept."""

from __future__ import annotations

import hashlib
import resource
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pikepdf
from msgspec.structs import replace

from benchmarks import exams, processes
from benchmarks.exams import FIVE_FAMILIES
from benchmarks.measure import Table
from benchmarks.options import Options
from benchmarks.processes import Ran
from benchmarks.sheets import drawn_sheets
from variantgen.exam.content import Content
from variantgen.exam.exam_file import read_exam
from variantgen.exam.roster import numbered
from variantgen.outputs.documents.sheet_data import sheets_data
from variantgen.outputs.documents.solution_data import solutions_data
from variantgen.outputs.formats import STUDENTS_PER_PART
from variantgen.outputs.join import join_pdfs
from variantgen.outputs.typst.sheet_pages import with_pages
from variantgen.outputs.typst.typesetter import typesetter
from variantgen.outputs.typst.writing import TYPST

TITLE = "Joining PDFs"
SIZES = (100, 500, 2000)  # students; solutions of the first two
_MADE = 2 * STUDENTS_PER_PART  # students whose parts are made; they are joined again and again
_MOST = 4_000_000_000  # bytes that a process may have

SHEETS, TAGGED, SOLUTIONS = "sheets", "sheets with tags", "solutions with tags"
OWN, PAGES, COPIED = "join_pdfs", "pikepdf, pages", "pikepdf, pages and tags"


def parts_of(folder: Path, count: int) -> dict[str, list[Path]]:
    """Parts of the documents of so many students: sheets of 16 students together, solutions of each."""
    exam = read_exam(exams.write(exams.of_families(FIVE_FAMILIES), folder))
    sheets = drawn_sheets(replace(exam, seed="0"), numbered(count))
    found: dict[str, list[Path]] = {SHEETS: [], TAGGED: [], SOLUTIONS: []}

    def put(kind: str, made: Sequence[bytes]) -> None:
        path = folder / f"{kind}-{len(found[kind])}.pdf"
        path.write_bytes(made[0])
        found[kind].append(path)

    with typesetter() as engine:
        for start in range(0, count, STUDENTS_PER_PART):
            content = Content(exam, sheets[start : start + STUDENTS_PER_PART])
            for kind, standards in ((SHEETS, ()), (TAGGED, ("ua-1",))):
                data = with_pages(sheets_data(content, TYPST), engine)
                put(kind, engine.compile("sheets.typ", data, tagged=kind == TAGGED, standards=standards))
            for number in range(len(content.sheets)):
                data = solutions_data(content, number, TYPST)
                put(SOLUTIONS, engine.compile("solutions.typ", data, tagged=True, standards=("ua-1",)))
    return found


def own(parts: Sequence[Path], target: Path) -> None:
    """The program's joiner."""
    join_pdfs(parts, target, "T", "ru", even=True)


def pages(parts: Sequence[Path], target: Path, tags: bool = False) -> None:
    """Pages, bookmarks and, if wanted, the structure of tags copied by pikepdf into one document."""
    with ExitStack() as opened, pikepdf.new() as whole:
        structure = _Structure(whole) if tags else None
        with whole.open_outline() as outline:
            for number, path in enumerate(parts, start=1):
                source = opened.enter_context(pikepdf.open(path))
                first = len(whole.pages)
                whole.pages.extend(source.pages)
                if structure:
                    structure.add(source, whole.pages[first:])
                with source.open_outline() as own_outline:
                    places = {page.obj.objgen: place for place, page in enumerate(source.pages)}
                    for item in own_outline.root:
                        place = places[item.destination[0].objgen]
                        outline.root.append(pikepdf.OutlineItem(item.title, first + place))
                if len(source.pages) % 2 and number < len(parts):
                    whole.add_blank_page(page_size=tuple(float(x) for x in source.pages[0].mediabox[2:]))
        if structure:
            structure.finish()
        whole.Root.Lang, whole.docinfo["/Title"] = pikepdf.String("ru"), "T"
        whole.save(target, deterministic_id=True, object_stream_mode=pikepdf.ObjectStreamMode.generate)


class _Structure:
    """The trees of tags of all parts under one document element (identifiers of table cells are left as they are)."""

    def __init__(self, whole: pikepdf.Pdf) -> None:
        self._whole, self._key = whole, 0
        self._children, self._parents, self._spaces = pikepdf.Array(), pikepdf.Array(), pikepdf.Array()
        self._document: Any = None

    def add(self, source: pikepdf.Pdf, copied: Sequence[Any]) -> None:
        """Copy the tree of a part whose pages have been copied: references to them are led to the copies."""
        root = self._whole.copy_foreign(source.Root.StructTreeRoot)
        document = root.K[0] if isinstance(root.K, pikepdf.Array) else root.K
        if self._document is None:
            self._document = document
        for child in document.K:
            child.P = self._document
            self._children.append(child)
        for key, value in _numbers(root.ParentTree):
            self._parents.extend([key + self._key, value])
        for page in copied:
            for thing in (page.obj, *page.obj.get("/Annots", [])):
                for name in ("/StructParents", "/StructParent"):
                    if name in thing:
                        thing[name] = int(thing[name]) + self._key
        self._key += int(root.ParentTreeNextKey)
        self._spaces.extend(root.get("/Namespaces", []))

    def finish(self) -> None:
        """Put the root into the document."""
        self._document.K = self._children
        entries = {"/ParentTree": pikepdf.Dictionary(Nums=self._parents), "/ParentTreeNextKey": self._key}
        kind = {"/Type": pikepdf.Name.StructTreeRoot, "/K": self._document, "/Namespaces": self._spaces}
        self._whole.Root.StructTreeRoot = self._whole.make_indirect(pikepdf.Dictionary({**kind, **entries}))
        self._document.P = self._whole.Root.StructTreeRoot
        self._whole.Root.MarkInfo = pikepdf.Dictionary(Marked=True)


def _numbers(tree: Any) -> Iterator[tuple[int, Any]]:
    for kid in tree.get("/Kids", []):
        yield from _numbers(kid)
    flat = list(tree.get("/Nums", []))
    yield from zip(map(int, flat[::2]), flat[1::2], strict=True)


def copied(parts: Sequence[Path], target: Path) -> None:
    """Pages, bookmarks and tags copied by pikepdf."""
    pages(parts, target, tags=True)


WAYS: dict[str, Callable[[Sequence[Path], Path], None]] = {OWN: own, PAGES: pages, COPIED: copied}


def run(options: Options) -> list[Table]:
    """Join parts of all kinds in every way, each in a fresh process."""
    table = Table(
        "Joining parts of five families with all answers",
        (
            "document",
            "way",
            "students",
            "CPU, s",
            "peak, MB",
            "output, MB",
            "bookmarks",
            "elements",
            "same bytes again",
        ),
        "Sheets: parts of 16 students; solutions: one of each student. A process may have 4 GB; where it needs more "
        "there are no numbers. Bookmarks and elements of the structure are counted in the smallest class. Files of 100 "
        "students each would need the memory of that line.",
    )
    with tempfile.TemporaryDirectory(prefix="joining-") as name:
        folder = Path(name)
        for kind, parts in parts_of(folder, 1 if options.quick else _MADE).items():
            if options.quick and kind == SOLUTIONS:
                continue
            for way in (OWN, PAGES) if kind == SHEETS else WAYS:
                failed = False
                for size in (2,) if options.quick else SIZES[:2] if kind == SOLUTIONS else SIZES:
                    ran = None if failed else _joined(way, parts, size, folder / "whole.pdf")
                    failed = ran is None
                    table.add(
                        kind, way, size, *(_row(ran, folder / "whole.pdf", way, parts, size) if ran else [None] * 6)
                    )
    return [table]


def _joined(way: str, parts: Sequence[Path], students: int, target: Path) -> Ran | None:
    """What it takes to join parts for so many students; None where the memory does not suffice."""
    count = max(1, students // _students(parts))
    command = [sys.executable, "-m", "benchmarks.joining", way, str(count), str(target), *map(str, parts)]
    try:
        return processes.run(command)
    except RuntimeError as error:
        if "MemoryError" in str(error) or "bad_alloc" in str(error):
            return None
        raise


def _row(ran: Ran, target: Path, way: str, parts: Sequence[Path], students: int) -> list[Any]:
    """The cells of a result; what is in the file is looked at in small ones only."""
    found: list[Any] = [ran.cpu, ran.main_mb, target.stat().st_size / 1e6]
    if students > min(SIZES):
        return [*found, None, None, None]
    first = hashlib.sha256(target.read_bytes()).digest()
    with pikepdf.open(target) as pdf, pdf.open_outline() as outline:
        count = sum(_elements(pdf.Root.StructTreeRoot)) if "/StructTreeRoot" in pdf.Root else 0
        found += [len(outline.root), count]
    _joined(way, parts, students, target)
    return [*found, "yes" if hashlib.sha256(target.read_bytes()).digest() == first else "no"]


def _elements(root: Any) -> Iterator[int]:
    """One for each element below the root of a structure."""
    waiting = [root]
    while waiting:
        inside = waiting.pop().get("/K", [])
        for child in inside if isinstance(inside, pikepdf.Array) else [inside]:
            if isinstance(child, pikepdf.Dictionary) and "/S" in child:
                yield 1
                waiting.append(child)


def _students(parts: Sequence[Path]) -> int:
    """How many students a part is for."""
    return 1 if parts[0].name.startswith(SOLUTIONS) else STUDENTS_PER_PART


def main(arguments: Sequence[str]) -> None:
    """The work of a measured process."""
    way, count, target, *parts = arguments
    resource.setrlimit(resource.RLIMIT_AS, (_MOST, _MOST))
    _, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))
    found = [Path(part) for part in parts]
    WAYS[way]([found[i % len(found)] for i in range(int(count))], Path(target))


if __name__ == "__main__":
    main(sys.argv[1:])
