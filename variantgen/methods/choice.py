"""Which methods a solution uses: those that are wished, or the natural ones of the problem."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from itertools import zip_longest

from msgspec import Struct
from msgspec.structs import replace

from variantgen.errors import InputError, Problem
from variantgen.methods.by_groups import solve_groups
from variantgen.methods.by_groups.group_methods import GROUP_METHODS
from variantgen.methods.linkage.problem import Task
from variantgen.methods.on_demand import on_demand
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.method_style import MethodStyle
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.methods.steps.step import Sentence


class WholeMethod(Struct, frozen=True):
    """A method for the whole problem: whether it applies, and how it writes its steps into a book.

    ``digits`` is the number of significant digits of its results where they are measured, 0 where they are computed.
    """

    applies: Callable[[Task], bool]
    solve: Callable[[Book], None]
    digits: int = 0


WHOLE: dict[str, WholeMethod] = {
    name: WholeMethod(on_demand(module, "applies"), on_demand(module, "solve"), digits)
    for name, module, digits in (
        ("analytical", "coordinates.analytical", 0),
        ("three_rates", "by_groups.three_rates", 0),
        ("graphical", "graphical.graphical", 3),  # what readings to 0.1 mm are worth
        ("coordinates", "coordinates.coordinates", 0),
    )
}


class Choice(Struct, frozen=True):
    """The style of a solution by groups, or the name of a method for the whole problem."""

    style: MethodStyle = MethodStyle()
    whole: str = ""


def choose(task: Task, wished: Sequence[str] = ()) -> Choice:
    """The choice for a task. Raises InputError for a wished method that does not apply, naming those that do.

    Where positions alone are asked, there is nothing to choose.
    """
    names = tuple(wished) or task.variant.family.solution
    if not task.sought:
        names = ()  # positions follow from the figure, before any method of velocities begins
    elif wished:
        _check(task, wished)
    return _choice(names, bool(wished))


@lru_cache(maxsize=512)
def _choice(names: tuple[str, ...], strict: bool) -> Choice:
    """The choice by the names of methods in the order in which they are preferred."""
    return Choice(replace(_style(names), strict=strict), next((name for name in names if name in WHOLE), ""))


def natural(task: Task) -> MethodStyle:
    """The methods of a computation group by group: those that the family names, else the usual ones."""
    return _style(task.variant.family.solution)


def _style(names: Sequence[str]) -> MethodStyle:
    """The first of the names for each order."""
    chosen = {order: name for order in (1, 2) for name in reversed(names) if name in _of_groups(order)}
    usual = MethodStyle()
    return MethodStyle(chosen.get(1, usual.velocities), chosen.get(2, usual.accelerations))


def _of_groups(order: int) -> list[str]:
    """The methods that a solution by groups may prefer for velocities (1) or accelerations (2)."""
    return [name for name, method in GROUP_METHODS.items() if order in method.orders and name not in WHOLE]


class _Problem(Struct, frozen=True):
    """What decides which methods apply; the task is any one of the kind."""

    family: str
    form: str
    asked: tuple[str, ...]
    task: Task

    @property
    def _kind(self) -> tuple[str, str, tuple[str, ...]]:
        return self.family, self.form, self.asked

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Problem) and self._kind == other._kind

    def __hash__(self) -> int:
        return hash(self._kind)


@lru_cache(maxsize=512)
def _fitting(problem: _Problem) -> tuple[str, ...]:
    return tuple(applicable(problem.task))


def _check(task: Task, wished: Sequence[str]) -> None:
    asked = tuple(quantity.name for quantity in task.asked)
    fit = _fitting(_Problem(task.variant.family.name, task.form.name, asked, task))
    wrong = [name for name in wished if name not in fit]
    if wrong:
        remedy = "it can be solved by: " + ", ".join(fit)
        problem = "the method does not apply to this problem"
        raise InputError([Problem(problem, key="method", value=name, remedy=remedy) for name in wrong])


def applicable(task: Task) -> list[str]:
    """Names of all methods that apply to a task, in alphabetical order.

    A method for groups of links applies where a solution that prefers it has a step or a sentence of it.
    """
    found = {name for name, method in WHOLE.items() if _applies(method, task)}
    usual = MethodStyle()
    for velocities, accelerations in zip_longest(_of_groups(1), _of_groups(2)):
        style = MethodStyle(velocities or usual.velocities, accelerations or usual.accelerations, strict=True)
        try:
            keys = _keys(task, style)
        except NOT_APPLICABLE:
            continue
        found |= {
            name for name, method in GROUP_METHODS.items() if any(key.startswith(method.sentences) for key in keys)
        }
    return sorted(found)


def _applies(method: WholeMethod, task: Task) -> bool:
    try:
        return method.applies(task)
    except NOT_APPLICABLE:
        return False


def _keys(task: Task, style: MethodStyle) -> set[str]:
    """The keys of all sentences of a solution in a style."""
    book = Book(task, style=style)
    solve_groups.solve_groups(book)
    found = {step.heading.key for step in book.steps}
    return found | {item.key for step in book.steps for item in step.items if isinstance(item, Sentence)}
