"""The key as data for ``key.typ``: one block per student, one table per problem."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from variantgen.exam.exam_file import Exam
from variantgen.exam.sheets import Sheet
from variantgen.outputs.documents.key_content import equation, key_table, mark, place, remarks, tolerance_note
from variantgen.outputs.documents.writing import TYPST, Writing
from variantgen.wording.language import Language


def key_by_student(exam: Exam, sheets: Sequence[Sheet], first: bool, writing: Writing = TYPST) -> dict[str, Any]:
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
                            **writing.equals(equation(a, language, item.variant.form.symbols), a.surd),
                            "margin": tolerance_note(a, exam, language),
                            "mark": mark(a),
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


def key_by_problem(exam: Exam, sheets: Sequence[Sheet], first: bool, writing: Writing = TYPST) -> dict[str, Any]:
    """A table per problem (and per form of its family) with a row per student."""
    language = exam.spoken
    tables: dict[tuple[int, str, str], dict[str, Any]] = {}
    for sheet in sheets:
        for item in sheet.items:
            if place(item) not in tables:
                found = key_table(item, exam, language)
                symbols = [writing.heading(symbol, unit) for symbol, unit in found.heads]
                tables[place(item)] = {"title": found.title, "symbols": symbols, "rows": []}
            table = tables[place(item)]
            table["rows"].append(
                {
                    "code": sheet.code,
                    "name": sheet.student.name or sheet.student.id,
                    "values": [
                        {
                            "value": language.answer(a.quantity, a.value).text,
                            "margin": tolerance_note(a, exam, language),
                            "mark": mark(a),
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
        "subheading": "  ·  ".join(filter(None, (exam.course, *remarks(exam, language)))) if heading else "",
        "section": words[section] if section and (heading or not students) else "",
        "footer": f"{words['title']}  ·  {exam.title}",
        "words": dict(words),
        "students": students,
        "tables": tables,
    }
