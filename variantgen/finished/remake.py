"""One student's sheet again, from the manifest, and whether it is what was handed out.

Where every student has a file, it is made again and its bytes are compared. In a file for the whole class the letters
of several students share their fonts, so the part of the class that the student was in is typeset again, the student's
pages are cut out and compared with those of that file: what is drawn, letter by letter, and the fonts.
"""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from pathlib import Path

from msgspec import Struct

from variantgen.errors import InputError, Problem
from variantgen.exam.content import Content
from variantgen.exam.sheets import Sheet
from variantgen.finished.pdf_comparison import compared, destination, is_used
from variantgen.finished.restore import Finished
from variantgen.outputs.files.file_names import file_stem
from variantgen.outputs.files.student_groups import GroupFiles
from variantgen.outputs.formats import STUDENTS_PER_PART, Chunk, options, pdf
from variantgen.outputs.typst.typesetter import Typesetter

SHEETS, SOLUTIONS = "sheets", "solutions"


class RemadeDocument(Struct, frozen=True):
    """A document of a student made again.

    ``same`` tells with what in the folder it is identical, ``faults`` say what differs; both are empty where there is
    nothing to compare it with.
    """

    stem: str
    content: bytes
    same: str
    faults: tuple[str, ...]


def remake(finished: Finished, place: int, target: str, folder: Path, engine: Typesetter) -> RemadeDocument:
    """The sheet (or the solutions, by ``target``) of the student at a place; ``folder`` holds the finished exam."""
    chosen = options(finished.exam, "pdf")
    alone = chosen.for_students or target == SOLUTIONS
    together = [place] if alone else _typeset_with(finished, place)
    sheets = finished.sheets(together)
    own_place = together.index(place)
    sheet = sheets[own_place]
    faults = list(_answers(finished, place, sheet))
    content = _typeset(finished, sheets, target, engine)
    stem = file_stem(sheet, chosen.names)
    name, inside = _file_of_several(finished, place, target)
    own, joined = folder / target / f"{stem}.pdf", folder / name
    if not alone:
        content = _cut(content, _student_pages(content)[own_place])
    same = ""
    if own.is_file():
        is_same = own.stat().st_size == len(content) and own.read_bytes() == content
        found = [] if is_same else [f"{target}/{own.name} has other bytes"]
        same = "" if found else f"{target}/{own.name}"
        faults += found
    elif joined.is_file():
        pages, found = compared(content, joined, inside, problems_inside=target == SOLUTIONS)
        numbers = f"page {pages.stop}" if len(pages) == 1 else f"pages {pages.start + 1} to {pages.stop}"
        same = "" if found else f"{numbers} of {joined.name}"
        faults += found
    if chosen.standards and not alone:
        # Pages that are cut out have lost their tags: what is handed out is typeset by itself.
        content = _typeset(finished, (sheet,), target, engine)
    return RemadeDocument(stem, content, "" if faults else same, tuple(faults))


def _typeset_with(finished: Finished, place: int) -> list[int]:
    """The students who are typeset together with one: those of a part or, for files of groups, of a group in it."""
    sheets, start = finished.record.sheets, place - place % STUDENTS_PER_PART
    part = range(start, min(start + STUDENTS_PER_PART, len(sheets)))
    if not options(finished.exam, "pdf").for_groups:
        return list(part)
    return [other for other in part if sheets[other].student.group == sheets[place].student.group]


def _file_of_several(finished: Finished, place: int, target: str) -> tuple[Path, int]:
    """The file of the class or of the group that a student is in, in the folder of the exam, and the place there."""
    if not options(finished.exam, "pdf").for_groups:
        return Path(f"{target}.pdf"), place
    groups = GroupFiles.of(sheet.student.group for sheet in finished.record.sheets)
    group = finished.record.sheets[place].student.group
    return Path(target, f"{groups.stems[group]}.pdf"), groups.places[group].index(place)


def _answers(finished: Finished, place: int, sheet: Sheet) -> Iterator[str]:
    """Answers that are not those of the manifest."""
    for item, problem in zip(sheet.items, finished.record.sheets[place].problems, strict=True):
        now = [(a.quantity.name, a.value) for a in item.answers]
        then = [(a.quantity, a.value) for a in problem.answers]
        if now != then:
            yield f"problem {problem.number}: the manifest has the answers {_told(then)}, now they are {_told(now)}"


def _told(answers: Sequence[tuple[str, float]]) -> str:
    return ", ".join(f"{name} = {value:.8g}" for name, value in answers)


def _typeset(finished: Finished, sheets: tuple[Sheet, ...], target: str, engine: Typesetter) -> bytes:
    """The document of some students as a build makes it."""
    part = Chunk(Content(finished.exam, sheets), False, engine)
    for piece in pdf.make(part):
        if piece.target == target:
            return piece.content
    raise InputError(Problem("the exam was built without solutions", key="--solutions", remedy="leave the option out"))


def _student_pages(content: bytes) -> list[range]:
    """The pages of each student of a document: from a bookmark to the next."""
    import pikepdf

    with pikepdf.open(io.BytesIO(content)) as source, source.open_outline() as outline:
        places = {page.obj.objgen: number for number, page in enumerate(source.pages)}
        starts = [places[destination(item).objgen] for item in outline.root]
        return [range(a, b) for a, b in zip(starts, [*starts[1:], len(source.pages)], strict=True)]


def _cut(content: bytes, pages: range) -> bytes:
    """Some pages of a document as one."""
    import pikepdf

    out = io.BytesIO()
    with pikepdf.open(io.BytesIO(content)) as source, pikepdf.new() as made:
        made.pages.extend(source.pages[pages.start : pages.stop])
        while len(made.pages) and not is_used(made.pages[-1]):
            del made.pages[-1]  # left free so that the next student starts on an odd page
        for page in made.pages:
            if "/StructParents" in page.obj:
                del page.obj["/StructParents"]
        made.Root["/Lang"] = source.Root.Lang
        made.docinfo["/Title"] = str(source.docinfo.get("/Title", ""))
        made.save(out, deterministic_id=True, object_stream_mode=pikepdf.ObjectStreamMode.generate)
    return out.getvalue()
