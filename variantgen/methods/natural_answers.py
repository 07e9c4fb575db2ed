"""The answers to which the steps of a solution lead, without writing it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from variantgen.algebra.expression import Value
from variantgen.methods.by_groups import solve_groups
from variantgen.methods.by_groups.answers import answer
from variantgen.methods.choice import WHOLE, Choice, choose
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.variants.attempts import VerificationError

Made = TypeVar("Made")

_FOR_ALL = "coordinates"  # the method that needs no order of the links


def natural_answers(task: Task) -> dict[str, Value]:
    """The answers to which the natural solution leads, by the names of the quantities, without writing it.

    Raises one of NOT_APPLICABLE where no method leads to what is asked, VerificationError where the answers of a scene
    of one's own are not the solver's.
    """
    return by_choice(task, choose(task), False, _confirmed if task.is_own_scene else found_by)


def by_choice(task: Task, choice: Choice, wished: bool, make: Callable[[Book, str], Made]) -> Made:
    """What is made with a book by the methods of a choice, or by the coordinate method where they lead nowhere."""
    failures: tuple[type[Exception], ...] = NOT_APPLICABLE
    if task.is_own_scene:
        failures += (VerificationError,)
    try:
        return make(Book(task, style=choice.style), choice.whole)
    except failures:
        if wished or choice.whole == _FOR_ALL:
            raise
        try:
            return make(Book(task), _FOR_ALL)
        except failures:
            pass  # what is said is why the natural methods fail
        raise


def found_by(book: Book, whole: str) -> dict[str, Value]:
    """The answers by a method for the whole problem if one is named, else group by group."""
    if not whole:
        return work_out(book)
    WHOLE[whole].solve(book)
    return {q.name: answer(book.at(max(1, q.order)), q) for q in book.task.asked}


def _confirmed(book: Book, whole: str) -> dict[str, Value]:
    """The answers, which are those of the solver."""
    # What confirms numbers is loaded for scenes of one's own: families are confirmed in batches.
    from variantgen.methods.agreement import confirm_answers

    found = found_by(book, whole)
    confirm_answers(book.task, found, method_names(book, whole))
    return found


def method_names(book: Book, whole: str) -> tuple[str, ...]:
    """The method for the whole problem, or those for velocities and accelerations."""
    return (whole,) if whole else (book.style.velocities, book.style.accelerations)


def work_out(book: Book) -> dict[str, Value]:
    """Velocities, then accelerations if any are asked; the answers by the names of the quantities, in their order."""
    task = book.task
    groups = solve_groups.velocities(book) if task.sought else []
    first = solve_groups.at_order(book, 1)
    found = {q.name: answer(first, q) for q in task.asked if q.order < 2}
    if task.order == 2:
        solve_groups.accelerations(book, groups)
        second = solve_groups.at_order(book, 2)
        found |= {q.name: answer(second, q) for q in task.asked if q.order == 2}
    return {q.name: found[q.name] for q in task.asked}
