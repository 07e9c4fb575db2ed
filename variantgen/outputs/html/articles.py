"""Articles of which pages of HTML are made: the sheet of a student, the solutions of a student, the key."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import count
from typing import Any

from variantgen.exam.content import Content
from variantgen.exam.exam import Exam
from variantgen.exam.sheets import Sheet
from variantgen.figure.drawing import Drawing
from variantgen.outputs.documents.key_content import Place
from variantgen.outputs.documents.key_data import problem_tables, student_answers
from variantgen.outputs.documents.sheet_data import notices_data, sheet_data
from variantgen.outputs.documents.solution_data import solutions_data
from variantgen.outputs.figures.svg import svg
from variantgen.outputs.html.pages import rendered
from variantgen.outputs.html.writing import HtmlWriting
from variantgen.wording.language import Language
from variantgen.wording.mathml import to_mathml


def page_writing(code: str = "") -> HtmlWriting:
    """Formulas as MathML, figures as SVG; ids of figures are numbered after the code of the sheet."""
    numbers = count(1)

    def image(drawing: Drawing, millimetres: float, caption: str) -> str:
        return svg(drawing, "" if drawing.alt else caption, millimetres, name=f"-{code}-{next(numbers)}")

    return HtmlWriting(to_mathml, image)


def sheet_article(content: Content, number: int) -> bytes:
    """The sheet of one student."""
    exam, sheet = content.exam, content.sheets[number]
    language, writing = exam.spoken, page_writing(sheet.code)
    return rendered(
        "sheet.html.j2",
        **_head(exam, sheet, language, sheet_data(content, number, writing, {})),
        title=exam.title,
        words=language.words("sheet"),
        answers=language.words("html")["answers"],
        **notices_data(exam, language, writing),
    )


def solution_article(content: Content, number: int) -> bytes:
    """The worked solutions of one student."""
    exam, sheet = content.exam, content.sheets[number]
    data = solutions_data(content, number, page_writing(sheet.code))
    words = data["words"]
    return rendered(
        "solution.html.j2",
        **_head(exam, sheet, exam.explained, data["students"][0]),
        title=f"{words['solutions']}: {exam.title}",
        words=words,
    )


def _head(exam: Exam, sheet: Sheet, language: Language, student: dict[str, Any]) -> dict[str, Any]:
    """Whose article it is, and in which exam."""
    return {
        "course": exam.course,
        "code": sheet.code,
        "variant": language.words("key")["variant"],
        "student": student,
        "notes": student["notes"],
    }


def student_key(exam: Exam, sheets: Sequence[Sheet]) -> bytes:
    """The answers of some students, student by student."""
    students = student_answers(exam, sheets, page_writing())
    return rendered("key_students.html.j2", students=students, words=exam.spoken.words("sheet"))


def problem_keys(exam: Exam, sheets: Sequence[Sheet]) -> Iterator[tuple[Place, bytes]]:
    """The rows of these students in each table of the key."""
    for where, table in problem_tables(exam, sheets, page_writing()).items():
        yield where, rendered("key_rows.html.j2", rows=table["rows"])
