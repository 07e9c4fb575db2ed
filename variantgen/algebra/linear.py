"""Linear equations: coefficients of the unknowns, common numbers divided out, the solution of a system."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from msgspec import Struct

from variantgen.algebra.expression import Constant, Expression, Ratio, Times, Total, Value, Variable
from variantgen.algebra.normal_form import Maybe, added, product
from variantgen.algebra.values import parts, walk

_ONE = Constant(1.0)


class LinearSolution(Expression, Struct, frozen=True):
    """One unknown of a system of linear equations: ``rows`` of coefficients, right-hand sides, its number."""

    rows: tuple[tuple[Expression, ...], ...]
    right: tuple[Expression, ...]
    index: int

    def number(self, exact: bool) -> float:
        """The unknown. Raises numpy.linalg.LinAlgError for a singular system."""
        matrix = np.array([[item.number(exact) for item in row] for row in self.rows])
        right = np.array([item.number(exact) for item in self.right])
        return float(np.linalg.solve(matrix, right)[self.index])

    def operands(self) -> Sequence[Expression]:
        """The right-hand sides, then the coefficients row by row."""
        return (*self.right, *(item for row in self.rows for item in row))


def linear(item: Maybe, unknowns: Collection[Value]) -> tuple[dict[Value, Expression], Maybe]:
    """Coefficients of the unknowns in an expression that is linear in them, and the rest.

    Raises TypeError for an expression that is not linear.
    """
    if item is None:
        return {}, None
    if not any(value in unknowns for value in parts(item)):
        return {}, item
    match item:
        case Value():
            return {item: _ONE}, None
        case Total(terms):
            return _sum_of_forms([(sign, linear(term, unknowns)) for sign, term in terms])
        case Times(factors):
            inside = [i for i, factor in enumerate(factors) if any(v in unknowns for v in parts(factor))]
            if len(inside) == 1:
                others = [*factors[: inside[0]], *factors[inside[0] + 1 :]]
                found, rest = linear(factors[inside[0]], unknowns)
                scaled = {v: product(c, *others) for v, c in found.items()}
                return {v: c for v, c in scaled.items() if c is not None}, product(rest, *others)
        case Ratio(above, below):
            found, rest = linear(above, unknowns)
            return {v: Ratio(c, below) for v, c in found.items()}, None if rest is None else Ratio(rest, below)
    raise TypeError(f"not linear: {item!r}")


def is_linear(item: Expression, names: Collection[str]) -> bool:
    """Whether an expression is a sum of these names with numbers as factors; other names stand for numbers."""
    match item:
        case Variable():
            return True
        case Total(terms):
            return all(is_linear(term, names) for _, term in terms)
        case Times(factors):
            moving = [factor for factor in factors if not _is_free(factor, names)]
            return not moving or (len(moving) == 1 and is_linear(moving[0], names))
        case Ratio(above, below):
            return is_linear(above, names) and _is_free(below, names)
    return _is_free(item, names)


def _is_free(item: Expression, names: Collection[str]) -> bool:
    """Whether none of the names stands in an expression."""
    return not any(isinstance(part, Variable) and part.name in names for part in walk(item))


def _sum_of_forms(
    forms: list[tuple[int, tuple[dict[Value, Expression], Maybe]]],
) -> tuple[dict[Value, Expression], Maybe]:
    rest = added(*((sign, rest) for sign, (_, rest) in forms))
    values = dict.fromkeys(value for _, (found, _) in forms for value in found)
    sums = {v: added(*((sign, found.get(v)) for sign, (found, _) in forms)) for v in values}
    return {v: c for v, c in sums.items() if c is not None}, rest


def reduced(left: Maybe, right: Maybe) -> tuple[Maybe, Maybe]:
    """Both sides of an equation without the number that all their terms have in common."""
    terms = [*_terms(left), *_terms(right)]
    numbers = {_number(term) for _, term in terms}
    if len(numbers) != 1 or numbers == {1.0}:
        return left, right
    one = _ONE.value / numbers.pop()
    return tuple(  # type: ignore[return-value]
        added(*((sign, product(Constant(one), term)) for sign, term in _terms(side))) for side in (left, right)
    )


def _terms(side: Maybe) -> tuple[tuple[int, Expression], ...]:
    if side is None:
        return ()
    return side.terms if isinstance(side, Total) else ((1, side),)


def _number(term: Expression) -> float:
    first = term.factors[0] if isinstance(term, Times) else term
    return first.value if isinstance(first, Constant) else 1.0
