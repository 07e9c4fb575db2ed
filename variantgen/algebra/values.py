"""What an expression is put together from, and values in the order in which they are computed."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from variantgen.algebra.expression import Constant, Expression, Value


def in_order(values: Iterable[Value], known: Collection[Value] = ()) -> list[Value]:
    """The values and all that they are computed from, each after those that it needs; without what is ``known``."""
    found: dict[Value, None] = {}
    _find(values, known, found)
    return list(found)


def _find(values: Iterable[Value], known: Collection[Value], found: dict[Value, None]) -> None:
    for value in values:
        if value not in found and value not in known:
            if inner := made_of(value):
                _find(inner, known, found)
            found[value] = None


def made_of(value: Value) -> tuple[Value, ...]:
    """The values in its expression, from left to right; found once, because every pass over a solution asks it."""
    whole, found = value.made_of
    if whole is not value.expression:
        whole = value.expression
        found = () if whole is None else tuple(parts(whole))
        value.made_of = whole, found
    return found


def parts(item: Expression) -> list[Value]:
    """The values in an expression, from left to right."""
    if isinstance(item, Value):
        return [item]
    found: list[Value] = []
    for operand in item.operands():
        if isinstance(operand, Value):
            found.append(operand)
        elif not isinstance(operand, Constant):
            found += parts(operand)
    return found


def walk(item: Expression) -> Iterator[Expression]:
    """The expression and all its parts, from left to right."""
    waiting = [item]
    while waiting:
        part = waiting.pop()
        yield part
        waiting += reversed(part.operands())
