"""A problem as an item: statement with figure, a box for each number, how answers are scored, the worked solution."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal
from xml.etree.ElementTree import Element

from msgspec import Struct

from variantgen.exam.exam import Exam
from variantgen.outputs.html.fragments import notes_html, solution_html, statement_html
from variantgen.outputs.html.writing import HtmlWriting, in_text
from variantgen.outputs.platforms.figure_files import UsedFigures
from variantgen.outputs.platforms.numbers import number
from variantgen.outputs.platforms.point_shares import shares
from variantgen.outputs.platforms.questions import AnswerField, Question
from variantgen.outputs.platforms.text import one_line
from variantgen.outputs.qti.dialect import Dialect
from variantgen.outputs.qti.options import PackageOptions
from variantgen.outputs.qti.package_images import statement_figure
from variantgen.outputs.qti.xml_tree import element
from variantgen.version import VERSION
from variantgen.wording.html import to_html
from variantgen.wording.solution.phrases import load_phrases

_SCORE, _MAXIMUM, _FEEDBACK, _SOLUTION = "SCORE", "MAXSCORE", "FEEDBACK", "SOLUTION"
_BOUNDS = ("gte", "lte")
_BOX = "10"  # letters that a box for a number has room for


def identifier(question: Question) -> str:
    """The identifier of the item of a question: a name of XML, which begins with a letter."""
    return f"i{question.identifier}"


def title(question: Question, exam: Exam) -> str:
    """What an item is called in a pool: exam, problem, variant."""
    words = exam.spoken.words("sheet")
    what = f"{words['problem']} {question.posed.item.task.number}, {words['variant']} {question.sheet.code}"
    return one_line(f"{exam.title}. {what}")


class QtiItems(Struct, frozen=True):
    """Makes the items of an exam in a version of QTI."""

    dialect: Dialect
    exam: Exam
    figures: UsedFigures
    options: PackageOptions

    def item(self, question: Question) -> Element:
        """The item of a question."""
        make = self.dialect.element
        points = shares(question.posed.item.task.points, len(question.parts))
        attributes = {
            **self.dialect.root(),
            "identifier": identifier(question),
            "title": title(question, self.exam),
            "xml:lang": self.exam.language,
            "adaptive": "false",
            "timeDependent": "false",
            "toolName": "variantgen",
            "toolVersion": VERSION,
        }
        solution = list(self._solution(question))
        return make(
            "assessmentItem",
            attributes,
            *(self._response(part) for part in question.parts),
            *self._outcomes(sum(points), bool(solution)),
            make("itemBody", {}, *self._body(question)),
            make("responseProcessing", {}, *self._processing(question, points, bool(solution))),
            *solution,
        )

    @property
    def _writing(self) -> HtmlWriting:
        return HtmlWriting(in_text, self.figures.image)

    def _response(self, part: AnswerField) -> Element:
        """The declaration of a number that is to be entered, with the right one."""
        make = self.dialect.element
        right = make("correctResponse", {}, make("value", {}, number(part.answer.value)))
        return make("responseDeclaration", _declared(_response_name(part), "float"), right)

    def _outcomes(self, points: Decimal | int, explained: bool) -> Iterator[Element]:
        make = self.dialect.element
        limits = {"normalMaximum": number(Decimal(points)), "normalMinimum": "0"}
        for name, value, more in ((_SCORE, "0", limits), (_MAXIMUM, number(Decimal(points)), {})):
            default = make("defaultValue", {}, make("value", {}, value))
            yield make("outcomeDeclaration", {**_declared(name, "float"), **more}, default)
        if explained:
            yield make("outcomeDeclaration", _declared(_FEEDBACK, "identifier"))

    def _body(self, question: Question) -> Iterator[Element]:
        """Statement, figure, conventions of signs, boxes."""
        language, posed = self.exam.spoken, question.posed
        html = self.dialect.html
        yield from html(statement_html(posed.statement, language, self._writing))
        yield from html(statement_figure(self.figures, posed.figure))
        yield from html(notes_html(question.notes))
        for part in question.parts:
            yield self._box(part)
        yield element("p", {"class": "notes"}, element("small", {}, language.words("platform")["numbers"]))

    def _box(self, part: AnswerField) -> Element:
        """A paragraph with the symbol, the box and the unit."""
        box = self.dialect.element(
            "textEntryInteraction", {"responseIdentifier": _response_name(part), "expectedLength": _BOX}
        )
        space = "\N{NO-BREAK SPACE}"
        unit = f"{space}{to_html(part.unit)}" if part.unit.parts else ""
        (symbol,) = self.dialect.html(f"<span>{to_html(part.symbol)}{space}={space}</span>")
        (after,) = self.dialect.html(f"<span>{unit}</span>")
        return element("p", {"class": "answer"}, symbol, box, *([after] if unit else []))

    def _processing(self, question: Question, points: Sequence[Decimal], explained: bool) -> Iterator[Element]:
        """For each part its points if the number is right; at last the solution is shown."""
        make = self.dialect.element
        for part, own in zip(question.parts, points, strict=True):
            earned = make(
                "sum",
                {},
                make("variable", {"identifier": _SCORE}),
                make("baseValue", {"baseType": "float"}, number(own)),
            )
            then = make("setOutcomeValue", {"identifier": _SCORE}, earned)
            yield make("responseCondition", {}, make("responseIf", {}, self._right(part), then))
        if explained:
            shown = make("baseValue", {"baseType": "identifier"}, _SOLUTION)
            yield make("setOutcomeValue", {"identifier": _FEEDBACK}, shown)

    def _right(self, part: AnswerField) -> Element:
        """Whether the number of a part is right; a direction may be given with a whole turn more or less.

        Its bounds are compared one by one: there are platforms that know no tolerance of ``equal``.
        """
        make = self.dialect.element
        found = [
            make("and", {}, *(self._compared(part, name, value) for name, value in zip(_BOUNDS, bounds, strict=True)))
            for bounds in part.answer.exact_intervals
        ]
        return make("or", {}, *found) if len(found) > 1 else found[0]

    def _compared(self, part: AnswerField, how: str, bound: Decimal) -> Element:
        make = self.dialect.element
        given = make("variable", {"identifier": _response_name(part)})
        return make(how, {}, given, make("baseValue", {"baseType": "float"}, number(bound)))

    def _solution(self, question: Question) -> Iterator[Element]:
        """The worked solution, which is shown after an attempt."""
        if question.solved is None:
            return
        language = self.exam.explained
        content = self.dialect.html(solution_html(question.solved, language, self.options.writing(self.figures)))
        shown = {
            "outcomeIdentifier": _FEEDBACK,
            "identifier": _SOLUTION,
            "showHide": "show",
            "title": load_phrases(language.name).words["solutions"],
        }
        yield self.dialect.feedback(shown, element("div", {"xml:lang": language.name}, *content))


def _response_name(part: AnswerField) -> str:
    return f"RESPONSE_{part.name}"


def _declared(name: str, kind: str) -> dict[str, str]:
    return {"identifier": name, "cardinality": "single", "baseType": kind}
