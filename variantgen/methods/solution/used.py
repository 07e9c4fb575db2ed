"""Leaves out the steps that only find what nothing else in a solution is computed from."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name
from variantgen.algebra.values import in_order
from variantgen.methods.steps.printed_digits import facts_values, items_values
from variantgen.methods.steps.step import Derived, Item, Projection, Step, TermTable


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


def _names(values: Iterable[Value]) -> set[Name]:
    return {value.name for value in values if value.name is not None}


def read(item: Item) -> list[Value]:
    """The values that a reader meets in an item: a table says directions in words, not by their angles."""
    if isinstance(item, TermTable):
        sizes = [term.size for term in item.terms if term.size is not None]
        return [*sizes, *(value for term in item.terms for value in facts_values(term.way))]
    if isinstance(item, Projection):
        sizes = [share.term.size for share in (*item.left, *item.right) if share.term.size is not None]
        return [*sizes, *items_values([item])]
    return items_values([item])
