"""Sheets, key and worked solutions as PDF, by the embedded typesetting engine."""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from variantgen.exam.blueprint import Exam
from variantgen.exam.sheets import Sheet
from variantgen.outputs.formats import Part, Piece, Whole
from variantgen.outputs.join import join_pdfs
from variantgen.outputs.key_data import key_by_problem, key_by_student
from variantgen.outputs.sheet_data import sheets_data
from variantgen.outputs.solution_data import solutions_data
from variantgen.tables import Table

HELP = "sheets.pdf, key.pdf, solutions.pdf, by the embedded engine"
FILES = ("sheets.pdf", "key.pdf", "solutions.pdf", "solutions/*.pdf")
KEYS_PER_PART = 40


@dataclass(frozen=True)
class Options:
    """What an exam file may say of PDFs."""


def read_options(table: Table) -> Options:
    """The table ``[pdf]``."""
    table.finish()
    return Options()


def check(exam: Exam) -> None:
    """Nothing is needed but the engine, which every build has."""


def make(part: Part) -> Iterator[Piece]:
    """The sheets and, if the exam wants them, the solutions of a few students."""
    figures: dict[int, Any] = {}
    data = sheets_data(part.content, figures, part.seed)
    yield part.piece("sheets", part.engine.compile("sheets.typ", data, tagged=False)[0], ".pdf")
    if not part.exam.solutions.wanted:
        return
    # A document for each student: the engine keeps the layouts of its last ones, so larger documents need more memory
    # (560 MB for three students each, 345 MB for one) and save no time. The tags of parts are lost when they are
    # joined, so only those handed out as they are have them.
    tagged = part.exam.solutions.for_students
    for number in range(len(part.sheets)):
        solved = solutions_data(part.content, number, figures)
        yield part.piece("solutions", part.engine.compile("solutions.typ", solved, tagged=tagged)[0], ".pdf")


def _student_key(part: Part) -> Iterator[Piece]:
    """The key by student."""
    data = key_by_student(part.exam, part.sheets, part.first)
    yield part.piece("key", part.engine.compile("key.typ", data, tagged=False)[0], ".pdf")


def _problem_key(part: Part) -> Iterator[Piece]:
    """The key by problem."""
    data = key_by_problem(part.exam, part.sheets, part.first)
    yield part.piece("key", part.engine.compile("key.typ", data, tagged=False)[0], ".pdf")


SUMMARIES = ((KEYS_PER_PART, _student_key), (KEYS_PER_PART, _problem_key))


def finish(whole: Whole) -> None:
    """Join the parts."""
    exam = whole.exam
    for target, paths in whole.pieces.items():
        language = exam.solutions.language if target == "solutions" else exam.language
        even = exam.duplex and target != "key"
        join_pdfs(paths, whole.folder / f"{target}.pdf", exam.title, language, even)
    if exam.solutions.for_students:
        _hand_out(whole.sheets, whole.pieces["solutions"], whole.folder / "solutions")


def _hand_out(sheets: Sequence[Sheet], parts: Sequence[Path], folder: Path) -> None:
    """One file for each student, named by the code of the sheet."""
    folder.mkdir()
    for sheet, part in zip(sheets, parts, strict=True):
        shutil.copyfile(part, folder / f"{sheet.code}.pdf")
