"""The derivative of an expression: by time with the rates of what changes, or by one of its names."""

from __future__ import annotations

from collections.abc import Mapping

from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Pi,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Value,
    cos,
    sin,
)
from variantgen.algebra.normal_form import Maybe, added, product


def derivative(item: Expression, rates: Mapping[Value, Maybe]) -> Maybe:
    """The derivative by time; ``rates`` has those of the values that change, for angles (degrees) in rad/s.

    Raises TypeError for an expression that has none (an absolute value, an inverse function).
    """
    match item:
        case Value():
            return rates.get(item)
        case Constant() | Pi():
            return None
        case Total(terms):
            return added(*((sign, derivative(term, rates)) for sign, term in terms))
        case Times(factors):
            return added(*((1, _one_factor(factors, i, rates)) for i in range(len(factors))))
        case Raised(base, exponent):
            power: Expression = base if exponent == 2 else Raised(base, exponent - 1)
            return product(Constant(float(exponent)), power, derivative(base, rates))
        case Applied("cos", argument):
            rate = product(derivative(argument, rates), sin(argument))
            return None if rate is None else product(Constant(-1.0), rate)
        case Applied("sin", argument):
            return product(derivative(argument, rates), cos(argument))
        case Ratio(above, below):
            return _quotient(above, below, rates)
        case SquareRoot(inner):
            rate = derivative(inner, rates)
            return None if rate is None else Ratio(rate, Constant(2.0) * item)
    raise TypeError(f"no derivative of {item!r}")


def _one_factor(factors: tuple[Expression, ...], index: int, rates: Mapping[Value, Maybe]) -> Maybe:
    """The product in which one factor is replaced by its derivative."""
    rate = derivative(factors[index], rates)
    return None if rate is None else product(*factors[:index], rate, *factors[index + 1 :])


def _quotient(above: Expression, below: Expression, rates: Mapping[Value, Maybe]) -> Maybe:
    up, down = derivative(above, rates), derivative(below, rates)
    if down is None:
        return None if up is None else Ratio(up, below)
    upper = added((1, product(up, below)), (-1, product(above, down)))
    return None if upper is None else Ratio(upper, Raised(below, 2))
