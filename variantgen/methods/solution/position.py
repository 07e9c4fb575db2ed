"""The step of the position: of what was worked out there, only what the solution uses, and its axes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.algebra.values import in_order
from variantgen.methods.linkage.problem import CLOSE, Task
from variantgen.methods.solution.used import read
from variantgen.methods.steps.printed_digits import items_values
from variantgen.methods.steps.step import (
    Derived,
    EquationLine,
    Fact,
    Item,
    Point,
    Sentence,
    Step,
    VectorLine,
)
from variantgen.variants.printed_data import shown_points

_PARTS = {"x": "real", "y": "imag"}  # of a complex number
_OF_AXES = ("direction", "heading", "x", "y")  # kinds of names that mean something only with axes
# Sentences that say what the angle or length in the next line is.
_OF_NEXT = (
    "position.drawn",
    "position.law_angle",
    "position.perpendicular",
    "position.perpendicular_beyond",
    "position.projections",
    "position.radius",
    *(f"position.triangle_{shape}" for shape in ("sides", "height", "isosceles", "half_square", "right", "sines")),
    *(f"position.triangle_sides_{side}" for side in ("above", "below", "right", "left")),
    *(f"position.inclination_{line}" for line in ("guide", "link", "horizontal", "vertical")),
)
_LETTERS = ("psi", "beta", "gamma", "delta", "lambda")  # of angles without points


def with_position(task: Task, items: Sequence[Item], steps: Sequence[Step], results: Iterable[Value]) -> list[Step]:
    """The steps that say something, after one of the position made of its ``items`` that they or the ``results`` need.

    Where an angle with the x axis or a component is met first, the axes are named.
    """
    written = [step for step in steps if step.items]
    kept = _used(items, [*(item for step in written for item in step.items)], results)
    kept = _put_off(task, kept, written)
    if kept:
        written.insert(0, Step(Sentence("position.heading"), kept))
    first = next((step for step in written if any(map(_needs_axes, step.items))), None)
    if first is not None:
        first.items[:0] = [_axes(first.items), *_origin(task, [item for step in written for item in step.items])]
    _give_letters(task, written)
    return written


def _give_letters(task: Task, steps: Sequence[Step]) -> None:
    """Greek letters for angles without points, in the order in which they are met; when used up, with numbers."""
    form = task.form
    taken = {*form.parameters, *form.symbols.values()}
    if "alpha" in taken:  # which is delta where alpha is an angular acceleration
        taken.add("delta")
    letters = [letter for letter in _LETTERS if letter not in taken]
    values = dict.fromkeys(item.value for step in steps for item in step.items if isinstance(item, Derived))
    angles = (value for value in values if value.name is not None and value.name.kind == "inclination")
    for number, value in enumerate(angles):
        again, place = divmod(number, len(letters))
        value.name = Name("inclination", letters[place], str(again) if again else "")


def _is_of_next(item: Item) -> bool:
    """Whether an item is a sentence that says what the next line is."""
    return isinstance(item, Sentence) and item.key in _OF_NEXT


def _axes(items: Sequence[Item]) -> Sentence:
    """The axes; where directions are worked out, how they are measured, with the first as an example."""
    names = (item.value.name for item in items if isinstance(item, Derived))
    example = next((name for name in names if name is not None and name.kind in ("direction", "heading")), None)
    return (
        Sentence("position.axes", {}, detail=False)
        if example is None
        else Sentence("position.axes_and_rays", {"angle": example}, detail=False)
    )


def _origin(task: Task, items: Iterable[Item]) -> list[Sentence]:
    """Where the origin is, if coordinates of points are met: a point, or zero coordinates of some."""
    names = {value.name for item in items for value in _met(item) if value.name is not None}
    points = sorted({name.of for name in names if name.kind in ("x", "y") and name.of in task.now.z})
    if not points:
        return []
    shown, near = shown_points(task.variant, task.asked), CLOSE * task.size
    at = next((point for point in shown if abs(task.now.z[point]) < near), None)
    if at is not None:
        return [Sentence("position.origin", {"at": Point(at)}, detail=False)]
    zeros: list[Fact] = []
    for axis in ("x", "y"):  # of points that are met, else of any
        zero = [Name(axis, point) for point in shown if abs(getattr(task.now.z[point], _PARTS[axis])) < near]
        zeros += [name for name in zero if name.of in points] or zero
    return [Sentence("position.origin_by", {"zeros": tuple(zeros)}, detail=False)] if len(zeros) > 1 else []


def _used(items: Sequence[Item], later: Sequence[Item], results: Iterable[Value]) -> list[Item]:
    """The items of the position without the lines of values that no other item is computed from."""
    roots = [value for item in later for value in read(item)]
    roots += items_values(item for item in items if not isinstance(item, Derived) and not _is_of_next(item))
    needed = {value.name for value in in_order([*roots, *results])}
    kept: list[Item] = []
    for item in items:
        if not isinstance(item, Derived) or item.value.name in needed:
            kept.append(item)
        elif kept and _is_of_next(kept[-1]):
            kept.pop()
    return kept


def _put_off(task: Task, items: Sequence[Item], steps: Sequence[Step]) -> list[Item]:
    """Move lines of points that the statement does not show to the step that needs them first: it names the points.

    A length alone makes no step either: the distance of two centres is found where it is used. What says what a line
    is goes with it. Returns the lines that stay: also those which another line that stays is computed from.
    """
    shown = shown_points(task.variant, task.asked)
    stay: list[Item] = []
    moved: tuple[Step, int] | None = None  # where the next line went
    for item in reversed(items):
        if moved is not None and _is_of_next(item):
            moved[0].items.insert(moved[1], item)
            continue
        moved = None
        others = isinstance(item, Derived) and _is_of_others(item.value, shown)
        alone = not others and len(items) == 1 and _kind(item) == "length"
        if isinstance(item, Derived) and (alone or others) and not _reads(stay, item.value):
            goal = next((step for step in steps if _reads(step.items, item.value)), None)
            if goal is not None:
                first = next(i for i, later in enumerate(goal.items) if _reads([later], item.value))
                # Nothing comes between a vector equation and its projections.
                equation = any(isinstance(earlier, VectorLine) for earlier in goal.items[:first])
                moved = goal, 0 if alone or equation else first
                goal.items.insert(moved[1], item)
                continue
        stay.insert(0, item)
    return stay


def _kind(item: Item) -> str:
    """The kind of the value that a line works out, if it has a name."""
    return item.value.name.kind if isinstance(item, Derived) and item.value.name is not None else ""


def _is_of_others(value: Value, shown: Sequence[str]) -> bool:
    """Whether a value is a distance or direction of a point that is not ``shown``."""
    name = value.name
    return name is not None and name.kind in ("length", "direction") and not {name.of, name.about} <= set(shown)


def _reads(items: Iterable[Item], value: Value) -> bool:
    """Whether one of the items is computed from a value."""
    return value in in_order(found for item in items for found in read(item))


def _needs_axes(item: Item) -> bool:
    """Whether an item cannot be understood without axes."""
    names = (value.name for value in _met(item) if value.name is not None)
    return any(name.kind in _OF_AXES or {"x", "y"} & set(name.part.split()) for name in names)


def _met(item: Item) -> list[Value]:
    """The values that have a symbol in an equation, or on the left of a line."""
    return [item.value] if isinstance(item, Derived) else items_values([item]) if isinstance(item, EquationLine) else []
