"""What a problem sheet shows, as data for the typesetting templates."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from variantgen.exam.blueprint import Exam
from variantgen.exam.sheets import Item, Sheet, solve_all
from variantgen.figure.build import statement_figure
from variantgen.mechanism.motion import Motion
from variantgen.outputs.typesetter import equals_data, figure_data
from variantgen.wording.formula import Formula, UnitText, to_typst
from variantgen.wording.language import Language
from variantgen.wording.statement import Statement, Text, sign_notes, statement

_SHORT_NAME = 48


def sheets_data(exam: Exam, sheets: Sequence[Sheet], first: bool = True) -> dict[str, Any]:
    """Data for ``sheets.typ``; a first part is like the others."""
    language = exam.spoken
    items = [item for sheet in sheets for item in sheet.items]
    placed = iter(solve_all([item.variant for item in items], [item.asked for item in items], positions_only=True))
    students = [
        student_data(
            sheet, [_problem(item, *next(placed), language) for item in sheet.items], language, sheet is sheets[-1]
        )
        for sheet in sheets
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
        "group": f"{language.words('sheet')['group']} {student.group}" if student.group else "",
        "code": sheet.code,
        "notes": sign_notes([q for item in sheet.items for q in item.asked], language),
        "problems": problems,
        "last": last,
    }


def _problem(item: Item, motion: Motion, place: int, language: Language) -> dict[str, Any]:
    said = statement(item.variant, item.asked, language)
    return {
        "number": str(item.task.number),
        "points": _points(item.task.points, language),
        **statement_data(said),
        "headings": [
            heading(symbol, language.unit(answer.unit)) for symbol, answer in zip(said.asked, item.answers, strict=True)
        ],
        "figure": figure_data(statement_figure(item.variant, motion, place, item.asked, language)),
    }


def statement_data(said: Statement) -> dict[str, Any]:
    """What a problem says: its text, what is given and what is asked."""
    return {
        "text": text_data(said.text),
        "given": [equals_data(equation) for equation in said.given],
        "asked": [to_typst(symbol) for symbol in said.asked],
    }


def heading(symbol: Formula, unit: UnitText) -> str:
    """The head of a column of answers: ``v_B, cm/s``."""
    return f"{to_typst(symbol)}, thin {to_typst(unit)}" if unit.parts else to_typst(symbol)


def text_data(text: Text) -> list[Any]:
    """Runs of text: strings as they are, formulas as one-element lists."""
    return [part if isinstance(part, str) else [to_typst(part)] for part in text]


def _points(points: int | None, language: Language) -> str:
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
