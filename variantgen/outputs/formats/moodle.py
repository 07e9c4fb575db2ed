"""A file of questions for Moodle (question bank, import, Moodle XML format): one cloze question for each problem.

The mark of a cloze question is the sum of the whole weights of its parts; Moodle reads no other. Tolerances are
absolute, and are those of the key. The text has its formulas as HTML, which needs no filter; the worked solution,
shown as general feedback, has them as LaTeX for the MathJax filter. UsedFigures are inside the file.

Moodle's reader of XML is told of a text piece by piece and drops pieces of white space alone. A piece ends at every
entity and, with some parsers, at every end of a line, so texts are CDATA on one line.
"""

from __future__ import annotations

import base64
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Iterator, Sequence
from html import escape
from pathlib import Path
from xml.parsers import expat
from xml.sax.saxutils import unescape

from msgspec import Struct

from variantgen.errors import VariantgenError
from variantgen.exam.exam import Exam
from variantgen.exam.roster import Student
from variantgen.outputs import formats
from variantgen.outputs.formats import Chunk, Fragment, WholeExam
from variantgen.outputs.html.fragments import notes_html, solution_html, statement_html
from variantgen.outputs.html.mathjax import to_mathjax
from variantgen.outputs.html.writing import HtmlWriting, in_text
from variantgen.outputs.platforms.cloze import inert, part, weights
from variantgen.outputs.platforms.figure_files import FORMS, FigureFile, FigureFiles, UsedFigures
from variantgen.outputs.platforms.questions import Question, questions
from variantgen.outputs.platforms.text import one_line, storable
from variantgen.tables import Table
from variantgen.wording.html import to_html

HELP = "moodle.xml, cloze questions for the question bank of Moodle"
FILES = ("moodle.xml",)
TARGETS = "[0-9A-Z]+(-[0-9A-Z]+)+"  # of families: two numbers; of students: their codes
SUMMARIES = ()
write_key = None

FAMILIES, STUDENTS = "families", "students"
_LONGEST = 200  # characters of a name; Moodle holds 255
_DECLARATION = b'<?xml version="1.0" encoding="UTF-8"?>\n'
_CHUNK = 1 << 20
_TEXT = re.compile("<text>([^<]+)</text>")
# Moodle takes what looks like a tag out of names.
_BRACKETS = str.maketrans("<>", "‹›")


class MoodleOptions(Struct, frozen=True):
    """``figures``: ``svg`` or ``png``.

    ``categories``: ``families``, a bank with a category for each problem and family and without names of students, or
    ``students``, a category for each student.
    """

    figures: str = FORMS[0]
    categories: str = FAMILIES


def read_options(table: Table) -> MoodleOptions:
    """The table ``[moodle]``."""
    options = MoodleOptions(table.choice("figures", FORMS), table.choice("categories", (FAMILIES, STUDENTS)))
    table.finish()
    return options


def check(exam: Exam, students: Sequence[Student]) -> None:
    """Nothing is needed that is not always there."""


def make(part: Chunk) -> Iterator[Fragment]:
    """The questions of a few students, in a piece for each category."""
    chosen: MoodleOptions = formats.options(part.exam, "moodle")
    files = FigureFiles(chosen.figures, part.engine)
    found: dict[str, list[bytes]] = {}
    for question in questions(part):
        found.setdefault(_target(question, chosen), []).append(_written(_question(question, part.exam, files)))
    for target, written in found.items():
        yield Fragment(target, b"".join(written), ".xml")


def finish(whole: WholeExam) -> None:
    """One file with all categories. Raises VariantgenError instead of leaving a file that is no XML."""
    path = whole.folder / "moodle.xml"
    with path.open("wb") as file:
        file.write(_DECLARATION + b"<quiz>\n")
        for target, names in _categories(whole):
            if target in whole.pieces:
                file.write(_written(_heading(names)))
            for piece in whole.pieces.get(target, ()):
                file.write(piece.read_bytes())
        file.write(b"</quiz>\n")
    check_xml(path)


def check_xml(path: Path) -> None:
    """Raise VariantgenError if a file is not well-formed."""
    parser = expat.ParserCreate()
    try:
        with path.open("rb") as file:
            while chunk := file.read(_CHUNK):
                parser.Parse(chunk)
        parser.Parse(b"", True)
    except expat.ExpatError as error:
        raise VariantgenError(f"{path.name} would not be XML ({error}): a defect of the program") from error


def _target(question: Question, chosen: MoodleOptions) -> str:
    """Which category a question belongs to."""
    if chosen.categories == STUDENTS:
        return question.sheet.code
    task = question.posed.item.task
    return f"{task.number}-{[family.name for family in task.families].index(question.family)}"


def _categories(whole: WholeExam) -> Iterator[tuple[str, tuple[str, ...]]]:
    """All categories in order, each with the names that lead to it."""
    exam = whole.exam
    title = exam.title or exam.path.stem
    if formats.options(exam, "moodle").categories == STUDENTS:
        for sheet in whole.sheets:
            student = sheet.student
            group = (student.group,) if student.group.strip() else ()
            yield sheet.code, (title, *group, f"{one_line(student.name or student.id, _LONGEST - 20)} · {sheet.code}")
        return
    for task in exam.tasks:
        for place, family in enumerate(task.families):
            yield f"{task.number}-{place}", (title, f"{task.number}. {family.title(exam.language)}")


def _heading(names: tuple[str, ...]) -> ET.Element:
    """The category that the questions after it go into."""
    found = ET.Element("question", type="category")
    path = "/".join(("$course$", "top", *map(_category_name, names)))
    _text(ET.SubElement(found, "category"), path)
    return found


def _category_name(name: str) -> str:
    """A name in a path of categories, where slashes of names are doubled and kept from those of the path."""
    doubled = _plain_name(name).replace("/", "//")
    return f"{' ' * doubled.startswith('/')}{doubled}{' ' * doubled.endswith('/')}"


def _plain_name(name: str) -> str:
    return one_line(name, _LONGEST).translate(_BRACKETS)


def _question(question: Question, exam: Exam, files: FigureFiles) -> ET.Element:
    """One question."""
    item = question.posed.item
    found = ET.Element("question", type="cloze")
    title = one_line(item.variant.family.title(exam.language), _LONGEST - 30)
    _text(ET.SubElement(found, "name"), _plain_name(f"{item.task.number}. {title} · {question.sheet.code}"))
    _rich(ET.SubElement(found, "questiontext", format="html"), *_posed(question, exam, files))
    feedback = ET.SubElement(found, "generalfeedback", format="html")
    if question.solved is None:
        _rich(feedback, "", [])
    else:
        figures = UsedFigures(files, _image)
        html = solution_html(question.solved, exam.explained, HtmlWriting(to_mathjax, figures.image))
        _rich(feedback, f'<div lang="{exam.solutions.language}">{html}</div>', figures.used.values())
    ET.SubElement(found, "penalty").text = "0.3333333"
    ET.SubElement(found, "hidden").text = "0"
    ET.SubElement(found, "idnumber").text = question.identifier
    _text(ET.SubElement(ET.SubElement(found, "tags"), "tag"), one_line(question.family, _LONGEST))
    return found


def _posed(question: Question, exam: Exam, files: FigureFiles) -> tuple[str, Iterable[FigureFile]]:
    """The text of a question with its parts, and the files that it shows."""
    figures = UsedFigures(files, _image)
    writing = HtmlWriting(in_text, figures.image)
    posed = question.posed
    shown = f"<p>{figures.image(posed.figure)}</p>"
    text = inert(statement_html(posed.statement, exam.spoken, writing) + shown)
    shares = weights(posed.item.task.points, len(question.parts))
    lines = (
        f"<p>{inert(to_html(asked.symbol))}\N{NO-BREAK SPACE}= {part(asked.answer, share)} "
        f"{inert(to_html(asked.unit))}</p>"
        for asked, share in zip(question.parts, shares, strict=True)
    )
    numbers = f"{exam.spoken.words('platform')['numbers']} {question.reference}"
    notes = inert(notes_html((*question.notes, numbers)))
    return f'<div lang="{exam.language}">{text}{"".join(lines)}{notes}</div>', figures.used.values()


def _image(file: FigureFile, size: tuple[int, int]) -> str:
    """A figure, which is in the file beside the text."""
    alt = escape(file.alt)
    source = f"@@PLUGINFILE@@/{file.name}"
    return f'<img src="{source}" alt="{alt}" width="{size[0]}" height="{size[1]}" class="img-fluid">'


def _rich(parent: ET.Element, html: str, used: Iterable[FigureFile]) -> None:
    """HTML with the files that it shows; ends of lines, which a listing has, as entities of HTML."""
    _text(parent, html.replace("\n", "&#10;"))
    for file in used:
        element = ET.SubElement(parent, "file", name=file.name, path="/", encoding="base64")
        element.text = base64.b64encode(file.content).decode()


def _text(parent: ET.Element, text: str) -> None:
    ET.SubElement(parent, "text").text = storable(text)


def _written(element: ET.Element) -> bytes:
    """An element of XML on a line, texts as CDATA."""
    written: str = ET.tostring(element, encoding="unicode")
    return f"{_TEXT.sub(_cdata, written)}\n".encode()


def _cdata(match: re.Match[str]) -> str:
    """A text in which nothing is escaped; what would end it is written in two halves."""
    halves = unescape(match[1]).replace("]]>", "]]]]><![CDATA[>")
    return f"<text><![CDATA[{halves}]]></text>"
