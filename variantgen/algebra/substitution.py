"""Values replaced by expressions, and what is zero at the given instant left out."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Magnitude,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Value,
    Variable,
)
from variantgen.algebra.normal_form import Maybe, added, product

_ROUNDING = 1e-12  # a cosine or a sine below it is zero, but for the rounding of a right angle in radians


def substituted(item: Expression, table: Mapping[Any, Expression]) -> Maybe:
    """An expression with values or variables replaced by what they stand for."""
    match item:
        case Value() | Variable():
            return table.get(item, item)
        case Total(terms):
            return added(*((sign, substituted(term, table)) for sign, term in terms))
        case Times(factors):
            return product(*(substituted(factor, table) for factor in factors))
        case Raised(base, exponent):
            inner = substituted(base, table)
            return None if inner is None else Raised(inner, exponent)
        case Ratio(above, below):
            upper, lower = substituted(above, table), substituted(below, table)
            return None if upper is None or lower is None else Ratio(upper, lower)
        case SquareRoot() | Magnitude():
            inner = substituted(item.inner, table)
            return None if inner is None else type(item)(inner)
        case Applied(function):
            return Applied(function, *(substituted(part, table) or Constant(0.0) for part in item.operands()))
    return item


def pruned(item: Maybe, unknown: Collection[Value] = ()) -> Maybe:
    """A sum of products without those that contain a value which is exactly zero at the given instant.

    An ``unknown`` value, which has no number yet, is not zero.
    """
    match item:
        case Value() if item.exact == 0 and item not in unknown:
            return None
        case Total(terms):
            return added(*((sign, pruned(term, unknown)) for sign, term in terms))
        case Times(factors):
            left = [pruned(factor, unknown) for factor in factors]
            return None if None in left else product(*left)
        case Raised(base, exponent):
            inner = pruned(base, unknown)
            return None if inner is None else Raised(inner, exponent)
        case Ratio(above, below):
            inner = pruned(above, unknown)
            return None if inner is None else Ratio(inner, below)
    return item


def vanishes(item: Expression) -> bool:
    """Whether a term is exactly zero at the given instant: by a factor that is, also ``sin 0`` or ``cos 90``."""
    match item:
        case Value():
            return item.exact == 0
        case Applied("cos" | "sin"):
            return abs(item.number(True)) < _ROUNDING
        case Total(terms):
            return all(vanishes(term) for _, term in terms)
        case Times(factors):
            return any(vanishes(factor) for factor in factors)
        case Raised(inner, _) | Ratio(inner, _) | SquareRoot(inner):
            return vanishes(inner)
    return False
