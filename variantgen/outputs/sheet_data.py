"""What a problem sheet shows, as data for the typesetting templates."""

from __future__ import annotations

from typing import Any

from variantgen.exam.content import Content, Posed
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.outputs.markup import heading, markup
from variantgen.outputs.qr import qr_rows, qr_svg, qr_text
from variantgen.outputs.typesetter import equals_data, figure_data
from variantgen.wording.language import Language
from variantgen.wording.statement import Statement, Text, sign_notes

_SHORT_NAME = 48


def sheets_data(content: Content, figures: dict[int, Any] | None = None, seed: str | None = None) -> dict[str, Any]:
    """Data for ``sheets.typ``; what is made of the drawings is noted in ``figures`` by their ids.

    The sheets of a build with a ``seed`` have QR codes, if the exam wants them.
    """
    exam, language = content.exam, content.exam.spoken
    noted = {} if figures is None else figures
    marked = seed is not None and exam.qr
    students = [
        {
            **student_data(
                sheet, [_problem(posed, language, noted) for posed in own], language, sheet is content.sheets[-1]
            ),
            "qr": qr_svg(qr_rows(qr_text(exam, seed or "", sheet))) if marked else "",
        }
        for sheet, own in zip(content.sheets, content.posed, strict=True)
    ]
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


def _problem(posed: Posed, language: Language, figures: dict[int, Any]) -> dict[str, Any]:
    item, said = posed.item, posed.said
    drawn = figures[id(posed.figure)] = figure_data(posed.figure)
    return {
        "number": str(item.task.number),
        "points": points_text(item.task.points, language),
        **statement_data(said),
        "headings": [
            heading(symbol, language.unit(answer.unit)) for symbol, answer in zip(said.asked, item.answers, strict=True)
        ],
        "figure": drawn,
    }


def statement_data(said: Statement) -> dict[str, Any]:
    """What a problem says: its text, what is given and what is asked."""
    return {
        "text": text_data(said.text),
        "given": [equals_data(equation) for equation in said.given],
        "asked": [markup(symbol) for symbol in said.asked],
    }


def text_data(text: Text) -> list[Any]:
    """Runs of text: strings as they are, formulas as one-element lists."""
    return [part if isinstance(part, str) else [markup(part)] for part in text]


def points_text(points: int | None, language: Language) -> str:
    """``10 points`` with the plural of the language (one, few, many)."""
    if points is None:
        return ""
    words = language.words("sheet")
    if points % 10 == 1 and points % 100 != 11:
        form = "points_one"
    elif points % 10 in (2, 3, 4) and points % 100 not in (12, 13, 14):
        form = "points_few"
    else:
        form = "points_many"
    return f"{points}\N{NO-BREAK SPACE}{words[form]}"
