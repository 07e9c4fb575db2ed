"""The documents of an exam for a few students: template and data, in the order in which they are made."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from variantgen.exam.blueprint import Exam
from variantgen.exam.sheets import Sheet
from variantgen.outputs.key_data import key_by_problem, key_by_student
from variantgen.outputs.sheet_data import sheets_data
from variantgen.outputs.solution_data import solutions_data


@dataclass(frozen=True)
class Document:
    """What the engine gets; ``target`` is the output that the document is a part of.

    ``unexplained`` names the families of problems that have an answer, but no worked solution. ``tagged`` is one that
    is handed out as it is: the tags of parts are lost when they are joined.
    """

    target: str
    template: str
    data: dict[str, Any]
    unexplained: tuple[str, ...] = ()
    tagged: bool = False


Documents = Callable[[Exam, Sequence[Sheet], bool], Iterator[Document]]


def problem_documents(exam: Exam, sheets: Sequence[Sheet], first: bool) -> Iterator[Document]:
    """The sheets and, if the exam wants them, their solutions, which show the same figures of the problems."""
    data = sheets_data(exam, sheets, first)
    yield Document("sheets", "sheets.typ", data)
    if not exam.solutions.wanted:
        return
    same = exam.solutions.language == exam.language
    known = [student["problems"] for student in data["students"]] if same else []
    # A document for each student: the engine keeps the layouts of its last ones, so larger documents need more memory
    # (560 MB for three students each, 345 MB for one) and save no time.
    alone = exam.solutions.for_students
    for i in range(len(sheets)):
        solved, unexplained = solutions_data(exam, sheets[i : i + 1], known[i : i + 1])
        yield Document("solutions", "solutions.typ", solved, unexplained, alone)


def student_key(exam: Exam, sheets: Sequence[Sheet], first: bool) -> Iterator[Document]:
    """The key by student."""
    yield Document("key", "key.typ", key_by_student(exam, sheets, first))


def problem_key(exam: Exam, sheets: Sequence[Sheet], first: bool) -> Iterator[Document]:
    """The key by problem."""
    yield Document("key", "key.typ", key_by_problem(exam, sheets, first))
