"""Sheets, key and worked solutions as pages of HTML that need nothing else: for the screen, a telephone and paper."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from msgspec import Struct

from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.outputs import formats
from variantgen.outputs.documents.key_content import KeyTable, Place, key_tables, place, remarks
from variantgen.outputs.documents.solution_data import solution_words
from variantgen.outputs.files.student_groups import GROUPS, GroupFiles, by_group, parts_of
from variantgen.outputs.formats import PARTS_PER_OVERVIEW, STUDENTS_PER_OVERVIEW, Chunk, Fragment, WholeExam
from variantgen.outputs.html.articles import page_writing, problem_keys, sheet_article, solution_article, student_key
from variantgen.outputs.html.pages import pieces, write_page
from variantgen.tables import Table
from variantgen.wording.language import Language

HELP = "html/sheets.html, key.html, solutions.html: pages for the screen, or a page per student or group"
FILES = (
    "html/sheets.html",
    "html/key.html",
    "html/solutions.html",
    "html/index.html",
    "html/sheets/*.html",
    "html/key/*.html",
    "html/solutions/*.html",
)
TARGETS = "sheets|key|solutions|rows-.*"
JOINED, STUDENTS = "joined", "students"
_FEW = 3  # students whose page needs no contents


class HtmlOptions(Struct, frozen=True):
    """What an exam file may say of pages: one for all (``joined``), or for each of the ``students`` or ``groups``."""

    files: str = JOINED


def read_options(table: Table) -> HtmlOptions:
    """The table ``[html]``."""
    found = HtmlOptions(table.choice("files", (JOINED, STUDENTS, GROUPS)))
    table.finish()
    return found


def check(exam: Exam, students: Sequence[Student]) -> None:
    """Nothing is needed that the program has not."""


def make(part: Chunk) -> Iterator[Fragment]:
    """An article for each student and document."""
    for number in range(len(part.sheets)):
        yield Fragment("sheets", sheet_article(part.content, number), ".html")
        if part.exam.solutions.wanted:
            yield Fragment("solutions", solution_article(part.content, number), ".html")


def _student_key(part: Chunk) -> Iterator[Fragment]:
    """The key by student."""
    for sheets, _ in part.key_parts(_files(part.exam) == GROUPS):
        yield Fragment("key", student_key(part.exam, sheets), ".html")


def _problem_key(part: Chunk) -> Iterator[Fragment]:
    """The key by problem: rows of each table."""
    for sheets, _ in part.key_parts(_files(part.exam) == GROUPS):
        for where, rows in problem_keys(part.exam, sheets):
            yield Fragment(_rows(where), rows, ".html")


def _files(exam: Exam) -> str:
    found: HtmlOptions = formats.options(exam, "html")
    return found.files


SUMMARIES = ((PARTS_PER_OVERVIEW, _student_key), (PARTS_PER_OVERVIEW, _problem_key))


def _rows(where: Place) -> str:
    """The target of the rows of a table."""
    return "-".join(("rows", *map(str, where)))


class _Document(Struct, frozen=True):
    """A document that all students have: what its pieces are called, its language, how a page of it is headed."""

    target: str
    language: Language
    heading: str


def _documents(exam: Exam) -> Iterator[_Document]:
    yield _Document("sheets", exam.spoken, exam.title)
    if exam.solutions.wanted:
        words = solution_words(exam.explained)
        yield _Document("solutions", exam.explained, f"{words['solutions']}: {exam.title}")


def finish(whole: WholeExam) -> None:
    """Write the pages."""
    folder, documents = whole.folder / "html", list(_documents(whole.exam))
    write_key(whole)
    if _files(whole.exam) == GROUPS:
        _write_groups(whole, documents, folder)
        return
    single = _files(whole.exam) == STUDENTS
    for document in documents:
        paths, target = whole.pieces[document.target], folder / document.target
        if single:
            target.mkdir()
            for sheet, path in zip(whole.sheets, paths, strict=True):
                _write(whole.exam, document, target / f"{sheet.code}.html", [sheet], [path])
        else:
            _write(whole.exam, document, target.with_suffix(".html"), whole.sheets, paths)
    if single:
        _write_index(whole, [document.target for document in documents], folder / "index.html")


def _write(exam: Exam, document: _Document, path: Path, sheets: Sequence[Sheet], paths: Sequence[Path]) -> None:
    """A page with the articles of some students."""
    write_page(
        path,
        "students.html.j2",
        **_common(exam, document.language, document.heading),
        students=[_listed(sheet) for sheet in sheets],
        contents=len(sheets) > _FEW,
        duplex=exam.duplex,
        pieces=pieces(paths),
    )


def write_key(whole: WholeExam) -> None:
    """The key of the class, or that of each group."""
    folder = whole.folder / "html"
    folder.mkdir()
    if _files(whole.exam) != GROUPS:
        every = {where: whole.pieces[_rows(where)] for where in _tables(whole)}
        _write_key(whole, folder / "key.html", whole.pieces["key"], every)
        return
    found = GroupFiles.of(sheet.student.group for sheet in whole.sheets)
    keys, rows = found.of_parts(whole.pieces["key"], STUDENTS_PER_OVERVIEW), _rows_of_groups(whole)
    (folder / "key").mkdir()
    for group in found.places:
        _write_key(whole, folder / "key" / f"{found.stems[group]}.html", keys[group], rows[group], group)


def _write_groups(whole: WholeExam, documents: Sequence[_Document], folder: Path) -> None:
    """Pages for each group, and a list of them."""
    found = GroupFiles.of(sheet.student.group for sheet in whole.sheets)
    for target in (document.target for document in documents):
        (folder / target).mkdir()
    for group, places in found.places.items():
        for document in documents:
            paths, path = [whole.pieces[document.target][i] for i in places], f"{found.stems[group]}.html"
            _write(whole.exam, document, folder / document.target / path, [whole.sheets[i] for i in places], paths)
    exam, language = whole.exam, whole.exam.spoken
    write_page(
        folder / "index.html",
        "groups.html.j2",
        **_common(exam, language, exam.title),
        key=language.words("key"),
        targets=[document.target for document in documents],
        groups=[{"name": group, "stem": found.stems[group], "count": len(own)} for group, own in found.places.items()],
    )


def _rows_of_groups(whole: WholeExam) -> dict[str, dict[Place, list[Path]]]:
    """The pieces of the tables of each group."""
    found: dict[str, dict[Place, list[Path]]] = {}
    rest: dict[Place, Iterator[Path]] = {}
    for part in parts_of(whole.sheets, STUDENTS_PER_OVERVIEW):
        for group, own in by_group(part).items():
            for where in {place(item): None for sheet in own for item in sheet.items}:
                paths = rest.setdefault(where, iter(whole.pieces[_rows(where)]))
                found.setdefault(group, {}).setdefault(where, []).append(next(paths))
    return found


def _tables(whole: WholeExam) -> dict[Place, KeyTable]:
    """The tables of the key, in their order."""
    return key_tables(whole.sheets, whole.exam, whole.exam.spoken)


def _write_key(
    whole: WholeExam, path: Path, students: Sequence[Path], rows: Mapping[Place, Sequence[Path]], group: str = ""
) -> None:
    """The key of the class or of a group: by student, then a table for each problem."""
    exam, language = whole.exam, whole.exam.spoken
    words = language.words("key")
    tables = [
        {
            "title": table.title,
            "form": table.form,
            "heads": [page_writing().heading(*head) for head in table.heads],
            "pieces": pieces(rows[where]),
        }
        for where, table in _tables(whole).items()
        if where in rows
    ]
    write_page(
        path,
        "key.html.j2",
        **_common(exam, language, f"{words['title']}: {exam.title}" + (f" ({group})" if group else "")),
        key=words,
        remarks=remarks(exam, language),
        pieces=pieces(students),
        tables=tables,
    )


def _write_index(whole: WholeExam, targets: Sequence[str], path: Path) -> None:
    """The students with links to their pages."""
    exam, language = whole.exam, whole.exam.spoken
    write_page(
        path,
        "index.html.j2",
        **_common(exam, language, exam.title),
        key=language.words("key"),
        targets=targets,
        students=[_listed(sheet) for sheet in whole.sheets],
    )


def _common(exam: Exam, language: Language, heading: str) -> dict[str, Any]:
    """What every page says of itself."""
    return {"lang": language.name, "heading": heading, "course": exam.course, "words": language.words("html")}


def _listed(sheet: Sheet) -> dict[str, str]:
    """A student in a list."""
    student = sheet.student
    return {"code": sheet.code, "name": student.name or student.id, "group": student.group}
