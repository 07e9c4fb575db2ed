"""A problem as questions of Canvas: QTI 1.2 as Canvas itself exports it, where a question has one box for a number.

So every number that is asked makes a question. Usually each of them has the whole statement with the figure, which is
what every way of import keeps: New Quizzes drop texts between questions, and quizzes may show one question at a time.
Where an exam says ``statement = "once"``, the statement is a text before its questions, which name it as theirs
(``parent_stimulus_item_ident``, as New Quizzes write it).
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from html import escape
from xml.etree.ElementTree import Element

from msgspec import Struct
from msgspec.structs import replace

from variantgen.exam.exam import Exam
from variantgen.exam.sheets import Answer
from variantgen.outputs.html.fragments import notes_html, solution_html, statement_html
from variantgen.outputs.html.writing import HtmlWriting, in_text
from variantgen.outputs.platforms.figure_files import UsedFigures
from variantgen.outputs.platforms.numbers import number
from variantgen.outputs.platforms.point_shares import shares
from variantgen.outputs.platforms.questions import AnswerField, Question
from variantgen.outputs.platforms.text import one_line
from variantgen.outputs.qti.item import identifier
from variantgen.outputs.qti.options import PackageOptions
from variantgen.outputs.qti.package_images import statement_figure
from variantgen.outputs.qti.xml_tree import element, fragment, html
from variantgen.wording.html import to_html

_RESPONSE = {"respident": "response1"}
_FEEDBACK = "general_fb"


class CanvasItems(Struct, frozen=True):
    """Makes the questions of an exam; ``once``: the statement is a text before them."""

    exam: Exam
    figures: UsedFigures
    options: PackageOptions
    once: bool

    def items(self, question: Question) -> Iterator[Element]:
        """The questions of a problem."""
        points = shares(question.posed.item.task.points, len(question.parts))
        stem = f"{identifier(question)}-text" if self.once else ""
        if self.once:
            presentation = element("presentation", {}, _material(self._statement(question)))
            yield self._item(question, stem, "", _metadata("text_only_question", Decimal(0), stem), presentation)
        for place, (part, own) in enumerate(zip(question.parts, points, strict=True), start=1):
            count = len(question.parts)
            last = place == count
            name = f"{identifier(question)}-{part.name}"
            text = ("" if self.once else self._statement(question)) + self._asked(question, part, place)
            feedback = self._solution(question) if last else ""
            yield self._item(
                question,
                name,
                f" ({place}/{count})" if count > 1 else "",
                _metadata("numerical_question", own, name, stem),
                element("presentation", {}, _material(text), _box()),
                _processing(part.answer, bool(feedback)),
                *([_feedback(feedback)] if feedback else []),
            )

    def _item(self, question: Question, name: str, which: str, *content: Element) -> Element:
        """An item with its title, which instructors see."""
        words = self.exam.spoken.words("sheet")
        title = one_line(f"{words['problem']} {question.posed.item.task.number}{which}. {question.sheet.code}")
        return element("item", {"ident": name, "title": title}, *content)

    @property
    def _writing(self) -> HtmlWriting:
        return HtmlWriting(in_text, self.figures.image)

    def _statement(self, question: Question) -> str:
        posed = question.posed
        said = statement_html(posed.statement, self.exam.spoken, self._writing)
        return said + statement_figure(self.figures, posed.figure) + notes_html(question.notes)

    def _asked(self, question: Question, part: AnswerField, place: int) -> str:
        """Which number is to be entered, in which unit, and how."""
        words, count = self.exam.spoken.words("platform"), len(question.parts)
        which = f"{escape(words['answer'].format(number=place, count=count))} " if count > 1 else ""
        unit = f", {to_html(part.unit)}" if part.unit.parts else ""
        where = replace(question.reference, quantity=part.answer.quantity.name)
        problem = f"{escape(self.exam.spoken.words('sheet')['problem'])} {question.posed.item.task.number}. "
        return (
            f"<p><strong>{problem if self.once else ''}{which}</strong>{to_html(part.symbol)}{unit}</p>"
            f"<p><small>{escape(words['numbers'])} {escape(str(where))}</small></p>"
        )

    def _solution(self, question: Question) -> str:
        """The worked solution of the whole problem, which follows its last number."""
        if question.solved is None:
            return ""
        language = self.exam.explained
        written = fragment(solution_html(question.solved, language, self.options.writing(self.figures)))
        return html(element("div", {"lang": language.name}, *written))


def field(label: str, entry: str) -> Element:
    """A field of metadata."""
    return element("qtimetadatafield", {}, element("fieldlabel", {}, label), element("fieldentry", {}, entry))


def _metadata(kind: str, points: Decimal, name: str, parent: str = "") -> Element:
    fields = {
        "question_type": kind,
        "points_possible": number(points),
        "assessment_question_identifierref": f"{name}-q",  # so that it stays in its quiz and fills no question bank
        **({"parent_stimulus_item_ident": parent} if parent else {}),
    }
    return element("itemmetadata", {}, element("qtimetadata", {}, *(field(*pair) for pair in fields.items())))


def _material(html: str) -> Element:
    return element("material", {}, element("mattext", {"texttype": "text/html"}, html))


def _box() -> Element:
    """A box for a number."""
    label = element("response_label", {"ident": "answer1"})
    box = element("render_fib", {"fibtype": "Decimal"}, label)
    return element("response_str", {"ident": "response1", "rcardinality": "Single"}, box)


def _processing(answer: Answer, explained: bool) -> Element:
    """Full score inside the margins of the number, and of the same direction with a whole turn more or less."""
    limits = {"maxvalue": "100", "minvalue": "0", "varname": "SCORE", "vartype": "Decimal"}
    conditions = [element("outcomes", {}, element("decvar", limits))]
    if explained:
        shown = element("displayfeedback", {"feedbacktype": "Response", "linkrefid": _FEEDBACK})
        always = element("conditionvar", {}, element("other"))
        conditions.append(element("respcondition", {"continue": "Yes"}, always, shown))
    first, *others = (_between(*bounds) for bounds in answer.exact_intervals)
    # Canvas takes the margin from the distance of the bounds, so they are exact in decimals.
    exact = element("varequal", _RESPONSE, number(answer.value))
    conditions.append(_full(element("or", {}, exact, element("and", {}, *first))))
    conditions += [_full(*other) for other in others]
    return element("resprocessing", {}, *conditions)


def _between(low: Decimal, high: Decimal) -> tuple[Element, Element]:
    """The bounds of a number, which may be reached."""
    return element("vargte", _RESPONSE, number(low)), element("varlte", _RESPONSE, number(high))


def _full(*conditions: Element) -> Element:
    score = element("setvar", {"action": "Set", "varname": "SCORE"}, "100")
    return element("respcondition", {"continue": "No"}, element("conditionvar", {}, *conditions), score)


def _feedback(html: str) -> Element:
    return element("itemfeedback", {"ident": _FEEDBACK}, element("flow_mat", {}, _material(html)))
