"""The solution of one variant in a language: from the solved motion to headings, text and formulas."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from variantgen.algebra.expression import Value
from variantgen.errors import VariantgenError
from variantgen.families.quantities import Quantity
from variantgen.families.rate_graphs import grid_of
from variantgen.mechanism.motion import Motion
from variantgen.methods.compose import solution
from variantgen.methods.integration_steps import integration_steps
from variantgen.methods.linkage.problem import CLOSE, Task, task_of
from variantgen.methods.solution_options import SolutionOptions
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.methods.steps.step import Fact, NumberOf, Sentence, Solution, Step
from variantgen.variants.printed_data import shown_points
from variantgen.variants.variant import Variant
from variantgen.wording.formula import Equation, Formula, Measured, Relation, Symbol
from variantgen.wording.language import Language
from variantgen.wording.solution.document import SolutionText
from variantgen.wording.solution.formulas import Formulas
from variantgen.wording.solution.phrases import load_phrases
from variantgen.wording.solution.quantity_symbols import Symbols, centre_letters
from variantgen.wording.solution.writer import Writer
from variantgen.wording.surds import surd, with_surd
from variantgen.wording.text import Text

WHOLE = SolutionOptions()
_LONG = 9  # steps of a solution that begins with a plan: of fewer the headings tell enough


class UnexplainedError(VariantgenError):
    """The methods do not lead to what is asked: there is an answer, but no worked solution."""


def explain(
    variant: Variant,
    motion: Motion,
    index: int,
    asked: Sequence[Quantity],
    language: Language,
    options: SolutionOptions = WHOLE,
) -> SolutionText:
    """The solution of one variant of a solved batch, in a language, as it is wished.

    Raises InputError for a method that does not apply, UnexplainedError where the methods do not lead to what is asked.
    """
    if options.depth == "answers":
        return answers_only(variant, motion, index, asked, language)
    task = task_of(variant, motion, index, asked)
    try:
        found = solution(task, options.methods)
    except NOT_APPLICABLE as error:
        what = ", ".join(quantity.name for quantity in asked)
        raise UnexplainedError(
            f"{variant.family.name}: no method of solution leads to {what}; the answers themselves do not need one"
        ) from error
    text = written(task, found, language, options.depth == "short")
    return replace(text, true_scale=options.true_scale)


def answers_only(
    variant: Variant, motion: Motion, index: int, asked: Sequence[Quantity], language: Language
) -> SolutionText:
    """The answers as the solver has them, without a way to them."""
    values = [(q, q.unit(variant.family.length_unit).from_si(float(q.value(motion)[index]))) for q in asked]
    return SolutionText((), (), _answer(variant, values, language))


def written(task: Task, found: Solution, language: Language, short: bool = False) -> SolutionText:
    """A solution in a language."""
    phrases = load_phrases(language.name)
    symbols = Symbols(task.form, language, phrases, _centres(task))
    # Where no answer is a simple root, results on the way to it seldom are.
    closed = not found.approximate and any(surd(value.exact) is not None for _, value in found.answers)
    writer = Writer(symbols, Formulas(symbols, task.variant.family.length_unit), short, closed)
    length = task.variant.family.length_unit
    answers = [
        (q, (value.shown if found.approximate else value.exact) * q.own_unit(length).size / q.unit(length).size)
        for q, (_, value) in zip(task.asked, found.answers, strict=True)
    ]
    steps = (*_read_from_graph(task), *integration_steps(task), *found.steps)
    sections = tuple(writer.section(step) for step in steps)
    return SolutionText(
        _plan([writer.text(step.heading) for step in steps]),
        sections,
        _answer(task.variant, answers, language, _preface(found, writer), found.approximate),
        writer.blocks(found.check),
        found.centres,
        found.vectors,
        found.geometry,
    )


def _read_from_graph(task: Task) -> tuple[Step, ...]:
    """The step that reads a rate and its acceleration from the graph of the statement; none where there is none."""
    names = task.form.figure.graph
    if not names:
        return ()
    rate, slope = (task.given[name] for name in names)
    found = grid_of(*(abs(task.variant.printed[name]) for name in names))
    assert found is not None, "families with such data are refused"
    time = Value(None, "time", float(found[0]))
    facts: dict[str, Fact] = {
        "rate": rate,
        "acceleration": slope,
        "number": NumberOf(rate),
        "slope": NumberOf(slope),
        "time": NumberOf(time),
        "change": NumberOf(Value(None, rate.measure, float(found[0] * abs(task.variant.printed[names[1]])))),
    }
    return (Step(Sentence("given.graph"), [Sentence("given.read_from_graph", facts, False)]),)


def _centres(task: Task) -> dict[str, Symbol]:
    """Letters of velocity centres; they must not be those of points that the figure shows elsewhere."""
    form = task.form
    names = {body: form.symbols.get(body, body) for body in form.bodies}
    turning = {body: name for body, name in names.items() if body not in task.linkage.translating}
    plane = {body: name for body, name in turning.items() if not task.fixed & set(form.bodies[body])}
    now = task.now
    centres = [now.z[m[0]] + 1j * now.v[m[0]] / now.omega[b] for b in plane if (m := form.bodies[b]) and now.omega[b]]
    # A named point that is such a centre (the contact of a wheel) bears the letter already.
    others = [
        p for p in shown_points(task.variant, task.asked) if all(abs(now.z[p] - c) > CLOSE * task.size for c in centres)
    ]
    letters = centre_letters(plane, others)
    return {**{body: Symbol("P") for body in names}, **letters}


def _plan(headings: Sequence[Text]) -> Text:
    """The headings as a numbered list in one paragraph; nothing for a few, which are seen at a glance."""
    if len(headings) < _LONG:
        return ()
    parts: list[str | Formula] = []
    for number, heading in enumerate(headings, start=1):
        parts += [f"{'; ' if number > 1 else ''}{number})\N{NO-BREAK SPACE}", *heading]
    return (*parts, ".")


def _preface(found: Solution, writer: Writer) -> Text:
    """What is said before answers that were measured."""
    return (*writer.text(Sentence("graphical.answer")), " ") if found.approximate else ()


def _answer(
    variant: Variant, values: Sequence[tuple[Quantity, float]], language: Language, preface: Text = (), digits: int = 0
) -> Text:
    """The asked quantities with their values as in the key; measured ones with the ``digits`` that they are worth."""
    parts: list[str | Formula] = list(preface)
    length = variant.family.length_unit
    for position, (quantity, value) in enumerate(values):
        unit = language.unit(quantity.unit(length))
        symbol = language.quantity(quantity, variant.form.symbols)
        number = language.rounded(value, digits) if digits else language.answer(quantity, value)
        exact = None if digits else surd(value)
        shown: Formula = with_surd(Equation(symbol, Measured(number, unit)), exact)
        own, wanted = quantity.own_unit(length), quantity.unit(length)
        if own != wanted:  # what the steps led to, and the same in the unit that is wanted
            found = value * wanted.size / own.size
            before = language.rounded(found, digits) if digits else language.answer(quantity, found)
            shown = Relation((symbol, Measured(before, language.unit(own)), Measured(number, unit)), ("=", "="))
        parts += ["; " if position else "", shown]
    return (*parts, ".")
