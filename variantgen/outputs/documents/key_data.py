"""The key as data for templates: the answers of each student, and a table for each problem."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from variantgen.exam.exam import Exam
from variantgen.exam.sheets import Answer, Sheet
from variantgen.outputs.documents.key_content import Place, equation, key_table, mark, place, remarks, tolerance_note
from variantgen.outputs.documents.writing import Writing


def key_by_student(exam: Exam, sheets: Sequence[Sheet], first: bool, writing: Writing) -> dict[str, Any]:
    """Blocks of answers in the order of the roster; the first part carries the heading."""
    return _document(exam, first, "by_student", student_answers(exam, sheets, writing), [])


def key_by_problem(exam: Exam, sheets: Sequence[Sheet], first: bool, writing: Writing) -> dict[str, Any]:
    """A table per problem (and per form of its family) with a row per student."""
    tables = problem_tables(exam, sheets, writing)
    return _document(exam, False, "by_problem" if first else "", [], [tables[where] for where in sorted(tables)])


def student_answers(exam: Exam, sheets: Sequence[Sheet], writing: Writing) -> list[dict[str, Any]]:
    """The answers of each student."""
    language = exam.spoken
    return [
        {
            **_whose(sheet),
            "group": sheet.student.group,
            "problems": [
                {
                    "number": str(item.task.number),
                    "answers": [
                        {
                            **writing.equals(equation(a, language, item.variant.form.symbols), a.surd),
                            **_remarks(a, exam),
                        }
                        for a in item.answers
                    ],
                }
                for item in sheet.items
            ],
        }
        for sheet in sheets
    ]


def problem_tables(exam: Exam, sheets: Sequence[Sheet], writing: Writing) -> dict[Place, dict[str, Any]]:
    """The tables by their places, with the rows of these students."""
    language = exam.spoken
    tables: dict[Place, dict[str, Any]] = {}
    for sheet in sheets:
        for item in sheet.items:
            if place(item) not in tables:
                found = key_table(item, exam, language)
                symbols = [writing.heading(symbol, unit) for symbol, unit in found.heads]
                tables[place(item)] = {
                    "title": found.title,
                    "form": found.form,
                    "symbols": symbols,
                    "rows": [],
                }
            values = [{"value": language.answer(a.quantity, a.value).text, **_remarks(a, exam)} for a in item.answers]
            tables[place(item)]["rows"].append({**_whose(sheet), "values": values})
    return tables


def _whose(sheet: Sheet) -> dict[str, str]:
    return {"code": sheet.code, "name": sheet.student.name or sheet.student.id}


def _remarks(answer: Answer, exam: Exam) -> dict[str, str]:
    """What stands beside a value."""
    return {"margin": tolerance_note(answer, exam, exam.spoken), "mark": mark(answer)}


def _document(exam: Exam, heading: bool, section: str, students: list[Any], tables: list[Any]) -> dict[str, Any]:
    language = exam.spoken
    words = language.words("key")
    return {
        "lang": exam.language,
        "title": exam.title,
        "heading": f"{words['title']}: {exam.title}" if heading else "",
        "subheading": "  ·  ".join(filter(None, (exam.course, *remarks(exam, language)))) if heading else "",
        "section": words[section] if section and (heading or not students) else "",
        "footer": f"{words['title']}  ·  {exam.title}",
        "words": dict(words),
        "students": students,
        "tables": tables,
    }
