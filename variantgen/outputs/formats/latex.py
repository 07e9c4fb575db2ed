"""Sheets, key and worked solutions as LaTeX sources for editing, and as the PDFs made of them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, cast, get_args

from msgspec import Struct

from variantgen.errors import InputError, Problem, ToolMissingError, missing_package, nearest
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.outputs.documents.key_data import key_by_problem, key_by_student
from variantgen.outputs.documents.sheet_data import sheets_data
from variantgen.outputs.documents.solution_data import solution_words, solutions_data
from variantgen.outputs.files.student_groups import GROUPS, GroupFiles, documents
from variantgen.outputs.formats import (
    PARTS_PER_OVERVIEW,
    Chunk,
    Fragment,
    WholeExam,
    options,
)
from variantgen.outputs.latex.characters import Alphabet, Engine, alphabet, is_right_to_left, named, unprintable
from variantgen.outputs.latex.compiling import MissingGlyphsError, compile_document, how_to_install, missing
from variantgen.outputs.latex.document import Look, write_document
from variantgen.outputs.latex.templates import fill
from variantgen.outputs.latex.writing import LatexWriting
from variantgen.tables import Table, shown

HELP = "latex/sheets.tex, key.tex, solutions.tex for editing, and their PDFs where LaTeX is installed"
FILES = tuple(
    f"latex/{name}{more}.{ending}"
    for name in ("sheets", "key", "solutions")
    for more in ("", "/*")
    for ending in ("tex", "pdf")
)
TARGETS = "sheets|key|solutions"
_FONT = re.compile(r"[A-Za-z0-9][A-Za-z0-9 ._-]{0,80}")


class LatexOptions(Struct, frozen=True):
    """What an exam file may say of LaTeX.

    ``compile`` is None where PDFs are made if the engine is installed; ``font`` is one of LuaLaTeX.
    ``files``: documents for the class, or for each group.
    """

    compile: bool | None = None
    engine: Engine = "pdflatex"
    font: str = ""
    files: str = "joined"


def read_options(table: Table) -> LatexOptions:
    """The table ``[latex]``; mistakes are noted in it."""
    wanted = table.take("compile", bool, True) if "compile" in table.data else None
    table.expect("compile")
    engine = table.take("engine", str, "pdflatex")
    if engine not in get_args(Engine):
        table.problem("unknown engine", "engine", engine, nearest(engine, get_args(Engine)))
        engine = "pdflatex"
    font = table.take("font", str, "")
    if font and not _FONT.fullmatch(font):
        table.problem("expected the name of a font", "font", font, 'like "CMU Serif"')
        font = ""
    elif font and engine == "pdflatex":
        table.problem("pdflatex has fonts of its own", "font", font, 'add  engine = "lualatex"')
    files = table.choice("files", ("joined", GROUPS))
    table.finish()
    return LatexOptions(wanted, cast(Engine, engine), font, files)


def check(exam: Exam, students: Sequence[Student]) -> None:
    """Raise ToolMissingError without PyLaTeX or a demanded LaTeX, InputError for titles that cannot be printed."""
    try:
        import pylatex  # noqa: F401  (found here, so that the message comes before any work)
    except ImportError:
        raise missing_package("LaTeX output needs", "PyLaTeX", "latex") from None
    chosen = _options(exam)
    if chosen.compile and missing(chosen.engine):
        raise ToolMissingError(f"[latex] compile = true: {how_to_install(chosen.engine)}")
    problems = [
        _unprintable(found, where, text, chosen.engine)
        for where, text in _texts(exam, students)
        if (found := unprintable(text, chosen.engine))
    ]
    if problems:
        raise InputError(problem.located(str(exam.path)) for problem in problems)


def make(part: Chunk) -> Iterator[Fragment]:
    """The sheets and, if the exam wants them, the solutions of a few students."""
    exam = part.exam
    writing = _writing(exam, exam.language)
    data = sheets_data(part.content, writing, built=True)
    for own in documents(data, part.sheets) if _options(exam).files == GROUPS else [data]:
        yield Fragment("sheets", fill("sheets.tex.j2", own, writing.alphabet).encode(), ".tex")
    if not exam.solutions.wanted:
        return
    writing = _writing(exam, exam.solutions.language)
    for number in range(len(part.sheets)):
        solved = solutions_data(part.content, number, writing)
        yield Fragment("solutions", fill("solutions.tex.j2", solved, writing.alphabet).encode(), ".tex")


def _student_key(part: Chunk) -> Iterator[Fragment]:
    """The key by student."""
    writing = _writing(part.exam, part.exam.language)
    for sheets, first in part.key_parts(_options(part.exam).files == GROUPS):
        data = key_by_student(part.exam, sheets, first, writing)
        yield Fragment("key", fill("key.tex.j2", data, writing.alphabet).encode(), ".tex")


def _problem_key(part: Chunk) -> Iterator[Fragment]:
    """The key by problem."""
    writing = _writing(part.exam, part.exam.language)
    for sheets, first in part.key_parts(_options(part.exam).files == GROUPS):
        data = key_by_problem(part.exam, sheets, first, writing)
        yield Fragment("key", fill("key.tex.j2", data, writing.alphabet).encode(), ".tex")


SUMMARIES = ((PARTS_PER_OVERVIEW, _student_key), (PARTS_PER_OVERVIEW, _problem_key))


def finish(whole: WholeExam) -> None:
    """Put the pieces into documents and compile them."""
    _write_documents(whole)


def write_key(whole: WholeExam) -> None:
    """The key alone: its pieces are all that there are."""
    _write_documents(whole)


def _write_documents(whole: WholeExam) -> None:
    """The documents of which there are pieces."""
    exam, chosen = whole.exam, _options(whole.exam)
    folder = whole.folder / "latex"
    folder.mkdir()
    sources = list(_sources(whole, folder))
    for source in sources:
        source.path.parent.mkdir(exist_ok=True)
        write_document(source.path, _look(exam, source.kind), source.pieces, _head_data(exam, source.kind))
    if chosen.compile is None and missing(chosen.engine):
        whole.notes.append(f"LaTeX sources only, no PDFs of them: {how_to_install(chosen.engine)}")
    elif chosen.compile is not False:
        for source in sources:
            _compile(whole, source)


class _Source(Struct, frozen=True):
    """A document: its file, what kind it is, its pieces, for how many students it is."""

    path: Path
    kind: str
    pieces: Sequence[Path]
    students: int


def _sources(whole: WholeExam, folder: Path) -> Iterator[_Source]:
    """The documents of the class, or those of each group."""
    if _options(whole.exam).files != GROUPS:
        for kind, pieces in whole.pieces.items():
            yield _Source(folder / f"{kind}.tex", kind, pieces, len(whole.sheets))
        return
    groups = GroupFiles.of(sheet.student.group for sheet in whole.sheets)
    for kind in whole.pieces:
        for group, own in whole.of_groups(kind, groups).items():
            yield _Source(folder / kind / f"{groups.stems[group]}.tex", kind, own, len(groups.places[group]))


def _compile(whole: WholeExam, source: _Source) -> None:
    """Make the PDF beside a source."""
    title, look, path = whole.exam.title, _look(whole.exam, source.kind), source.path
    try:
        compile_document(path, path.with_suffix(".pdf"), look.engine, title, look.language, source.students)
    except MissingGlyphsError as error:
        letters = set(error.letters)
        problems = [
            _unprintable(sorted(found), where, text, look.engine)
            for where, text in _texts(whole.exam, [sheet.student for sheet in whole.sheets])
            if (found := letters & set(text))
        ]
        if not problems:
            raise
        raise InputError(problems) from None


def _texts(exam: Exam, students: Sequence[Student]) -> Iterator[tuple[str, str]]:
    """What comes from outside, with where it stands."""
    yield "title", exam.title
    yield "course", exam.course
    yield from exam.notices.words
    for student in students:
        yield f"student {student.id}", student.name or student.id
        yield f"group of student {student.id}", student.group


def _unprintable(letters: list[str], where: str, text: str, engine: Engine) -> Problem:
    """The message for characters that no font has."""
    remedy = "leave the characters out, or latex out of the formats"
    if engine == "pdflatex" and not any(map(is_right_to_left, letters)):
        remedy = f'write  engine = "lualatex"  and  font = "..."  (a font that has them) under [latex], or {remedy}'
    elif engine == "lualatex" and not any(map(is_right_to_left, letters)):
        remedy = f'write  font = "..."  (a font that has them) under [latex], or {remedy}'
    return Problem(f"{engine} cannot print {named(letters)}", key=where, value=shown(text), remedy=remedy)


def _options(exam: Exam) -> LatexOptions:
    return cast(LatexOptions, options(exam, "latex"))


def _writing(exam: Exam, language: str) -> LatexWriting:
    """How the documents of a language are written."""
    return LatexWriting(_alphabet(exam, language))


def _alphabet(exam: Exam, language: str) -> Alphabet:
    return alphabet(language, _options(exam).engine)


def _look(exam: Exam, kind: str) -> Look:
    """The look of a document."""
    language = exam.solutions.language if kind == "solutions" else exam.language
    chosen = _options(exam)
    return Look(kind, language, chosen.engine, chosen.font, _alphabet(exam, language))


def _head_data(exam: Exam, kind: str) -> Mapping[str, Any]:
    """What the definitions of a document say."""
    if kind == "key":
        words: Mapping[str, str] = exam.spoken.words("key")
    elif kind == "solutions":
        words = solution_words(exam.explained)
    else:
        words = exam.spoken.words("sheet")
    coded = kind == "sheets" and exam.qr
    return {"words": dict(words), "duplex": exam.duplex, "title": exam.title, "coded": coded}
