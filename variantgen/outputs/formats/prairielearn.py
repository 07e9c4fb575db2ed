"""Questions for a course of PrairieLearn: a folder for each problem of the exam and family it is drawn from.

A question holds the variants of all students as data (``variants.json``) without their names; ``server.py`` picks one
by the seed that PrairieLearn gives it. ``question.html`` is rendered as a Mustache template once, before the elements
in it are processed, so what the data hold is never read as a template. Readers are not told the tolerance of an
answer: as a part of the answer it would betray it.
"""

from __future__ import annotations

import json
import re
import shutil
import uuid
from collections.abc import Iterator, Sequence
from decimal import Decimal
from hashlib import sha256
from html import escape
from pathlib import Path
from typing import Any

from msgspec import Struct

from variantgen.exam.exam import Exam, ExamProblem
from variantgen.exam.roster import Student
from variantgen.families.family import Family
from variantgen.outputs import formats
from variantgen.outputs.formats import Chunk, Fragment, WholeExam
from variantgen.outputs.html.fragments import notes_html, solution_html, statement_html
from variantgen.outputs.html.mathjax import to_mathjax
from variantgen.outputs.html.writing import HtmlWriting
from variantgen.outputs.platforms.figure_files import FORMS, FigureFile, FigureFiles, UsedFigures
from variantgen.outputs.platforms.numbers import number
from variantgen.outputs.platforms.questions import AnswerField, Question, questions
from variantgen.outputs.platforms.text import one_line, storable
from variantgen.resources import templates_dir
from variantgen.tables import Table

HELP = "prairielearn/, questions for a course of PrairieLearn"
FILES = ("prairielearn/*",)
TARGETS = r"[A-Za-z0-9_-]+(/clientFilesQuestion/[0-9a-f]{20}\.(svg|png))?"
SUMMARIES = ()
write_key = None

_LONGEST = 200  # characters of a title
_FOLDER = "prairielearn"
_CLIENT = "clientFilesQuestion"
_NAMESPACE = uuid.uuid5(uuid.NAMESPACE_URL, "variantgen/prairielearn")


class PrairieLearnOptions(Struct, frozen=True):
    """``figures``: ``svg`` or ``png``."""

    figures: str = FORMS[0]


def read_options(table: Table) -> PrairieLearnOptions:
    """The table ``[prairielearn]``."""
    options = PrairieLearnOptions(table.choice("figures", FORMS))
    table.finish()
    return options


def check(exam: Exam, students: Sequence[Student]) -> None:
    """Nothing is needed that is not always there."""


def make(part: Chunk) -> Iterator[Fragment]:
    """Variants of a few students, in a piece for each question, and the figures that they show."""
    files = FigureFiles(formats.options(part.exam, "prairielearn").figures, part.engine)
    found: dict[str, list[str]] = {}
    for question in questions(part):
        figures = UsedFigures(files, _element)
        variant = json.dumps(_variant(question, part.exam, figures), ensure_ascii=False)
        qid = _qid(question.posed.item.task, question.posed.item.variant.family, part.exam.build_id)
        found.setdefault(qid, []).append(variant)
        for file in figures.used.values():
            yield Fragment(f"{qid}/{_CLIENT}/{file.name}", file.content)
    for qid, variants in found.items():
        yield Fragment(qid, ",\n".join(variants).encode(), ".json")


def finish(whole: WholeExam) -> None:
    """The folders of the questions, and how to use them."""
    templates = templates_dir() / "prairielearn"
    build = whole.exam.build_id
    top = whole.folder / _FOLDER
    top.mkdir()
    shutil.copyfile(templates / "README.md", top / "README.md")
    for task in whole.exam.tasks:
        for family in {family.name: family for family in task.families}.values():
            qid = _qid(task, family, build)
            if qid not in whole.pieces:
                continue  # nobody has drawn this family
            folder = top / "questions" / qid
            (folder / _CLIENT).mkdir(parents=True)
            for name in ("question.html", "server.py"):
                shutil.copyfile(templates / name, folder / name)
            _write_json(folder / "info.json", _info(whole.exam, family, qid))
            _join(whole.pieces[qid], folder / "variants.json")
            for target, paths in whole.pieces.items():
                if target.startswith(f"{qid}/"):
                    shutil.copyfile(paths[0], top / "questions" / target)


def _qid(task: ExamProblem, family: Family, build: str) -> str:
    """The name of a question and of its folder, of letters, digits, hyphens and underscores."""
    name = re.sub(r"[^A-Za-z0-9_-]", "_", family.name)[:60]
    other = "" if name == family.name else f"-{sha256(family.name.encode()).hexdigest()[:6]}"
    return f"{name}{other}-{task.number}-{build}"


def _info(exam: Exam, family: Family, qid: str) -> dict[str, Any]:
    title = one_line(family.title(exam.language), _LONGEST) or family.name
    topic = one_line(exam.course, _LONGEST) or one_line(exam.title, _LONGEST) or "variantgen"
    return {
        "uuid": str(uuid.uuid5(_NAMESPACE, qid)),
        "title": title,
        "topic": topic,
        "tags": ["numeric"],
        "type": "v3",
    }


def _variant(question: Question, exam: Exam, figures: UsedFigures) -> dict[str, Any]:
    """What ``server.py`` and ``question.html`` know of a variant."""
    posed = question.posed
    writing, figure = HtmlWriting(to_mathjax, figures.image), figures.file(posed.figure)
    solved = question.solved and {
        "lang": exam.solutions.language,
        "html": storable(solution_html(question.solved, exam.explained, writing)),
    }
    return {
        "code": question.sheet.code,
        "lang": exam.language,
        "statement": storable(statement_html(posed.statement, exam.spoken, writing)),
        "figure": _shown(figure, figure.size()),
        "parts": [_part(asked) for asked in question.parts],
        "notes": notes_html(question.notes),
        "solution": solved,
        "answers": {asked.name: asked.answer.value for asked in question.parts},
    }


def _part(asked: AnswerField) -> dict[str, Any]:
    """One number to be entered; ``also`` are other intervals of right answers than that around the answer.

    PrairieLearn compares the difference of two doubles with the tolerance: what stands right at the end of the interval
    may miss it by the last bit, so the tolerance has a billionth of the answer more.
    """
    value, tolerance = (Decimal(repr(one)) for one in (asked.answer.value, asked.answer.tolerance))
    return {
        "name": asked.name,
        "label": f"{to_mathjax(asked.symbol)} =",
        "suffix": to_mathjax(asked.unit) if asked.unit.parts else "",
        "tolerance": number(tolerance + max(abs(value), tolerance).scaleb(-9)),
        "also": [list(window) for window in asked.answer.accepted_intervals[1:]],
    }


def _shown(file: FigureFile, size: tuple[int, int]) -> dict[str, Any]:
    """What an element that shows a figure has to know."""
    return {"file": file.name, "width": size[0], "alt": storable(file.alt)}


def _element(file: FigureFile, size: tuple[int, int]) -> str:
    """A figure inside a text. Text right after such an element would not be escaped by PrairieLearn."""
    alt = escape(storable(file.alt))
    return f'<pl-figure file-name="{file.name}" width="{size[0]}" alt="{alt}"></pl-figure>'


def _join(pieces: list[Path], path: Path) -> None:
    """A list of all variants, one in a line."""
    with path.open("wb") as file:
        for number, piece in enumerate(pieces):
            file.write(b",\n" if number else b"[\n")
            file.write(piece.read_bytes())
        file.write(b"\n]\n")


def _write_json(path: Path, content: dict[str, Any]) -> None:
    path.write_bytes((json.dumps(content, ensure_ascii=False, indent=2) + "\n").encode())
