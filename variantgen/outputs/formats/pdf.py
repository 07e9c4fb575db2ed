"""Sheets, key and worked solutions as PDF, by the embedded typesetting engine."""

from __future__ import annotations

import shutil
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.outputs.documents.key_data import key_by_problem, key_by_student
from variantgen.outputs.documents.sheet_data import group_text, sheets_data, who
from variantgen.outputs.files.file_names import file_stem
from variantgen.outputs.files.student_groups import GroupFiles, documents
from variantgen.outputs.formats import (
    PARTS_PER_OVERVIEW,
    Chunk,
    Fragment,
    WholeExam,
    options,
)
from variantgen.outputs.pdf_options import PdfOptions, read_options
from variantgen.outputs.typst.answer_pages import with_answer_pages
from variantgen.outputs.typst.coverage import check_letters
from variantgen.outputs.typst.sheet_pages import with_pages
from variantgen.outputs.typst.writing import TYPST

if TYPE_CHECKING:
    from variantgen.outputs.pdf.bookmarks import BookmarkName

__all__ = ["FILES", "HELP", "SUMMARIES", "PdfOptions", "check", "finish", "make", "read_options"]

HELP = "sheets.pdf, key.pdf, solutions.pdf, by the embedded engine"
FILES = ("sheets.pdf", "key.pdf", "solutions.pdf", "sheets/*.pdf", "key/*.pdf", "solutions/*.pdf")
TARGETS = "sheets|key|solutions"


def check(exam: Exam, students: Sequence[Student]) -> None:
    """Raise InputError for letters that no font has; nothing is needed but the engine, which every build has."""
    check_letters(exam, students)


def make(part: Chunk) -> Iterator[Fragment]:
    """The sheets and, if the exam wants them, the solutions of a few students."""
    chosen = _options(part.exam)
    figures: dict[int, Any] = {}
    data = with_pages(sheets_data(part.content, TYPST, figures, built=True), part.engine)
    if part.exam.scan:
        data = with_answer_pages(data, part.content)
    own = [data]
    if chosen.for_students:
        own = [{**data, "students": [{**student, "last": True}]} for student in data["students"]]
    elif chosen.for_groups:
        own = list(documents(data, part.sheets))
    for document in own:
        yield _piece(part, "sheets", document, chosen.for_students)
    if not part.exam.solutions.wanted:
        return
    from variantgen.outputs.documents.solution_data import solutions_data

    # A document for each student: the engine keeps the layouts of its last ones, so larger documents need more memory
    # (560 MB for three students each, 345 MB for one) and save no time.
    for number in range(len(part.sheets)):
        data = solutions_data(part.content, number, TYPST, figures)
        yield _piece(part, "solutions", data, _are_handed_out(part.exam))


def _piece(part: Chunk, target: str, data: Mapping[str, Any], handed_out: bool = False) -> Fragment:
    """A document of a part. It has tags if a standard wants them, or if it is handed out as it is."""
    chosen = _options(part.exam)
    tagged = chosen.tagged or handed_out
    template = "key.typ" if target == "key" else f"{target}.typ"
    made = part.engine.compile(template, data, tagged=tagged, standards=chosen.standards)
    return Fragment(target, made[0], ".pdf")


def _student_key(part: Chunk) -> Iterator[Fragment]:
    """The key by student."""
    for sheets, first in part.key_parts(_options(part.exam).for_groups):
        yield _piece(part, "key", key_by_student(part.exam, sheets, first, TYPST))


def _problem_key(part: Chunk) -> Iterator[Fragment]:
    """The key by problem."""
    for sheets, first in part.key_parts(_options(part.exam).for_groups):
        yield _piece(part, "key", key_by_problem(part.exam, sheets, first, TYPST))


SUMMARIES = ((PARTS_PER_OVERVIEW, _student_key), (PARTS_PER_OVERVIEW, _problem_key))


def finish(whole: WholeExam) -> None:
    """Join the parts, and hand out those of single students."""
    # Here, so that commands that write no PDF do not wait for the library.
    from variantgen.outputs.join import join_pdfs, page_counts
    from variantgen.outputs.pdf.bookmarks import BookmarkName

    exam, chosen = whole.exam, _options(whole.exam)
    names = [BookmarkName(who(s, exam.spoken), group_text(s.student, exam.spoken)) for s in whole.sheets]
    write_key(whole)
    for target, paths in whole.pieces.items():
        if target != "key":
            if chosen.joined:
                language = exam.solutions.language if target == "solutions" else exam.language
                joined = whole.folder / f"{target}.pdf"
                lengths = join_pdfs(paths, joined, exam.title, language, exam.duplex, names, whole.run)
            else:
                lengths = page_counts(paths, whole.run)
            whole.pages[target] = _on_paper(lengths, exam.duplex)
            whole.notes.append(f"{target}.pdf: {_said(lengths, exam.duplex)}")
    if chosen.for_groups:
        _join_groups(whole, [target for target in whole.pieces if target != "key"], names)
    if chosen.for_students:
        _hand_out(whole.sheets, whole.pieces["sheets"], whole.folder / "sheets", chosen)
    if _are_handed_out(exam):
        _hand_out(whole.sheets, whole.pieces["solutions"], whole.folder / "solutions", chosen)


def _on_paper(lengths: Sequence[int], duplex: bool) -> dict[int, int]:
    """How many students have so many pages, from the pages of each.

    Printed on both sides, an odd number takes a blank page more, which the last student of all does without.
    """
    found = Counter(pages + pages % 2 if duplex else pages for pages in lengths)
    return {pages: found[pages] for pages in sorted(found)}


def _said(lengths: Sequence[int], duplex: bool) -> str:
    """How many pages students have, in words, the blank ones apart."""
    found = Counter(lengths)
    words = {pages: f"{pages} {'page' if pages == 1 else 'pages'}" for pages in sorted(found)}
    if len(found) == 1:
        said = f"{words.popitem()[1]} for each student"
    else:
        said = ", ".join(f"{count} for {found[pages]} of the students" for pages, count in words.items())
    is_odd = any(pages % 2 for pages in found)
    return f"{said}; a blank one behind an odd number (duplex)" if duplex and is_odd else said


def write_key(whole: WholeExam) -> None:
    """Join the parts of the key of the class, or of each group."""
    from variantgen.outputs.join import join_pdfs

    exam = whole.exam
    if _options(exam).for_groups:
        _join_groups(whole, ["key"], [])
    else:
        key = whole.folder / "key.pdf"
        join_pdfs(whole.pieces["key"], key, exam.title, exam.language, False, run=whole.run)


def _join_groups(whole: WholeExam, targets: Sequence[str], names: Sequence[BookmarkName]) -> None:
    """Files for each group; they are named by it, so bookmarks do without."""
    from variantgen.outputs.join import join_pdfs

    exam, groups = whole.exam, GroupFiles.of(sheet.student.group for sheet in whole.sheets)
    for target in targets:
        (whole.folder / target).mkdir(exist_ok=True)
        language = exam.solutions.language if target == "solutions" else exam.language
        for group, own in whole.of_groups(target, groups).items():
            path, even = whole.folder / target / f"{groups.stems[group]}.pdf", exam.duplex and target != "key"
            titles = None if target == "key" else [replace(names[place], group="") for place in groups.places[group]]
            join_pdfs(own, path, exam.title, language, even, titles, whole.run)


def _hand_out(sheets: Sequence[Sheet], parts: Sequence[Path], folder: Path, chosen: PdfOptions) -> None:
    """One file for each student."""
    folder.mkdir(exist_ok=True)
    for sheet, part in zip(sheets, parts, strict=True):
        shutil.copyfile(part, folder / f"{file_stem(sheet, chosen.names)}.pdf")


def _are_handed_out(exam: Exam) -> bool:
    """Whether every student gets a file with solutions: ``[solutions] files`` and ``[pdf] files`` may both say so."""
    return exam.solutions.wanted and (exam.solutions.for_students or _options(exam).for_students)


def _options(exam: Exam) -> PdfOptions:
    found: PdfOptions = options(exam, "pdf")
    return found
