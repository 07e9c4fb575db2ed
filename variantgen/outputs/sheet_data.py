"""What a problem sheet shows, as data for the typesetting templates."""

from __future__ import annotations

from typing import Any

from variantgen.exam.content import Content, Posed
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.outputs.qr import qr_text
from variantgen.outputs.writing import TYPST, Writing
from variantgen.wording.language import Language
from variantgen.wording.statement import Statement, sign_notes

_SHORT_NAME = 48


def sheets_data(
    content: Content,
    figures: dict[int, Any] | None = None,
    seed: str | None = None,
    writing: Writing = TYPST,
) -> dict[str, Any]:
    """Data for templates of sheets; what is made of the drawings is noted in ``figures`` by their ids.

    The sheets of a build with a ``seed`` have QR codes, if the exam wants them.
    """
    exam, language = content.exam, content.exam.spoken
    noted = {} if figures is None else figures
    marked = seed is not None and exam.qr
    students = []
    for sheet, own in zip(content.sheets, content.posed, strict=True):
        problems = [_problem(posed, language, noted, writing) for posed in own]
        code = writing.code(qr_text(exam, seed or "", sheet)) if marked else ""
        students.append({**student_data(sheet, problems, language, sheet is content.sheets[-1]), "qr": code})
    return {
        "lang": exam.language,
        "title": exam.title,
        "course": exam.course,
        "duplex": exam.duplex,
        "words": dict(language.words("sheet")),
        "students": students,
    }


def student_data(sheet: Sheet, problems: list[dict[str, Any]], language: Language, last: bool) -> dict[str, Any]:
    """Who a run of pages is for, and its problems."""
    student = sheet.student
    name = student.name
    return {
        "name": name,
        "short": name if len(name) <= _SHORT_NAME else name[: _SHORT_NAME - 1] + "…",
        "group": group_text(student, language),
        "code": sheet.code,
        "notes": sign_notes([q for item in sheet.items for q in item.asked], language),
        "problems": problems,
        "last": last,
    }


def group_text(student: Student, language: Language) -> str:
    """``Group A``; nothing for a student without one."""
    return f"{language.words('sheet')['group']} {student.group}" if student.group else ""


def _problem(posed: Posed, language: Language, figures: dict[int, Any], writing: Writing) -> dict[str, Any]:
    item, said = posed.item, posed.said
    drawn = figures[id(posed.figure)] = writing.figure(posed.figure)
    return {
        "number": str(item.task.number),
        "points": points_text(item.task.points, language),
        **statement_data(said, writing),
        "headings": [
            writing.heading(symbol, language.unit(answer.unit))
            for symbol, answer in zip(said.asked, item.answers, strict=True)
        ],
        "figure": drawn,
    }


def statement_data(said: Statement, writing: Writing = TYPST) -> dict[str, Any]:
    """What a problem says: its text, what is given and what is asked."""
    return {
        "text": writing.text(said.text),
        "given": [writing.equals(equation) for equation in said.given],
        "asked": [writing.formula(symbol) for symbol in said.asked],
    }


def points_text(points: int | None, language: Language) -> str:
    """``10 points`` with the plural of the language."""
    return "" if points is None else language.counted(points, "points")
