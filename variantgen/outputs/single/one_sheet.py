"""The sheet of one student, or the solutions of it, as pages or as text (``show EXAM.toml``)."""

from __future__ import annotations

import textwrap
from pathlib import Path

from variantgen.exam.content import Content
from variantgen.exam.exam import Exam
from variantgen.exam.sheets import Sheet
from variantgen.outputs.documents.sheet_data import group_text, points_text, sheet_notes, sheets_data, who
from variantgen.outputs.documents.solution_data import solutions_data
from variantgen.outputs.figures import write_whole
from variantgen.outputs.single.problem_page import Format, page_format
from variantgen.outputs.typst.sheet_pages import with_pages
from variantgen.outputs.typst.typesetter import Typesetter, typesetter
from variantgen.outputs.typst.writing import TYPST
from variantgen.wording.plain import plain_problem
from variantgen.wording.solution.plain import plain_solution

_COLUMNS = 100


def write_sheet(exam: Exam, sheet: Sheet, path: Path, explained: bool = False) -> list[Path]:
    """Write the sheet, or the solutions, as a build typesets them; the format follows the ending of the path.

    A picture holds one page: of several, those after the first have their numbers before the ending. Returns what was
    written. Raises InputError for another ending.
    """
    form = page_format(path)
    with typesetter() as engine:
        pages = sheet_pages(exam, sheet, engine, form, explained)
    paths = [path, *(path.with_stem(f"{path.stem}-{number}") for number in range(2, len(pages) + 1))]
    for own, page in zip(paths, pages, strict=True):
        write_whole(own, page, "--out")
    return paths


def sheet_pages(exam: Exam, sheet: Sheet, engine: Typesetter, form: Format, explained: bool = False) -> list[bytes]:
    """The sheet, or the solutions, as pages of SVG or PNG, or as one PDF."""
    content = Content(exam, (sheet,))
    if explained:
        return engine.compile("solutions.typ", solutions_data(content, 0, TYPST), form)
    return engine.compile("sheets.typ", with_pages(sheets_data(content, TYPST, built=True), engine), form)


def plain_sheet(exam: Exam, sheet: Sheet, explained: bool = False) -> str:
    """The sheet with its answers in lines of at most 100 columns; with the solutions if ``explained``."""
    language, student = exam.spoken, sheet.student
    name = f"{student.name} · {sheet.code}" if student.name else who(sheet, language)
    heads = [exam.title, exam.course, " · ".join(filter(None, (name, group_text(student, language))))]
    parts = ["\n".join(textwrap.fill(head, _COLUMNS) for head in heads if head)]
    solved = Content(exam, (sheet,)).solved[0] if explained else ()
    for number, item in enumerate(sheet.items):
        points = points_text(item.task.points, language)
        word = f"{language.words('sheet')['problem']} {item.task.number}"
        values = [(answer.value, answer.unit, answer.surd) for answer in item.answers]
        problem = plain_problem(item.variant, item.asked, values, language, with_notes=False)
        parts.append(f"{word} ({points}). {problem}" if points else f"{word}. {problem}")
        if explained:
            parts.append(plain_solution(solved[number].text, exam.explained))
    parts += [textwrap.fill(note, _COLUMNS) for note in sheet_notes(sheet, language)]
    return "\n\n".join(parts)
