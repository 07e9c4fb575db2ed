"""Leaves out the steps and lines that only find what nothing else in a solution is computed from."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.algebra.values import in_order, parts
from variantgen.methods.steps.printed_digits import facts_values, items_values
from variantgen.methods.steps.step import Derived, Item, Projection, Step, TermTable

_QUIET = ("length", "angle", "direction", "parameter")  # kinds that nothing but formulas needs


def used_steps(steps: Sequence[Step], results: Iterable[Value]) -> list[Step]:
    """The steps of which a later one or the ``results`` need a value; those that derive none are kept.

    A step that finds a zero is kept too: it explains why a vector is absent from a later equation. What an earlier step
    has found already is no reason to keep one that writes it down again.
    """
    needed = set(in_order(results))
    names = _names(needed)
    derived = [[item.value for item in step.items if isinstance(item, Derived)] for step in steps]
    first: dict[Name | None, int] = {}
    for number, values in enumerate(derived):
        for value in values:
            first.setdefault(value.name, number)
    kept: list[Step] = []
    for number, step in reversed(list(enumerate(steps))):
        values = derived[number]
        found = {value.name for value in values if first[value.name] == number}
        if not values or found & names or any(value.exact == 0 for value in values):
            kept.append(step)
            more = in_order((value for item in step.items for value in read(item)), needed)
            needed.update(more)
            names |= _names(more)
    return kept[::-1]


def used_lines(steps: Sequence[Step], results: Iterable[Value]) -> list[Step]:
    """The steps without the lines of which no later line and no result needs the value.

    Lengths, angles and what follows from data only: of vectors and rates there are sentences.
    """
    names = _names(in_order(results))
    kept: list[Step] = []
    for step in reversed(steps):
        items: list[Item] = []
        for item in reversed(step.items):
            if isinstance(item, Derived) and _is_idle(item, names):
                continue
            items.append(item)
            names |= _names(in_order(read(item)))
        kept.append(replace(step, items=items[::-1]))
    return kept[::-1]


def _is_idle(item: Derived, needed: Collection[Name]) -> bool:
    """Whether a line finds only what is not needed."""
    name, found = item.value.name, item.symbolic and item.value.exact != 0
    return found and name is not None and name.kind in _QUIET and name not in needed


def _names(values: Iterable[Value]) -> set[Name]:
    return {value.name for value in values if value.name is not None}


def read(item: Item) -> list[Value]:
    """The values that a reader meets in an item: a table says directions in words, not by their angles.

    Of a law only the lengths: they show why it comes down to what follows.
    """
    if isinstance(item, Derived) and item.law is not None:
        return [item.value, *(value for value in parts(item.law) if value.measure == "length")]
    if isinstance(item, TermTable):
        sizes = [term.size for term in item.terms if term.size is not None]
        return [*sizes, *(value for term in item.terms for value in facts_values(term.way))]
    if isinstance(item, Projection):
        sizes = [share.term.size for share in (*item.left, *item.right) if share.term.size is not None]
        return [*sizes, *items_values([item])]
    return items_values([item])
