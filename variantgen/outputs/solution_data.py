"""Worked solutions as data for ``solutions.typ``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from variantgen.errors import InputError
from variantgen.exam.blueprint import Exam
from variantgen.exam.sheets import Sheet, solve_all
from variantgen.outputs.sheet_data import statement_data, student_data, text_data
from variantgen.outputs.solution_blocks import blocks_data
from variantgen.outputs.solution_figures import Figures, view_order
from variantgen.variants.attempts import VerificationError
from variantgen.wording.language import Language
from variantgen.wording.solution.document import Section, SolutionText
from variantgen.wording.solution.explain import UnexplainedError, answers_only, explain
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.statement import statement

_WORDS = ("plan", "answer", "check", "solutions")
Problem = dict[str, Any]


def solutions_data(
    exam: Exam, sheets: Sequence[Sheet], known: Sequence[Sequence[Problem]] = ()
) -> tuple[dict[str, Any], tuple[str, ...]]:
    """Data for ``solutions.typ``, and the families of problems of which there is only the answer.

    ``known`` are the problems of each student as they stand on the sheets, if these are in the same language.
    """
    language = exam.explained
    items = [item for sheet in sheets for item in sheet.items]
    solved = iter(solve_all([item.variant for item in items], [item.asked for item in items]))
    unexplained: list[str] = []
    students = []
    for number, sheet in enumerate(sheets):
        problems = []
        on_sheet = known[number] if known else [None] * len(sheet.items)
        for item, problem in zip(sheet.items, on_sheet, strict=True):
            motion, place = next(solved)
            try:
                text = explain(item.variant, motion, place, item.asked, language, exam.wish(item.task))
            except InputError as error:
                where = f"problem[{item.task.number}]."
                raise InputError(replace(p, file=str(exam.path), key=where + p.key) for p in error.problems) from None
            except VerificationError as error:
                where = f"student {sheet.student.id}, problem {item.task.number}"
                raise VerificationError(f"{error} ({where})") from error
            except UnexplainedError:
                unexplained.append(item.variant.family.name)
                text = answers_only(item.variant, motion, place, item.asked, language)
            known_figure = problem and problem["figure"]
            figures = Figures(item.variant, item.asked, language, (motion, place), known_figure, text.centres)
            problems.append({"number": str(item.task.number), **problem_data(figures, text, problem)})
        students.append(student_data(sheet, problems, language, sheet is sheets[-1]))
    data = {
        "lang": language.name,
        "title": exam.title,
        "course": exam.course,
        "duplex": exam.duplex,
        "words": solution_words(language),
        "students": students,
    }
    return data, tuple(unexplained)


def solution_words(language: Language) -> dict[str, str]:
    """The fixed words of a document with solutions."""
    words = load_phrases(language.name).words
    return {**language.words("sheet"), **{name: words[name] for name in _WORDS}}


def problem_data(figures: Figures, text: SolutionText, known: Problem | None = None) -> dict[str, Any]:
    """One problem with its figures and its solution; ``known`` is the problem on a sheet in the same language."""
    variant, language = figures.variant, figures.language
    said = known or statement_data(statement(variant, figures.asked, language))
    figures.draw(view_order(text))
    return {
        "title": variant.family.title(language.name),
        **{part: said[part] for part in ("text", "given", "asked")},
        "figures": figures.rows(),
        "plan": text_data(text.plan),
        "sections": [_section(section, figures, language) for section in text.sections],
        "answer": text_data(text.answer),
        "check": blocks_data(text.check),
    }


def _section(section: Section, figures: Figures, language: Language) -> dict[str, Any]:
    """A numbered step; ``see`` tells the figures that go with it."""
    numbers = [str(figures.numbers[name]) for name in section.views if name in figures.numbers]
    word = load_phrases(language.name).words["see"]
    return {
        "heading": text_data(section.heading),
        "see": f"({word}\N{NO-BREAK SPACE}{', '.join(numbers)})" if numbers else "",
        "blocks": blocks_data(section.blocks),
    }
