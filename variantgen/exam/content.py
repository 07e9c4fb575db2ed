"""What the documents of a few students say and show, free of any format: every output renders the same content.

Statements, figures and solutions are made when an output first asks for them, once for all outputs.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from itertools import repeat
from typing import TYPE_CHECKING, NamedTuple

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError
from variantgen.exam.exam import Exam
from variantgen.exam.sheets import Item, Sheet, solve_all
from variantgen.families.quantities import Quantity
from variantgen.figure.build import draw_statement
from variantgen.figure.drawing import Drawing
from variantgen.figure.making import all_made
from variantgen.mechanism.motion import Motion
from variantgen.variants.attempts import VerificationError
from variantgen.variants.variant import Variant
from variantgen.wording.language import Language
from variantgen.wording.statement import Statement, statement

# What writes solutions is loaded by the functions that need it: sheets alone do without.
if TYPE_CHECKING:
    from variantgen.exam.solution_figures import SolutionFigure
    from variantgen.wording.solution.document import SolutionText


class PosedProblem(Struct, frozen=True):
    """A problem as it stands on a sheet: what it says, in the language of the sheets, and its figure."""

    item: Item
    statement: Statement
    figure: Drawing


class SolvedProblem(Struct, frozen=True):
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
        placed = solve_all([item.variant for item in items], [item.asked for item in items], positions_only=True)
        statements = [statement(item.variant, item.asked, language) for item in items]
        figures = [draw_statement(i.variant, *at, i.asked, language) for i, at in zip(items, placed, strict=True)]
        posed = iter(map(PosedProblem, items, statements, all_made(figures)))
        return tuple(tuple(next(posed) for _ in sheet.items) for sheet in self.sheets)

    @cached_property
    def solved(self) -> tuple[tuple[SolvedProblem, ...], ...]:
        """The problems of each student with their solutions; none if the exam wants no solutions."""
        if not self.exam.solutions.wanted:
            return tuple(() for _ in self.sheets)
        items = [item for sheet in self.sheets for item in sheet.items]
        placed = iter(solve_all([item.variant for item in items], [item.asked for item in items]))
        same = self.exam.solutions.language == self.exam.language
        solved = []
        for number, sheet in enumerate(self.sheets):
            known = self.posed[number] if same else repeat(None)
            written = [
                self._written(sheet, item, next(placed), of) for item, of in zip(sheet.items, known, strict=False)
            ]
            solved.append(with_figures(written, self.exam.explained))
        return tuple(solved)

    @property
    def unexplained(self) -> tuple[str, ...]:
        """The families of problems that have an answer, but no worked solution."""
        return tuple(p.variant.family.name for own in self.solved for p in own if not p.explained)

    def _written(self, sheet: Sheet, item: Item, place: tuple[Motion, int], known: PosedProblem | None) -> Written:
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
        return Written(item.variant, item.asked, place, text, known, explained)


class Written(NamedTuple):
    """A written solution of what is asked of a variant, of which ``place`` is the motion and its index in that batch.

    ``known`` is the problem as it was posed in the same language; ``explained`` as in :class:`SolvedProblem`.
    """

    variant: Variant
    asked: Sequence[Quantity]
    place: tuple[Motion, int]
    text: SolutionText
    known: PosedProblem | None = None
    explained: bool = True


def with_figures(solutions: Sequence[Written], language: Language) -> tuple[SolvedProblem, ...]:
    """Written solutions with their problems and the figures that their steps name."""
    from variantgen.exam.solution_figures import CURVE, SolutionFigures, draw_together, view_order

    wanted = []
    for variant, asked, place, text, known, _ in solutions:
        sketch = variant.form.figure.sketch
        drawn = known.figure if known and not sketch else None  # a sheet has an empty grid below its figure
        figures = SolutionFigures(variant, asked, language, place, drawn, text)
        wanted.append((figures, [*view_order(text), *(f"{CURVE}:{name}" for name in sketch)]))
    draw_together(wanted)
    return tuple(
        SolvedProblem(
            one.variant,
            one.known.statement if one.known else statement(one.variant, one.asked, language),
            one.text,
            figures.rows(),
            figures.numbers,
            one.explained,
        )
        for one, (figures, _) in zip(solutions, wanted, strict=True)
    )
