"""Puts a solution together: the position, the steps of the chosen methods, the answers, printed numbers."""

from __future__ import annotations

from collections.abc import Sequence

from variantgen.methods import walk
from variantgen.methods.answers import answer
from variantgen.methods.book import Book
from variantgen.methods.check import all_constraints, equal_projections
from variantgen.methods.choice import WHOLE, WholeMethod, choose
from variantgen.methods.expression import Value
from variantgen.methods.settle import DIGITS, settle
from variantgen.methods.step import Sentence, Solution, Step
from variantgen.methods.task import Task


def solution(task: Task, wished: Sequence[str] = ()) -> Solution:
    """The solution of a task by the wished methods, or by its natural ones, ready to be written in a language.

    Raises InputError for a method that does not apply, LookupError where the methods do not lead to what is asked.
    """
    choice = choose(task, wished)
    book = Book(task, style=choice.style)
    if choice.whole:
        return _by_one_method(book, WHOLE[choice.whole])
    found = work_out(book)
    check = (*equal_projections(book), *all_constraints(task, found))
    steps = _with_position(book)
    settle([*(item for step in steps for item in step.items), *check], list(found.values()))
    return Solution(tuple(steps), tuple(found.items()), check)


def _by_one_method(book: Book, method: WholeMethod) -> Solution:
    """The solution by a method for the whole problem; one by measuring has the digits that a ruler gives."""
    method.solve(book)
    found = {}
    for quantity in book.task.asked:
        book.order = quantity.order
        found[quantity.name] = answer(book, quantity)
    steps = _with_position(book)
    digits = (method.digits + 1,) if method.digits else DIGITS
    settle((item for step in steps for item in step.items), list(found.values()), digits)
    return Solution(tuple(steps), tuple(found.items()), approximate=method.digits)


def work_out(book: Book) -> dict[str, Value]:
    """Velocities, then accelerations if any are asked; the answers by the names of the quantities, in their order."""
    task = book.task
    groups = walk.velocities(book)
    found = {q.name: answer(book, q) for q in task.asked if q.order == 1}
    if task.order == 2:
        walk.accelerations(book, groups)
        found |= {q.name: answer(book, q) for q in task.asked if q.order == 2}
    return {q.name: found[q.name] for q in task.asked}


def _with_position(book: Book) -> list[Step]:
    """The steps that say something, after the one of the position if anything had to be worked out there."""
    first = [Step(Sentence("position.heading"), book.geometry.items)] if book.geometry.items else []
    return [*first, *(step for step in book.steps if step.items)]
