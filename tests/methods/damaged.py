"""Methods with a wrong formula: what is worked out with it, and all that follows, is wrong in itself."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from variantgen.algebra.expression import Expression, Value
from variantgen.algebra.name import Name
from variantgen.methods.solution.book import Book

Damage = Callable[[Expression], Expression]


def damage_formulas(monkeypatch: pytest.MonkeyPatch, symbol: str, damage: Damage) -> list[Value]:
    """Damage the formula by which a value is derived wherever the symbol fits; returns the values that were damaged.

    The symbol is the kind with the parts (``a n``), and if need be the target and the pole (``a n B A``).
    """
    right, found = Book.derive, []

    def derive(book: Book, name: Name, measure: str, expression: Expression, law: Expression | None = None) -> Value:
        parts = f"{name.kind} {name.part}".strip()
        if symbol not in (parts, f"{parts} {name.of} {name.about}".strip()):
            return right(book, name, measure, expression, law)
        value = right(book, name, measure, damage(expression), law)
        found.append(value)
        return value

    monkeypatch.setattr(Book, "derive", derive)
    return found
