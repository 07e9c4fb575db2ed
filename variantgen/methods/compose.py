"""Puts a solution together: the position, the steps of the chosen methods, the answers, printed numbers."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

from variantgen.algebra.expression import Value
from variantgen.errors import InputError
from variantgen.families.quantities import Quantity
from variantgen.methods.agreement import confirm, confirm_answers
from variantgen.methods.checks.check import check_of, third_axis_of
from variantgen.methods.checks.result_check import by_links
from variantgen.methods.choice import WHOLE, choose
from variantgen.methods.linkage.problem import Task
from variantgen.methods.natural_answers import by_choice, found_by, method_names, work_out
from variantgen.methods.on_demand import on_demand
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

_instant_steps = on_demand("by_groups.found_instant", "instant_steps")
_LINK_BY_LINK = "three_rates"  # the method for a whole problem whose steps are those of its links


def solution(task: Task, wished: Sequence[str] = ()) -> Solution:
    """The solution of a task by the wished methods, or by its natural ones, ready to be written in a language.

    A mechanism that cannot be gone through link by link is solved by the coordinate method, and so is a scene of one's
    own whose natural solution cannot be confirmed: nobody has checked its methods. Raises InputError for a method that
    does not apply, one of NOT_APPLICABLE where no method leads to what is asked, VerificationError where anything that
    is printed deviates from the solver.
    """
    return by_choice(task, choose(task, wished), bool(wished), _written)


def _written(book: Book, whole: str) -> Solution:
    """The solution with its printed numbers, confirmed."""
    found = found_by(book, whole)
    written = _by_one_method(book, whole, found) if whole else _by_groups(book, found)
    confirm(book, written, method_names(book, whole))
    return written


def _by_groups(book: Book, found: dict[str, Value]) -> Solution:
    """The solution group by group."""
    task = book.task
    steps = used_steps(book.steps, found.values())
    check = check_of(book, steps, list(found.values()))
    results = [*found.values(), *items_values(check)]
    steps = used_lines(steps, results)
    steps = [*_found_instant(book), *with_position(task, book.geometry.items, steps, results)]
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


def _found_instant(book: Book) -> list[Step]:
    """The step that finds the instant, where it is not given: what it needs is loaded for few forms."""
    found: list[Step] = _instant_steps(book) if book.task.form.found_instant is not None else []
    return found


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
    steps = [*_found_instant(book), *with_position(book.task, book.geometry.items, ordered, found.values())]
    if not measured:
        steps = read_again(steps, found.values())
    check = tuple(_checked_by_links(book.task)) if measured else third_axis_of(steps, list(found.values()))
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
