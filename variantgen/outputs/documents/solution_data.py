"""Worked solutions as data for ``solutions.typ``."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from variantgen.exam.content import Content, SolvedProblem
from variantgen.exam.solution_figures import SolutionFigure
from variantgen.outputs.documents.sheet_data import exam_data, sheet_notes, statement_data, student_data
from variantgen.outputs.documents.solution_blocks import blocks_data
from variantgen.outputs.documents.writing import Writing
from variantgen.wording.language import Language
from variantgen.wording.solution.document import Section
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.text import with_steady_letters, with_symbols

_WORDS = ("plan", "answer", "check", "solutions")
Problem = dict[str, Any]


def solutions_data(
    content: Content, number: int, writing: Writing, figures: dict[int, Any] | None = None
) -> dict[str, Any]:
    """Data for templates of documents with the solutions of one student.

    ``figures`` are drawings that have been made data before, by their ids.
    """
    exam, sheet = content.exam, content.sheets[number]
    language = exam.explained
    notes = sheet_notes(sheet, language)
    problems = [
        {"number": str(item.task.number), **problem_data(solved, language, writing, figures)}
        for item, solved in zip(sheet.items, content.solved[number], strict=True)
    ]
    return {
        **exam_data(exam, language),
        "words": solution_words(language),
        "students": [{**student_data(sheet, problems, language), "notes": notes_data(notes, writing), "last": True}],
    }


def notes_data(notes: Sequence[str], writing: Writing) -> list[Any]:
    """The conventions of signs and letters, with their letters as in formulas."""
    return [writing.text(with_symbols(note)) for note in notes]


def solution_words(language: Language) -> dict[str, str]:
    """The fixed words of a document with solutions."""
    words = load_phrases(language.name).words
    return {**language.words("sheet"), **{name: words[name] for name in _WORDS}}


def problem_data(
    solved: SolvedProblem, language: Language, writing: Writing, figures: dict[int, Any] | None = None
) -> dict[str, Any]:
    """One problem and its solution; each figure but that of the statement is in the first step that names it."""
    text = solved.text
    first, *others = [_shown(shown, figures or {}, writing) for row in solved.rows for shown in row]
    sections = [_section(section, solved, language, writing) for section in text.sections]
    free = dict(enumerate(others, start=2))
    for section in sections:
        own = [number for number in free if number in section["shows"] or section is sections[-1]]
        section["figures"] = [free.pop(number) for number in own]
    return {
        "title": solved.variant.family.title(language.name),
        **statement_data(solved.statement, writing),
        "figure": first,
        "plan": writing.text(text.plan),
        "sections": sections,
        "answer": writing.text(text.answer),
        "check": blocks_data(text.check, writing),
    }


def _shown(shown: SolutionFigure, figures: dict[int, Any], writing: Writing) -> dict[str, Any]:
    drawn = figures.get(id(shown.drawing)) or writing.figure(shown.drawing, shown.caption)
    return {"caption": writing.text(shown.caption), "figure": drawn, "unit": shown.unit, "least": shown.least}


def _section(section: Section, solved: SolvedProblem, language: Language, writing: Writing) -> dict[str, Any]:
    """A numbered step; ``shows`` are the numbers of the figures that go with it, ``see`` the same in parentheses."""
    shows = [solved.numbers[name] for name in section.views if name in solved.numbers]
    numbers = [str(number) for number in shows]
    word = load_phrases(language.name).words["see"]
    return {
        "heading": writing.text(with_steady_letters(section.heading)),
        "see": f"({word}\N{NO-BREAK SPACE}{', '.join(numbers)})" if numbers else "",
        "shows": shows,
        "blocks": blocks_data(section.blocks, writing),
    }
