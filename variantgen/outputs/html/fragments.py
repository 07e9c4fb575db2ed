"""Statements and worked solutions as HTML that is XML too, for the texts of learning platforms."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.exam.content import SolvedProblem
from variantgen.exam.exam import Exam
from variantgen.outputs.documents.sheet_data import notices_data, statement_data
from variantgen.outputs.documents.solution_data import problem_data, solution_words
from variantgen.outputs.documents.writing import Writing
from variantgen.outputs.html.pages import fragment
from variantgen.wording.language import Language
from variantgen.wording.statement import Statement


def statement_html(said: Statement, language: Language, writing: Writing) -> str:
    """What a problem says, what is given and what is asked, as paragraphs."""
    return fragment("statement.html.j2", problem=statement_data(said, writing), words=language.words("sheet"))


def notices_html(exam: Exam, writing: Writing) -> str:
    """What an exam says at the head of its sheets, as paragraphs; nothing where it says nothing."""
    return fragment("introduction.html.j2", **notices_data(exam, exam.spoken, writing)) if exam.notices else ""


def notes_html(notes: Sequence[str]) -> str:
    """The conventions of signs as a small paragraph."""
    return fragment("notes.html.j2", notes=notes)


def solution_html(solved: SolvedProblem, language: Language, writing: Writing) -> str:
    """A worked solution: figures, plan, numbered steps, answer, check."""
    problem, words = problem_data(solved, language, writing), solution_words(language)
    return fragment("solved.html.j2", problem=problem, words=words)
