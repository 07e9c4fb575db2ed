"""The derivative of an expression: by time with the rates of what changes, or by one of its names."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeAlias

from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Value,
    Variable,
    cos,
    sin,
)
from variantgen.algebra.normal_form import Maybe, added, product

Rates: TypeAlias = Mapping[Any, Maybe]  # by value or variable
_ONE = Constant(1.0)
# The derivative of a function by its argument.
_OUTER: dict[str, Callable[[Expression], Expression]] = {
    "sin": cos,
    "cos": lambda u: -sin(u),
    "tan": lambda u: _ONE + Applied("tan", u) ** 2,
    "arcsin": lambda u: _ONE / SquareRoot(_ONE - u**2),
    "arccos": lambda u: -(_ONE / SquareRoot(_ONE - u**2)),
    "arctan": lambda u: _ONE / (_ONE + u**2),
    "exp": lambda u: Applied("exp", u),
    "ln": lambda u: _ONE / u,
}


def derivative(item: Expression, rates: Rates) -> Maybe:
    """The derivative by time; ``rates`` has those of the values that change, for angles (degrees) in rad/s.

    By a variable with its own rate 1. Raises TypeError for an expression that has none (an absolute value).
    """
    match item:
        case Value() | Variable():
            return rates.get(item)
        case Total(terms):
            return added(*((sign, derivative(term, rates)) for sign, term in terms))
        case Times(factors):
            return added(*((1, _one_factor(factors, i, rates)) for i in range(len(factors))))
        case Ratio(above, below):
            return _quotient(above, below, rates)
    inner = next((rate for operand in item.operands() if (rate := derivative(operand, rates))), None)
    match item:
        case _ if inner is None:
            return None
        case Raised(base, exponent):
            return product(Constant(float(exponent)), Raised(base, exponent - 1), inner)
        case SquareRoot():
            return Ratio(inner, Constant(2.0) * item)
        case Applied(function, argument) if function in _OUTER:
            return product(inner, _OUTER[function](argument))
    raise TypeError(f"no derivative of {item!r}")


def _one_factor(factors: tuple[Expression, ...], index: int, rates: Rates) -> Maybe:
    """The product in which one factor is replaced by its derivative."""
    rate = derivative(factors[index], rates)
    return None if rate is None else product(*factors[:index], rate, *factors[index + 1 :])


def _quotient(above: Expression, below: Expression, rates: Rates) -> Maybe:
    up, down = derivative(above, rates), derivative(below, rates)
    if down is None:
        return None if up is None else Ratio(up, below)
    upper = added((1, product(up, below)), (-1, product(above, down)))
    return None if upper is None else Ratio(upper, Raised(below, 2))
