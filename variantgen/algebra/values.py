"""What an expression is put together from, and values in the order in which they are computed."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from variantgen.algebra.expression import Expression, Value


def in_order(values: Iterable[Value], known: Collection[Value] = ()) -> list[Value]:
    """The values and all that they are computed from, each after those that it needs; without what is ``known``."""
    found: dict[Value, None] = {}

    def visit(item: Expression) -> None:
        if not isinstance(item, Value):
            for operand in item.operands():
                visit(operand)
        elif item not in found and item not in known:
            if item.expression is not None:
                visit(item.expression)
            found[item] = None

    for value in values:
        visit(value)
    return list(found)


def parts(item: Expression) -> list[Value]:
    """The values in an expression."""
    return [item] if isinstance(item, Value) else [value for operand in item.operands() for value in parts(operand)]


def walk(item: Expression) -> Iterator[Expression]:
    """The expression and all its parts."""
    yield item
    for operand in item.operands():
        yield from walk(operand)
