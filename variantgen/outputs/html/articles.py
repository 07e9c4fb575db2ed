"""Articles of which pages of HTML are made: the sheet of a student, the solutions of a student, the key."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count
from typing import Any

from markupsafe import Markup

from variantgen.exam.content import Content, PosedProblem
from variantgen.exam.exam_file import Exam
from variantgen.exam.sheets import Answer, Item, Sheet
from variantgen.figure.drawing import Drawing
from variantgen.outputs.documents.key_content import KeyTable, equation, mark, tolerance_note
from variantgen.outputs.documents.sheet_data import blank_labels, points_text, sheet_notes, variant_number
from variantgen.outputs.documents.solution_data import solution_words
from variantgen.outputs.figures.svg import svg
from variantgen.outputs.html.fragments import HtmlStyle, notes_html, solution_html, statement_html
from variantgen.outputs.html.pages import rendered
from variantgen.wording.formula import Formula, Relation, UnitText
from variantgen.wording.language import Language
from variantgen.wording.mathml import to_mathml

_FIGURE, _UNIT = 80.0, 0.8  # the figure on a sheet, in millimetres: at most this wide; of one of its units


def page_style(code: str) -> HtmlStyle:
    """Formulas as MathML, figures as SVG; ids of figures are numbered after the code of the sheet."""
    numbers = count(1)

    def figure(drawing: Drawing, millimetres: float, caption: str = "") -> str:
        title = "" if drawing.alt else caption
        return svg(drawing, title, millimetres, name=f"-{code}-{next(numbers)}")

    return HtmlStyle(to_mathml, figure, captioned=figure)


def sheet_article(content: Content, number: int) -> bytes:
    """The sheet of one student."""
    exam, sheet = content.exam, content.sheets[number]
    language, style = exam.spoken, page_style(sheet.code)
    return rendered(
        "sheet.html.j2",
        **_who(exam, sheet, language),
        words=language.words("sheet"),
        blank=[] if sheet.student.name else blank_labels(language),
        **_notices(exam, language, style),
        answers=language.words("html")["answers"],
        problems=[_problem(posed, language, style) for posed in content.posed[number]],
    )


def _notices(exam: Exam, language: Language, style: HtmlStyle) -> dict[str, Any]:
    """What the exam says at the head of its sheets."""
    words, notices = language.words("notices"), exam.notices
    return {
        "facts": [(words[name], _markup(style.text(text))) for name, text in notices.facts],
        "instructions": [_markup(style.text(text)) for text in notices.instructions],
    }


def _problem(posed: PosedProblem, language: Language, style: HtmlStyle) -> dict[str, Any]:
    item, figure = posed.item, posed.figure
    return {
        "number": item.task.number,
        "points": points_text(item.task.points, language),
        "statement": _markup(statement_html(posed.statement, language, style)),
        "figure": _markup(style.figure(figure, min(_FIGURE, _UNIT * figure.width))),
        "heads": [
            head(symbol, language.unit(answer.unit))
            for symbol, answer in zip(posed.statement.asked, item.answers, strict=True)
        ],
    }


def solution_article(content: Content, number: int) -> bytes:
    """The worked solutions of one student."""
    exam, sheet = content.exam, content.sheets[number]
    language, style = exam.explained, page_style(sheet.code)
    problems = [
        {
            "number": item.task.number,
            "title": solved.variant.family.title(language.name),
            "statement": _markup(statement_html(solved.statement, language, style)),
            "solution": _markup(solution_html(solved, language, style)),
        }
        for item, solved in zip(sheet.items, content.solved[number], strict=True)
    ]
    words = solution_words(language)
    who = _who(exam, sheet, language) | {"title": f"{words['solutions']}: {exam.title}"}
    return rendered("solution.html.j2", **who, words=words, problems=problems)


def student_key(exam: Exam, sheets: Sequence[Sheet]) -> bytes:
    """The answers of some students, student by student."""
    language = exam.spoken
    students = [
        {
            **_who(exam, sheet, language),
            "problems": [
                {"number": item.task.number, "answers": [_keyed(a, item, exam, language) for a in item.answers]}
                for item in sheet.items
            ],
        }
        for sheet in sheets
    ]
    return rendered("key_students.html.j2", students=students)


def problem_key(exam: Exam, owners: Sequence[tuple[Sheet, Item]]) -> bytes:
    """Rows of the table of one group of problems."""
    language = exam.spoken
    rows = [
        {
            **_who(exam, sheet, language),
            "answers": [
                {
                    "value": language.answer(a.quantity, a.value).text,
                    "margin": tolerance_note(a, exam, language),
                    "mark": mark(a),
                }
                for a in item.answers
            ],
        }
        for sheet, item in owners
    ]
    return rendered("key_rows.html.j2", rows=rows)


def table_heads(group: KeyTable) -> list[Markup]:
    """The heads of the columns of answers."""
    return [head(symbol, unit) for symbol, unit in group.heads]


def head(symbol: Formula, unit: UnitText) -> Markup:
    """The head of a column of answers: ``v_B, cm/s``."""
    return _markup(to_mathml(symbol) + (f", {to_mathml(unit)}" if unit.parts else ""))


def _keyed(answer: Answer, item: Item, exam: Exam, language: Language) -> dict[str, Any]:
    """An answer, in closed form too where it has a simple one."""
    said = equation(answer, language, item.variant.form.symbols)
    shown = Relation((said.left, answer.surd, said.right), ("=", "≈")) if answer.surd else said
    return {
        "formula": _markup(to_mathml(shown)),
        "margin": tolerance_note(answer, exam, language),
        "mark": mark(answer),
    }


def _who(exam: Exam, sheet: Sheet, language: Language) -> dict[str, Any]:
    """Whose article it is, and in which exam."""
    student, words = sheet.student, language.words("sheet")
    return {
        "title": exam.title,
        "course": exam.course,
        "code": sheet.code,
        "variant": f"{language.words('key')['variant']} {sheet.code}",
        "name": student.name,
        "number": variant_number(student, language),
        "id": student.id,
        "group": f"{words['group']} {student.group}" if student.group else "",
        "notes": _markup(notes_html(sheet_notes(sheet, language))),
    }


def _markup(text: str) -> Markup:
    """Markup that the program has made itself."""
    return Markup(text)  # noqa: S704
