"""The questions of learning platforms: one problem of one student with its parts, free of any platform."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from variantgen.exam.content import PosedProblem, SolvedProblem
from variantgen.exam.sheets import Answer, Sheet
from variantgen.outputs.formats import Chunk
from variantgen.outputs.platforms.reference import Reference
from variantgen.wording.answer_notes import answer_notes
from variantgen.wording.formula import Formula, UnitText
from variantgen.wording.graph_words import read_off


class AnswerField(Struct, frozen=True):
    """A part of a question: one number to be entered.

    ``name`` is an identifier like ``a1``, unique in the question; ``unit`` has no parts for a pure number.
    """

    name: str
    symbol: Formula
    unit: UnitText
    answer: Answer


class Question(Struct, frozen=True):
    """One problem of one student; ``solved`` is None where the exam wants no solutions.

    ``identifier`` is unique in the world as far as exam file, seed and student are, of letters, digits and hyphens.
    ``notes`` are conventions of signs.
    """

    identifier: str
    sheet: Sheet
    posed: PosedProblem
    solved: SolvedProblem | None
    parts: tuple[AnswerField, ...]
    notes: tuple[str, ...]

    @property
    def reference(self) -> Reference:
        """By what an attempt finds its way back."""
        return Reference(self.sheet.code, self.posed.item.task.number)

    @property
    def family(self) -> str:
        """The name of the family."""
        return self.posed.item.variant.family.name


def questions(part: Chunk) -> Iterator[Question]:
    """The questions of some students in the order of sheets and problems."""
    exam, language = part.exam, part.exam.spoken
    build = exam.build_id
    for number, sheet in enumerate(part.sheets):
        for place, posed in enumerate(part.content.posed[number]):
            item = posed.item
            asked = tuple(
                AnswerField(f"a{k}", symbol, language.unit(answer.unit), answer)
                for k, (symbol, answer) in enumerate(zip(posed.statement.asked, item.answers, strict=True), start=1)
            )
            yield Question(
                f"{build}-{item.task.number}-{sheet.code}",
                sheet,
                posed,
                part.content.solved[number][place] if exam.solutions.wanted else None,
                asked,
                tuple(answer_notes(read_off(item.variant.form, item.asked), language, item.variant.form.symbols)),
            )
