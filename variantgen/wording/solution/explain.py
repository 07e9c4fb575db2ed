"""The solution of one variant in a language: from the solved motion to headings, text and formulas."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.families.quantities import Quantity
from variantgen.mechanism.motion import Motion
from variantgen.methods.compose import solution
from variantgen.methods.step import Solution
from variantgen.methods.task import Task, task_of
from variantgen.variants.needed import shown_points
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Equation, Formula, Measured, Symbol
from variantgen.wording.language import Language
from variantgen.wording.solution.document import SolutionText
from variantgen.wording.solution.formulas import Formulas
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.solution.symbols import Symbols
from variantgen.wording.solution.writer import Writer
from variantgen.wording.statement import Text
from variantgen.wording.surds import surd, with_surd
from variantgen.wording.vector_names import centre_letters


def explain(
    variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language, short: bool = False
) -> SolutionText:
    """The solution of one variant of a solved batch, in a language."""
    task = task_of(variant, motion, index, asked)
    return written(task, solution(task), language, short)


def written(task: Task, found: Solution, language: Language, short: bool = False) -> SolutionText:
    """A solution in a language."""
    phrases = load_phrases(language.name)
    symbols = Symbols(task.form, language, phrases, _centres(task))
    writer = Writer(symbols, Formulas(symbols, task.variant.family.length_unit), short)
    sections = tuple(writer.section(step) for step in found.steps)
    return SolutionText(
        _plan([writer.text(step.heading) for step in found.steps]),
        sections,
        _answer(task, found, language),
        writer.blocks(found.check),
    )


def _centres(task: Task) -> dict[str, Symbol]:
    """Letters of velocity centres; they must not be those of points that the figure shows elsewhere."""
    form = task.form
    names = {body: form.symbols.get(body, body) for body in form.bodies}
    plane = {body: name for body, name in names.items() if not task.fixed & set(form.bodies[body])}
    letters = centre_letters(plane, shown_points(task.variant, task.asked))
    return {**{body: Symbol("P") for body in names}, **letters}


def _plan(headings: Sequence[Text]) -> Text:
    """The headings as a numbered list in one paragraph."""
    parts: list[str | Formula] = []
    for number, heading in enumerate(headings, start=1):
        parts += [f"{'; ' if number > 1 else ''}{number})\N{NO-BREAK SPACE}", *heading]
    return (*parts, ".")


def _answer(task: Task, found: Solution, language: Language) -> Text:
    """The asked quantities with their values as in the key."""
    parts: list[str | Formula] = []
    for quantity, (_, value) in zip(task.asked, found.answers, strict=True):
        unit = language.unit(quantity.unit(task.variant.family.length_unit))
        symbol = language.quantity(quantity, task.form.symbols)
        equation = Equation(symbol, Measured(language.rounded(value.exact), unit))
        parts += ["; " if parts else "", with_surd(equation, surd(value.exact))]
    return (*parts, ".")
