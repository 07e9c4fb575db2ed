"""Puts a solution together: the position, the steps of the chosen methods, the answers, printed numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import TypeVar

from variantgen.algebra.expression import Value
from variantgen.errors import InputError
from variantgen.families.quantities import Quantity
from variantgen.methods.agreement import confirm, confirm_answers
from variantgen.methods.by_groups import solve_groups
from variantgen.methods.by_groups.answers import answer
from variantgen.methods.choice import WHOLE, Choice, choose
from variantgen.methods.linkage.problem import Task
from variantgen.methods.magnitudes import magnitudes
from variantgen.methods.other_base_point import other_base_point
from variantgen.methods.result_check import by_links, equal_projections, third_axis
from variantgen.methods.solution.book import Book
from variantgen.methods.solution.position import with_position
from variantgen.methods.solution.second_reading import read_again
from variantgen.methods.solution.used import used_lines, used_steps
from variantgen.methods.step_figures import step_figures
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.methods.steps.point_vectors import PointVectors
from variantgen.methods.steps.printed_digits import choose_printed_digits, follow_printed_digits, items_values
from variantgen.methods.steps.step import Item, ProgramListing, Solution, Step
from variantgen.methods.vectors.point_vectors import point_vectors
from variantgen.methods.velocity_check import base_point_of_velocities
from variantgen.variants.attempts import VerificationError

Made = TypeVar("Made")

_FOR_ALL = "coordinates"  # the method that needs no order of the links
_LINK_BY_LINK = "three_rates"  # the method for a whole problem whose steps are those of its links


def solution(task: Task, wished: Sequence[str] = ()) -> Solution:
    """The solution of a task by the wished methods, or by its natural ones, ready to be written in a language.

    A mechanism that cannot be gone through link by link is solved by the coordinate method, and so is a scene of one's
    own whose natural solution cannot be confirmed: nobody has checked its methods. Raises InputError for a method that
    does not apply, one of NOT_APPLICABLE where no method leads to what is asked, VerificationError where anything that
    is printed deviates from the solver.
    """
    return _by_choice(task, choose(task, wished), bool(wished), _written)


def natural_answers(task: Task) -> dict[str, Value]:
    """The answers to which the natural solution leads, by the names of the quantities, without writing it.

    Raises one of NOT_APPLICABLE where no method leads to what is asked, VerificationError where the answers of a scene
    of one's own are not the solver's.
    """
    return _by_choice(task, choose(task), False, _confirmed if _is_own_scene(task) else _found)


def _by_choice(task: Task, choice: Choice, wished: bool, make: Callable[[Book, str], Made]) -> Made:
    """What is made with a book by the methods of a choice, or by the coordinate method where they lead nowhere."""
    failures: tuple[type[Exception], ...] = NOT_APPLICABLE
    if _is_own_scene(task):
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


def _is_own_scene(task: Task) -> bool:
    """Whether the mechanism is that of a file by itself, not of a family that is checked."""
    return task.variant.family.folder is None


def _found(book: Book, whole: str) -> dict[str, Value]:
    """The answers by a method for the whole problem if one is named, else group by group."""
    if not whole:
        return work_out(book)
    WHOLE[whole].solve(book)
    return {q.name: answer(book.at(max(1, q.order)), q) for q in book.task.asked}


def _confirmed(book: Book, whole: str) -> dict[str, Value]:
    """The answers, which are those of the solver."""
    found = _found(book, whole)
    confirm_answers(book.task, found, _names(book, whole))
    return found


def _names(book: Book, whole: str) -> tuple[str, ...]:
    return (whole,) if whole else (book.style.velocities, book.style.accelerations)


def _written(book: Book, whole: str) -> Solution:
    """The solution with its printed numbers, confirmed."""
    found = _found(book, whole)
    written = _by_one_method(book, whole, found) if whole else _by_groups(book, found)
    confirm(book, written, _names(book, whole))
    return written


def _by_groups(book: Book, found: dict[str, Value]) -> Solution:
    """The solution group by group."""
    task = book.task
    steps = used_steps(book.steps, found.values())
    check = tuple(third_axis(steps) or other_base_point(book, steps))
    # Only what answers need is compared: the check of velocities works out no angular velocity of its own.
    check = check or tuple(base_point_of_velocities(book, used_lines(steps, found.values())))
    check = check or tuple(equal_projections(book) or magnitudes(book, steps))
    results = [*found.values(), *items_values(check)]
    steps = used_lines(steps, results)
    steps = with_position(task, book.geometry.items, steps, results)
    steps = read_again(steps, results)
    choose_printed_digits([*(item for step in steps for item in step.items), *check], list(found.values()))
    centres, vectors = _acceleration_centres(book), _vectors(book, steps)
    steps, geometry = step_figures(task, steps, vectors)
    return Solution(tuple(steps), tuple(found.items()), check, 0, centres, vectors, geometry)


def named_vectors(task: Task, methods: Sequence[str] = ()) -> tuple[PointVectors, ...]:
    """The vectors of a solution by the ``methods``, or by the natural ones where they do not apply.

    Those of the points alone where no method leads to what is asked.
    """
    for wished in dict.fromkeys((tuple(methods), ())):
        with suppress(InputError, *NOT_APPLICABLE):
            return solution(task, wished).vectors
    return _vectors(Book(task), ())


def _vectors(book: Book, steps: Sequence[Step]) -> tuple[PointVectors, ...]:
    """What figures draw of each order that is asked."""
    return tuple(point_vectors(book, steps, order) for order in range(1, book.task.order + 1))


def _acceleration_centres(book: Book) -> tuple[Quantity, ...]:
    """The rays to centres of accelerations that the solution speaks of: what figures show besides what is asked."""
    centres = [centre for centre in book.centres.values() if centre.kind == "Q" and not centre.infinite]
    return tuple(Quantity("Q", centre.body, point) for centre in centres for point in centre.rays)


def _by_one_method(book: Book, name: str, found: dict[str, Value]) -> Solution:
    """The solution by a method for the whole problem; one by measuring has the digits that a ruler gives."""
    measured = WHOLE[name].digits
    # A program comes last, after what answers still needed.
    ordered = sorted(book.steps, key=lambda step: any(isinstance(item, ProgramListing) for item in step.items))
    if name == _LINK_BY_LINK:
        ordered = used_lines(ordered, found.values())
    steps = with_position(book.task, book.geometry.items, ordered, found.values())
    if not measured:
        steps = read_again(steps, found.values())
    check = tuple(_checked_by_links(book.task) if measured else third_axis(steps))
    items, answers = [*(item for step in steps for item in step.items), *check], list(found.values())
    if measured:
        follow_printed_digits(items, answers, measured + 1)
    else:
        choose_printed_digits(items, answers)
    vectors = _vectors(book, steps)
    steps, geometry = step_figures(book.task, steps, vectors)
    return Solution(tuple(steps), tuple(found.items()), check, measured, (), vectors, geometry)


def _checked_by_links(task: Task) -> list[Item]:
    """The check by going through the links; nothing where that does not lead to the answers."""
    book = Book(task)
    try:
        found = work_out(book)
    except NOT_APPLICABLE:
        return []
    confirm_answers(task, found, (book.style.velocities, book.style.accelerations))
    return by_links(found)


def work_out(book: Book) -> dict[str, Value]:
    """Velocities, then accelerations if any are asked; the answers by the names of the quantities, in their order."""
    task = book.task
    groups = solve_groups.velocities(book) if task.sought else []
    found = {q.name: answer(solve_groups.at_order(book, 1), q) for q in task.asked if q.order < 2}
    if task.order == 2:
        solve_groups.accelerations(book, groups)
        found |= {q.name: answer(solve_groups.at_order(book, 2), q) for q in task.asked if q.order == 2}
    return {q.name: found[q.name] for q in task.asked}
