"""What a problem sheet shows, as data for the typesetting templates."""

from __future__ import annotations

from typing import Any

from variantgen.exam.content import Content, PosedProblem
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.exam.sheets import Sheet
from variantgen.outputs.documents.writing import Writing
from variantgen.outputs.qr import qr_text
from variantgen.wording.answer_notes import answer_notes, letter_notes, sign_notes
from variantgen.wording.graph_words import read_off
from variantgen.wording.language import Language
from variantgen.wording.statement import Statement
from variantgen.wording.text import with_symbols

_SHORT_NAME = 48


def sheets_data(
    content: Content, writing: Writing, figures: dict[int, Any] | None = None, built: bool = False
) -> dict[str, Any]:
    """Data for templates of sheets; what is made of the drawings is noted in ``figures`` by their ids.

    The sheets of a build (``built``) have QR codes, if the exam wants them.
    """
    exam, language = content.exam, content.exam.spoken
    noted = {} if figures is None else figures
    students = [sheet_data(content, number, writing, noted) for number in range(len(content.sheets))]
    for student, sheet in zip(students, content.sheets, strict=True):
        student["qr"] = writing.code(qr_text(exam, sheet)) if built and exam.qr else ""
        student["last"] = sheet is content.sheets[-1]
    return {
        **exam_data(exam, language),
        "reorder": exam.reorder,
        "words": dict(language.words("sheet")),
        **notices_data(exam, language, writing),
        "students": students,
    }


def exam_data(exam: Exam, language: Language) -> dict[str, Any]:
    """What every document says of its exam."""
    return {"lang": language.name, "title": exam.title, "course": exam.course, "duplex": exam.duplex}


def notices_data(exam: Exam, language: Language, writing: Writing) -> dict[str, Any]:
    """What the exam says at the head of its sheets; nothing where it says nothing."""
    if not exam.notices:
        return {}
    words = language.words("notices")
    facts = [{"label": words[name], "text": writing.text(text)} for name, text in exam.notices.facts]
    return {"notices": {"facts": facts, "instructions": [writing.text(text) for text in exam.notices.instructions]}}


def sheet_data(content: Content, number: int, writing: Writing, figures: dict[int, Any]) -> dict[str, Any]:
    """The sheet of one student; what is made of its drawings is noted in ``figures`` by their ids.

    Letters are explained beside the problem that asks for them, signs at the head of a page.
    """
    language = content.exam.spoken
    problems = [_problem(posed, language, figures, writing) for posed in content.posed[number]]
    student = student_data(content.sheets[number], problems, language)
    signs = {note for problem in problems for note in problem["signs"]}
    return {**student, "notes": [note for note in student["notes"] if note in signs]}


def student_data(sheet: Sheet, problems: list[dict[str, Any]], language: Language) -> dict[str, Any]:
    """Who a run of pages is for, and its problems.

    A sheet of nobody yet has the number of the variant, and what is filled in by hand.
    """
    student, name = sheet.student, sheet.student.name
    found = {
        "name": name,
        "short": name if len(name) <= _SHORT_NAME else name[: _SHORT_NAME - 1] + "…",
        "group": group_text(student, language),
        "code": sheet.code,
        "notes": sheet_notes(sheet, language),
        "problems": problems,
    }
    if name:
        return found
    return {
        **found,
        "code": f"{student.id} · {sheet.code}",
        "number": variant_number(student, language),
        "sheet-code": sheet.code,
        "blank": blank_labels(language),
    }


def variant_number(student: Student, language: Language) -> str:
    """``Variant 12``: what the sheet of a student without a name is called."""
    return language.words("notices")["variant"].format(number=student.id)


def who(sheet: Sheet, language: Language) -> str:
    """What a sheet is called in a list: by the name, or by the number of the variant and the code."""
    return sheet.student.name or f"{variant_number(sheet.student, language)} · {sheet.code}"


def blank_labels(language: Language) -> list[str]:
    """What is filled in by hand on the sheet of a student without a name."""
    words = language.words("notices")
    return [words["name"], words["group"], words["date"]]


def sheet_notes(sheet: Sheet, language: Language) -> list[str]:
    """The letters and conventions of sign that the answers of a sheet need."""
    forms = [item.variant.form for item in sheet.items]
    asked = [quantity for form, item in zip(forms, sheet.items, strict=True) for quantity in read_off(form, item.asked)]
    return answer_notes(asked, language, {name: said for form in forms for name, said in form.symbols.items()})


def group_text(student: Student, language: Language) -> str:
    """``Group A``; nothing for a student without one."""
    return f"{language.words('sheet')['group']} {student.group}" if student.group else ""


def _problem(posed: PosedProblem, language: Language, figures: dict[int, Any], writing: Writing) -> dict[str, Any]:
    item, said = posed.item, posed.statement
    form = item.variant.form
    shown = read_off(form, item.asked)
    drawn = figures[id(posed.figure)] = writing.figure(posed.figure)
    return {
        "number": str(item.task.number),
        "points": points_text(item.task.points, language),
        **statement_data(said, writing),
        "signs": sign_notes(shown, language),
        "letters": [writing.text(with_symbols(note)) for note in letter_notes(shown, language, form.symbols)],
        "headings": [
            writing.heading(symbol, language.unit(answer.unit))
            for symbol, answer in zip(said.asked, item.answers, strict=True)
        ],
        "figure": drawn,
    }


def statement_data(said: Statement, writing: Writing) -> dict[str, Any]:
    """What a problem says: its text, what is given and what is asked."""
    return {
        "text": writing.text(said.text),
        "given": [writing.equals(equation) for equation in said.given],
        "asked": [writing.formula(symbol) for symbol in said.asked],
    }


def points_text(points: int | None, language: Language) -> str:
    """``10 points`` with the plural of the language."""
    return "" if points is None else language.counted(points, "points")
