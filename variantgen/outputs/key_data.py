"""The key as data for ``key.typ``: one block per student, one table per problem."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from typing import Any

from variantgen.exam.blueprint import Exam
from variantgen.exam.sheets import Answer, Sheet
from variantgen.outputs.markup import heading
from variantgen.outputs.typesetter import equals_data
from variantgen.wording.formula import Equation, Measured
from variantgen.wording.language import Language

_UNNOTICED = "*"


def key_by_student(exam: Exam, sheets: Sequence[Sheet], first: bool) -> dict[str, Any]:
    """Blocks of answers in the order of the roster; the first part carries the heading."""
    language = exam.spoken
    students = [
        {
            "code": sheet.code,
            "name": sheet.student.name or sheet.student.id,
            "group": sheet.student.group,
            "problems": [
                {
                    "number": str(item.task.number),
                    "answers": [
                        {
                            **equals_data(_equation(a, language, item.variant.form.symbols), a.surd),
                            "margin": _margin(a, exam, language),
                            "mark": _mark(a),
                        }
                        for a in item.answers
                    ],
                }
                for item in sheet.items
            ],
        }
        for sheet in sheets
    ]
    return _document(exam, language, first, "by_student", students, [])


def key_by_problem(exam: Exam, sheets: Sequence[Sheet], first: bool) -> dict[str, Any]:
    """A table per problem (and per form of its family) with a row per student."""
    language = exam.spoken
    tables: dict[tuple[int, str, str], dict[str, Any]] = {}
    for sheet in sheets:
        for item in sheet.items:
            variant = item.variant
            title = variant.family.title(exam.language)
            where = (item.task.number, variant.family.name, variant.form.name)
            table = tables.setdefault(
                where,
                {
                    "title": f"{language.words('key')['problem']} {item.task.number}. {title}",
                    "symbols": [
                        heading(language.quantity(answer.quantity, variant.form.symbols), language.unit(answer.unit))
                        for answer in item.answers
                    ],
                    "rows": [],
                },
            )
            table["rows"].append(
                {
                    "code": sheet.code,
                    "name": sheet.student.name or sheet.student.id,
                    "values": [
                        {
                            "value": language.rounded(a.value).text,
                            "margin": _margin(a, exam, language),
                            "mark": _mark(a),
                        }
                        for a in item.answers
                    ],
                }
            )
    ordered = [tables[where] for where in sorted(tables)]
    return _document(exam, language, False, "by_problem" if first else "", [], ordered)


def _document(
    exam: Exam, language: Language, heading: bool, section: str, students: list[Any], tables: list[Any]
) -> dict[str, Any]:
    words = language.words("key")
    return {
        "lang": exam.language,
        "title": exam.title,
        "heading": f"{words['title']}: {exam.title}" if heading else "",
        "subheading": f"{exam.course}  ·  {words['tolerance']}: {_percent(exam.tolerance.floor, language)},"
        f" {words['otherwise']}  ·  {_UNNOTICED} {words['unnoticed']}"
        if heading
        else "",
        "section": words[section] if section and (heading or not students) else "",
        "footer": f"{words['title']}  ·  {exam.title}",
        "words": dict(words),
        "students": students,
        "tables": tables,
    }


def _margin(answer: Answer, exam: Exam, language: Language) -> str:
    """The relative tolerance of an answer, where it is more than the usual one."""
    return _percent(answer.margin, language) if answer.margin > exam.tolerance.floor else ""


def _mark(answer: Answer) -> str:
    """The sign of an answer that some mistakes change by less than its tolerance."""
    return _UNNOTICED if answer.unnoticed else ""


def _percent(margin: float, language: Language) -> str:
    """``±1.5 %``, of an angle the like part of a radian."""
    return f"±{language.decimal(Decimal(f'{100 * margin:.3g}')).text}\N{NO-BREAK SPACE}%"


def _equation(answer: Answer, language: Language, symbols: Mapping[str, str]) -> Equation:
    value = Measured(language.rounded(answer.value), language.unit(answer.unit))
    return Equation(language.quantity(answer.quantity, symbols), value)
