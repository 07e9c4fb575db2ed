"""An exam as a package for Canvas: a quiz for each sheet, or one quiz that draws a question for each problem."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal
from itertools import chain, groupby
from pathlib import Path
from urllib.parse import quote
from xml.etree import ElementTree

from variantgen.errors import InputError, Problem
from variantgen.exam.exam import Exam, ExamProblem
from variantgen.exam.sheets import Sheet
from variantgen.families.asking import read_ask
from variantgen.outputs import formats
from variantgen.outputs.formats import Chunk, Fragment, WholeExam
from variantgen.outputs.platforms.point_shares import shares
from variantgen.outputs.platforms.questions import Question, questions
from variantgen.outputs.platforms.text import one_line
from variantgen.outputs.qti import canvas_quiz as quiz
from variantgen.outputs.qti.canvas_item import CanvasItems
from variantgen.outputs.qti.options import HTML, PackageOptions, read_options
from variantgen.outputs.qti.outline import Outline
from variantgen.outputs.qti.package import MANIFEST, Package, contents, indexes, names, pack, package
from variantgen.outputs.qti.package_images import FOLDER, files, package_figures
from variantgen.outputs.qti.xml_tree import document
from variantgen.tables import Table

NAME = "canvas"
_PACKAGE = "package"  # the target of the pieces
_ROOT = quote("$IMS-CC-FILEBASE$")  # what Canvas takes for the root of the files of a package


class CanvasOptions(PackageOptions, frozen=True):
    """``once``: the statement is a text before the questions of a problem, not a part of each of them."""

    once: bool = False


def read_table(table: Table) -> CanvasOptions:
    """The table ``[canvas]``."""
    shared = read_options(table, "quizzes", ("draw", "students"), PackageOptions(formulas=HTML, drawn=False))
    once = table.choice("statement", ("each", "once"), "each") == "once"
    if once and shared.drawn:
        table.problem(
            "a text would be drawn like a question", "statement", "once", 'leave it out with quizzes = "draw"'
        )
    table.finish()
    return CanvasOptions(shared.figures, shared.formulas, shared.drawn, shared.names, once)


def check(exam: Exam) -> None:
    """Raise InputError if questions are to be drawn and a problem asks for more than one number."""
    options: CanvasOptions = formats.options(exam, NAME)
    long = [task for task in exam.tasks if _numbers(task) > 1] if options.drawn else []
    if long:
        raise InputError(
            Problem(
                "Canvas draws questions with one number each, so the numbers of a problem would be asked of different"
                " variants",
                file=str(exam.path),
                key=f"problem[{task.number}].ask",
                value=f"{_numbers(task)} numbers",
                remedy='ask for one quantity, or take quizzes = "students" in [canvas]',
            )
            for task in long
        )


def _numbers(task: ExamProblem) -> int:
    """How many numbers a problem asks for, at most."""
    return max(len(read_ask(form, task.ask)) for family in task.families for form in family.forms.values())


def make(part: Chunk) -> Iterator[Fragment]:
    """The questions of a few students with their figures."""
    options: CanvasOptions = formats.options(part.exam, NAME)
    figures = package_figures(part.engine, options.figures, lambda name: f"{_ROOT}/{name}")
    items = CanvasItems(part.exam, figures, options, options.once)
    documents: dict[str, bytes] = {}
    quizzes: list[str] = []
    for _, own in groupby(questions(part), lambda question: question.sheet.code):
        sheet = list(own)
        if options.drawn:
            documents.update(_questions(sheet, items))
        else:
            quizzes.append(_quiz_name(part.exam, sheet[0].sheet))
            documents.update(_quiz(quizzes[-1], sheet, items, options))
    yield Fragment(_PACKAGE, pack({**documents, **files(figures)}, quizzes), ".zip")


def _quiz_name(exam: Exam, sheet: Sheet) -> str:
    return f"i{exam.build_id}-{sheet.code}"


def _questions(sheet: Sequence[Question], items: CanvasItems) -> Iterator[tuple[str, bytes]]:
    """Each question of a sheet as a document of its own, in the folder of its problem."""
    for question in sheet:
        for item in items.items(question):
            yield f"{_group(question.posed.item.task)}{item.get('ident')}.xml", document(item)


def _group(task: ExamProblem) -> str:
    return f"problem-{task.number}/"


def _quiz(
    name: str, sheet: Sequence[Question], items: CanvasItems, options: CanvasOptions
) -> Iterator[tuple[str, bytes]]:
    """The documents of the quiz of a student."""
    exam, student = items.exam, sheet[0].sheet.student
    named = f", {student.name}" if options.names and student.name else ""
    title = one_line(f"{exam.title}. {exam.spoken.words('key')['variant']} {sheet[0].sheet.code}{named}")
    every = chain.from_iterable(items.items(question) for question in sheet)
    yield quiz.question_file(name), document(quiz.whole(name, title, every))
    points = _points((question.posed.item.task, len(question.parts)) for question in sheet)
    yield quiz.meta_file(name), document(quiz.meta(name, title, exam, points, assigned=True))


def _points(problems: Iterator[tuple[ExamProblem, int]]) -> Decimal:
    return sum((share for task, parts in problems for share in shares(task.points, parts)), Decimal(0))


def finish(whole: WholeExam) -> None:
    """The package."""
    exam, pieces = whole.exam, whole.pieces[_PACKAGE]
    options: CanvasOptions = formats.options(exam, NAME)
    name, title = f"i{exam.build_id}", one_line(exam.title)
    with package(whole.folder / f"{NAME}.zip") as made:
        with made.outline(MANIFEST) as outline, quiz.resources(outline, f"{name}-manifest", title, exam.language):
            for one in [name] if options.drawn else chain.from_iterable(indexes(pieces)):
                for resource in quiz.quiz_resources(one):
                    outline.add(resource)
            for file in names(pieces, f"{FOLDER}/"):
                outline.add(quiz.picture(file))
        if options.drawn:
            _write_drawing(made, name, title, exam, pieces)
        for file, content in contents(pieces, f"{FOLDER}/" if options.drawn else ""):
            made.add(file, content)


def _write_drawing(made: Package, name: str, title: str, exam: Exam, pieces: Sequence[Path]) -> None:
    """The quiz that draws a question for each problem."""
    with (
        made.outline(quiz.question_file(name)) as outline,
        outline.inside("questestinterop", quiz.QTI),
        outline.inside("assessment", {"ident": name, "title": title}),
    ):
        outline.add(quiz.attempts())
        with outline.inside("section", {"ident": "root_section"}):
            for task in exam.tasks:
                _write_group(outline, f"{name}-{task.number}", task, exam, pieces)
    points = _points((task, 1) for task in exam.tasks)
    made.add(quiz.meta_file(name), document(quiz.meta(name, title, exam, points, assigned=False)))


def _write_group(outline: Outline, name: str, task: ExamProblem, exam: Exam, pieces: Sequence[Path]) -> None:
    """The questions of one problem, of which each student gets one."""
    title = f"{exam.spoken.words('sheet')['problem']} {task.number}"
    with outline.inside("section", {"ident": name, "title": title}):
        outline.add(quiz.pick(_points(iter([(task, 1)]))))
        for _, content in contents(pieces, _group(task)):
            outline.add(ElementTree.fromstring(content))  # noqa: S314  (written by this program)
