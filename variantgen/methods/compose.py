"""Puts a solution together: the position, the steps of the chosen methods, the answers, printed numbers."""

from __future__ import annotations

from variantgen.methods import graphical, walk
from variantgen.methods.answers import answer
from variantgen.methods.book import Book
from variantgen.methods.check import equal_projections
from variantgen.methods.expression import Value
from variantgen.methods.settle import settle
from variantgen.methods.step import Sentence, Solution, Step
from variantgen.methods.task import Task


def solution(task: Task) -> Solution:
    """The solution of a task by its natural methods, ready to be written in a language."""
    book = Book(task)
    found = work_out(book)
    check = tuple(equal_projections(book))
    steps = _with_position(book)
    settle([*(item for step in steps for item in step.items), *check], list(found.values()))
    return Solution((), tuple(steps), tuple(found.items()), check)


def graphical_solution(task: Task) -> Solution:
    """The solution of a task by velocity and acceleration plans, with the numbers that a ruler gives."""
    book = Book(task)
    graphical.prepare(book)
    found = work_out(book)
    steps = _with_position(book)
    settle((item for step in steps for item in step.items), list(found.values()), (graphical.DIGITS,))
    return Solution((), tuple(steps), tuple(found.items()), approximate=graphical.ANSWER_DIGITS)


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
