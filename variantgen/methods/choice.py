"""Which methods a solution uses: those that are wished, or the natural ones of the problem."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

from variantgen.errors import InputError, Problem
from variantgen.methods.by_groups import solve_groups, three_rates
from variantgen.methods.coordinates import analytical, coordinates
from variantgen.methods.graphical import graphical
from variantgen.methods.linkage.problem import Task
from variantgen.methods.solution.book import Book
from variantgen.methods.steps.method_style import Accelerations, MethodStyle, Velocities
from variantgen.methods.steps.not_applicable import NOT_APPLICABLE
from variantgen.methods.steps.step import Sentence

_VELOCITIES: dict[str, Velocities] = {
    "velocity_centre": "velocity_centre",
    "projections": "projections",
    "velocity_pole": "pole",
}
_ACCELERATIONS: dict[str, Accelerations] = {"acceleration_pole": "pole", "acceleration_centre": "acceleration_centre"}


@dataclass(frozen=True)
class WholeMethod:
    """A method for the whole problem: whether it applies, and how it writes its steps into a book.

    ``digits`` is the number of significant digits of its results where they are measured, 0 where they are computed.
    """

    applies: Callable[[Task], bool]
    solve: Callable[[Book], None]
    digits: int = 0


WHOLE: dict[str, WholeMethod] = {
    "analytical": WholeMethod(analytical.applies, analytical.solve),
    "three_rates": WholeMethod(three_rates.applies, three_rates.solve),
    "graphical": WholeMethod(graphical.applies, graphical.solve, graphical.ANSWER_DIGITS),
    "coordinates": WholeMethod(coordinates.applies, coordinates.solve),
}


@dataclass(frozen=True)
class Choice:
    """The style of a solution by groups, or the name of a method for the whole problem."""

    style: MethodStyle = MethodStyle()
    whole: str = ""


def choose(task: Task, wished: Sequence[str] = ()) -> Choice:
    """The choice for a task. Raises InputError for a wished method that does not apply, naming those that do."""
    names = tuple(wished) or task.variant.family.solution
    if wished:
        _check(task, wished)
    return Choice(_style(names), next((name for name in names if name in WHOLE), ""))


def natural(task: Task) -> MethodStyle:
    """The methods of a computation group by group: those that the family names, else the usual ones."""
    return _style(task.variant.family.solution)


def _style(names: Sequence[str]) -> MethodStyle:
    velocities = next((_VELOCITIES[name] for name in names if name in _VELOCITIES), MethodStyle().velocities)
    accelerations = next(
        (_ACCELERATIONS[name] for name in names if name in _ACCELERATIONS), MethodStyle().accelerations
    )
    return MethodStyle(velocities, accelerations)


@dataclass(frozen=True)
class _Problem:
    """What decides which methods apply; the task is any one of the kind."""

    family: str
    form: str
    asked: tuple[str, ...]
    task: Task = field(compare=False)


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
    for style in (MethodStyle(), MethodStyle("projections", "acceleration_centre"), MethodStyle("pole")):
        try:
            keys = _keys(task, style)
        except NOT_APPLICABLE:
            continue
        found |= {name for name, starts in _MARKS.items() if any(key.startswith(starts) for key in keys)}
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


# How the keys of the sentences of each method begin.
_MARKS = {
    "velocity_centre": ("velocity_centre.", "contact.wheel", "known_centre."),
    "projections": ("projections.",),
    "velocity_pole": ("pole.choose_v", "pole.crossing_v", "points.sum_v"),
    "acceleration_pole": ("pole.choose_a", "pole.crossing_a", "points.sum_a", "points.sum_wheel"),
    "acceleration_centre": ("acceleration_centre.",),
    "relative_motion": ("relative.",),
}
