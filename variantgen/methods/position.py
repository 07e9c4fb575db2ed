"""The step of the position: of what was worked out there, only what the solution uses, and the axes it is told in."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from variantgen.methods.expression import Value
from variantgen.methods.settle import facts_values, in_order, items_values
from variantgen.methods.step import Derived, Item, Projection, Sentence, Step, TermTable

_OF_AXES = ("direction", "x", "y")  # kinds of names that mean something only with axes


def with_position(items: Sequence[Item], steps: Sequence[Step], results: Iterable[Value]) -> list[Step]:
    """The steps that say something, after one of the position made of its ``items`` that they or the ``results`` need.

    Where an angle with the x axis or a component is met first, the axes are named.
    """
    told = [step for step in steps if step.items]
    kept = _used(items, [*(item for step in told for item in step.items)], results)
    if kept:
        told.insert(0, Step(Sentence("position.heading"), kept))
    first = next((step for step in told if any(map(_needs_axes, step.items))), None)
    if first is not None:
        first.items.insert(0, _axes(first.items))
    return told


def _axes(items: Sequence[Item]) -> Sentence:
    """The axes, with the name of the first direction as an example if there is one."""
    names = (item.value.name for item in items if isinstance(item, Derived))
    example = next((name for name in names if name is not None and name.kind == "direction"), None)
    return Sentence("position.axes") if example is None else Sentence("position.axes_and_rays", {"angle": example})


def _used(items: Sequence[Item], later: Sequence[Item], results: Iterable[Value]) -> list[Item]:
    """The items of the position without the lines of values that no other item is computed from."""
    roots = [value for item in later for value in _read(item)]
    roots += items_values(item for item in items if not isinstance(item, Derived))
    needed = {value.name for value in in_order([*roots, *results])}
    kept: list[Item] = []
    for item in items:
        if not isinstance(item, Derived) or item.value.name in needed:
            kept.append(item)
        elif kept and isinstance(kept[-1], Sentence) and kept[-1].key == "position.drawn":
            kept.pop()
    return kept


def _read(item: Item) -> list[Value]:
    """The values that a reader meets in an item: a table says directions in words, not by their angles."""
    if not isinstance(item, TermTable):
        return items_values([item])
    sizes = [term.size for term in item.terms if term.size is not None]
    return [*sizes, *(value for term in item.terms for value in facts_values(term.way))]


def _needs_axes(item: Item) -> bool:
    """Whether an item cannot be understood without axes."""
    if isinstance(item, Projection):
        return True
    name = item.value.name if isinstance(item, Derived) else None
    return name is not None and (name.kind in _OF_AXES or bool({"x", "y"} & set(name.part.split())))
