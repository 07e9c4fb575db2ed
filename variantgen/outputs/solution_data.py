"""Worked solutions as data for ``solutions.typ``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from variantgen.errors import InputError
from variantgen.exam.blueprint import Exam
from variantgen.exam.sheets import Sheet, solve_all
from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.outputs.sheet_data import student_data, text_data
from variantgen.outputs.solution_blocks import blocks_data
from variantgen.outputs.solution_figures import Figures, view_order
from variantgen.outputs.typesetter import equals_data
from variantgen.variants.variant import Variant
from variantgen.wording.formula import to_typst
from variantgen.wording.language import Language
from variantgen.wording.solution.document import Section, SolutionText
from variantgen.wording.solution.explain import UnexplainedError, answers_only, explain
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.statement import statement

_WORDS = ("plan", "answer", "check", "solutions")


def solutions_data(exam: Exam, sheets: Sequence[Sheet], first: bool = True) -> dict[str, Any]:
    """Data for ``solutions.typ``; a first part is like the others.

    ``unexplained`` names the problems of which there is only the answer.
    """
    language = exam.explained
    items = [item for sheet in sheets for item in sheet.items]
    solved = iter(solve_all([item.variant for item in items], [item.asked for item in items]))
    unexplained: list[str] = []
    students = []
    for sheet in sheets:
        problems = []
        for item in sheet.items:
            motion, place = next(solved)
            try:
                text = explain(item.variant, motion, place, item.asked, language, exam.wish(item.task))
            except InputError as error:
                where = f"problem[{item.task.number}]."
                raise InputError(replace(p, file=str(exam.path), key=where + p.key) for p in error.problems) from None
            except UnexplainedError:
                unexplained.append(item.variant.family.name)
                text = answers_only(item.variant, motion, place, item.asked, language)
            number = {"number": str(item.task.number)}
            problems.append(number | problem_data(item.variant, item.asked, motion, place, text, language))
        students.append(student_data(sheet, problems, language, sheet is sheets[-1]))
    return {
        "lang": language.name,
        "title": exam.title,
        "course": exam.course,
        "duplex": exam.duplex,
        "words": solution_words(language),
        "students": students,
        "unexplained": unexplained,
    }


def solution_words(language: Language) -> dict[str, str]:
    """The fixed words of a document with solutions."""
    words = load_phrases(language.name).words
    return {**language.words("sheet"), **{name: words[name] for name in _WORDS}}


def problem_data(
    variant: Variant, asked: Sequence[Quantity], motion: Motion, place: int, text: SolutionText, language: Language
) -> dict[str, Any]:
    """One problem with its solution; ``place`` is that of the variant in the batch ``motion``."""
    said = statement(variant, asked, language)
    figures = Figures(variant, asked, motion, place, language, view_order(text))
    return {
        "title": variant.family.title(language.name),
        "text": text_data(said.text),
        "given": [equals_data(equation) for equation in said.given],
        "asked": [to_typst(symbol) for symbol in said.asked],
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
