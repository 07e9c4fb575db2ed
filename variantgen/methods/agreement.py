"""Confirmation of solutions: what a book has found and what is printed, against the solved motion."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from variantgen.algebra.expression import Value
from variantgen.methods.beside_motion import BesideMotion
from variantgen.methods.linkage.problem import AGREES, Task
from variantgen.methods.printed_numbers import PrintedNumbers, text_of
from variantgen.methods.solution.book import Book, Known, resultant
from variantgen.methods.steps.step import Sentence, Solution, Step
from variantgen.variants.attempts import VerificationError


def deviation(book: Book) -> float:
    """The largest deviation of what a book has found, relative to the largest velocity or acceleration.

    Rates are compared as the velocities (accelerations) that they give at the size of the mechanism.
    """
    task, worst = book.task, 0.0
    for order in (1, 2) if task.order == 2 and task.now.accelerated else (1,):
        book = book.at(order)
        scale = book.scale or 1.0
        for point, terms in book.vectors.items():
            if point in task.now.v:
                worst = max(worst, abs(resultant(terms) - book.exact(point)) / scale)
        for terms, right in _relative_motion(book):
            worst = max(worst, abs(resultant(terms) - right) / max(scale, abs(right)))
        for body, rate in book.rates.items():
            worst = max(worst, abs(rate.sense * rate.size.exact - book.exact_rate(body)) * task.size / scale)
    return worst


def _relative_motion(book: Book) -> Iterator[tuple[Known, complex]]:
    """What was found of points that slide on bodies, and what the solver has for it; nothing of what was not sought."""
    now = book.task.now
    tables = [(book.relative, now.relative_velocity)]
    if book.order == 2:
        tables = [(book.relative_acceleration, now.relative_acceleration), (book.coriolis, now.coriolis)]
    for table, right in tables:
        for (point, body), terms in table.items():
            if terms and body in book.task.scene.bodies:
                yield terms, right(point, body)


def confirm(book: Book, solution: Solution, methods: Sequence[str]) -> None:
    """Raise VerificationError where a solution, or the book in which it was found, deviates from the solver.

    All that is printed is checked: each number, each equation, each answer with its sign. The message names the family,
    the methods, the step and the data.
    """
    found = deviation(book)
    if not found <= AGREES:
        raise _error(book.task, methods, "what was found for points and bodies", found)
    printed = PrintedNumbers(book.task, measured=solution.approximate > 0)
    for step in (*solution.steps, Step(Sentence("check"), list(solution.check))):
        for what, off in printed.step(step):
            if not off <= AGREES:
                raise _error(book.task, methods, f"{text_of(what)} in the step {step.heading.key}", off)
    confirm_answers(book.task, dict(solution.answers), methods)


def confirm_answers(task: Task, answers: Mapping[str, Value], methods: Sequence[str]) -> None:
    """Raise VerificationError where an answer (by the name of its quantity) is not the solver's, sign included."""
    beside = BesideMotion(task)
    for quantity in task.asked:
        off = beside.answer(quantity, answers[quantity.name])
        if not off <= AGREES:
            raise _error(task, methods, f"the answer {quantity.name}", off)


def _error(task: Task, methods: Sequence[str], what: str, off: float) -> VerificationError:
    variant, by = task.variant, ", ".join(methods)
    data = ", ".join(f"{name}={value}" for name, value in variant.printed.items())
    said = f"{variant.family.name}: the solution by {by} deviates from the solver: {what} is off by {off:.1e}"
    return VerificationError(said + (f" for {data}" if data else ""))
