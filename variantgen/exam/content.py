"""What the documents of a few students say and show, free of any format: every output renders the same content.

Statements, figures and solutions are made when an output first asks for them, once for all outputs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

from variantgen.errors import InputError
from variantgen.exam.exam_file import Exam
from variantgen.exam.sheets import Item, Sheet, solve_all
from variantgen.families.quantities import Quantity
from variantgen.figure.build import statement_figure
from variantgen.figure.drawing import Drawing
from variantgen.mechanism.motion import Motion
from variantgen.variants.attempts import VerificationError
from variantgen.variants.variant import Variant
from variantgen.wording.language import Language
from variantgen.wording.statement import Statement, statement

# What writes solutions is loaded by the functions that need it: sheets alone do without.
if TYPE_CHECKING:
    from variantgen.exam.solution_figures import SolutionFigure
    from variantgen.wording.solution.document import SolutionText


@dataclass(frozen=True)
class PosedProblem:
    """A problem as it stands on a sheet: what it says, in the language of the sheets, and its figure."""

    item: Item
    statement: Statement
    figure: Drawing


@dataclass(frozen=True)
class SolvedProblem:
    """A problem with its worked solution, in the language of the solutions.

    ``rows`` are the figures, first that of the statement; ``numbers`` are those of their kinds. ``explained`` is false
    where no method leads to what is asked: then there are the answers alone.
    """

    variant: Variant
    statement: Statement
    text: SolutionText
    rows: tuple[tuple[SolutionFigure, ...], ...]
    numbers: dict[str, int]
    explained: bool = True


class Content:
    """The problems of some students of an exam and, where they are wanted, their solutions."""

    def __init__(self, exam: Exam, sheets: Sequence[Sheet]) -> None:
        self.exam, self.sheets = exam, tuple(sheets)

    @cached_property
    def posed(self) -> tuple[tuple[PosedProblem, ...], ...]:
        """The problems of each student."""
        language = self.exam.spoken
        items = [item for sheet in self.sheets for item in sheet.items]
        placed = iter(solve_all([item.variant for item in items], [item.asked for item in items], positions_only=True))
        return tuple(tuple(_posed(item, *next(placed), language) for item in sheet.items) for sheet in self.sheets)

    @cached_property
    def solved(self) -> tuple[tuple[SolvedProblem, ...], ...]:
        """The problems of each student with their solutions; none if the exam wants no solutions."""
        if not self.exam.solutions.wanted:
            return tuple(() for _ in self.sheets)
        items = [item for sheet in self.sheets for item in sheet.items]
        placed = iter(solve_all([item.variant for item in items], [item.asked for item in items]))
        same = self.exam.solutions.language == self.exam.language
        return tuple(
            tuple(
                self._solved(sheet, item, next(placed), self.posed[number][position] if same else None)
                for position, item in enumerate(sheet.items)
            )
            for number, sheet in enumerate(self.sheets)
        )

    @property
    def unexplained(self) -> tuple[str, ...]:
        """The families of problems that have an answer, but no worked solution."""
        return tuple(p.variant.family.name for own in self.solved for p in own if not p.explained)

    def _solved(self, sheet: Sheet, item: Item, place: tuple[Motion, int], known: PosedProblem | None) -> SolvedProblem:
        """One solution; ``known`` is the problem as it was posed in the same language."""
        from variantgen.wording.solution.explain import UnexplainedError, answers_only, explain

        language, explained = self.exam.explained, True
        try:
            text = explain(item.variant, *place, item.asked, language, self.exam.solution_options(item.task))
        except InputError as error:
            where = f"problem[{item.task.number}]."
            problems = [p if p.file else replace(p, key=where + p.key) for p in error.problems]
            raise InputError(problems).located(str(self.exam.path)) from None
        except VerificationError as error:
            where = f"student {sheet.student.id}, problem {item.task.number}"
            raise VerificationError(f"{error} ({where})") from error
        except UnexplainedError:
            explained = False
            text = answers_only(item.variant, *place, item.asked, language)
        return with_figures(item.variant, item.asked, language, place, text, known, explained)


def with_figures(
    variant: Variant,
    asked: Sequence[Quantity],
    language: Language,
    place: tuple[Motion, int],
    text: SolutionText,
    known: PosedProblem | None = None,
    explained: bool = True,
) -> SolvedProblem:
    """A written solution with the problem and the figures that its steps name.

    ``place`` is the motion of the variant and its index in that batch, ``known`` the problem as it was posed in the
    same language.
    """
    from variantgen.exam.solution_figures import CURVE, SolutionFigures, view_order

    problem_text = known.statement if known else statement(variant, asked, language)
    sketch = variant.form.figure.sketch
    drawn = known.figure if known and not sketch else None  # a sheet has an empty grid below its figure
    figures = SolutionFigures(variant, asked, language, place, drawn, text)
    figures.draw([*view_order(text), *(f"{CURVE}:{name}" for name in sketch)])
    return SolvedProblem(variant, problem_text, text, figures.rows(), figures.numbers, explained)


def _posed(item: Item, motion: Motion, place: int, language: Language) -> PosedProblem:
    problem_text = statement(item.variant, item.asked, language)
    return PosedProblem(item, problem_text, statement_figure(item.variant, motion, place, item.asked, language))
