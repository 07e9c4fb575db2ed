"""Products in their simplest form: numbers multiplied out, equal factors as powers.

Derivatives of laws of motion come as ``g * (2 t) * 2 / 2^2``; a reader expects ``g t``.
"""

from __future__ import annotations

from variantgen.methods.algebra.expression import Constant, Expression, Raised, Ratio, Times, Total, Value

Powers = dict[int, tuple[Expression, int]]  # by identity of the factor: the factor and its exponent


def simplified(item: Expression) -> Expression:
    """The same expression with its products in simplest form; sums are simplified term by term."""
    if isinstance(item, Total) and len(item.terms) > 1:
        return Total(tuple((sign, simplified(term)) for sign, term in item.terms))
    number, powers = _parts(item, 1)
    if number < 0:
        return -simplified(Times((Constant(-1.0), item)))
    above = [_power(base, n) for base, n in powers.values() if n > 0]
    below = [_power(base, -n) for base, n in powers.values() if n < 0]
    top, bottom = _fraction(number)
    numerator = _product(top, above)
    return Ratio(numerator, _product(bottom, below)) if below or bottom != 1 else numerator


def _fraction(number: float) -> tuple[float, float]:
    """A number as a numerator and a denominator, of which one is 1."""
    return (number, 1.0) if abs(number) >= 1 or number == 0 else (1.0, 1.0 / number)


def _product(number: float, factors: list[Expression]) -> Expression:
    """A number times factors, without a factor of one."""
    every = ([] if number == 1 and factors else [Constant(number)]) + factors
    return every[0] if len(every) == 1 else Times(tuple(every))


def _power(base: Expression, exponent: int) -> Expression:
    return base if exponent == 1 else Raised(base, exponent)


def _parts(item: Expression, exponent: int) -> tuple[float, Powers]:
    """The number and the powers of a product, itself raised to an exponent."""
    match item:
        case Constant(value):
            return float(value**exponent), {}
        case Times(factors):
            return _merged([_parts(factor, exponent) for factor in factors])
        case Ratio(above, below):
            return _merged([_parts(above, exponent), _parts(below, -exponent)])
        case Raised(base, power):
            return _parts(base, exponent * power)
        case Total(((sign, term),)):
            return _merged([(float(sign**exponent), {}), _parts(term, exponent)])
        case Value():
            return 1.0, {id(item): (item, exponent)}
    return 1.0, {id(item): (simplified(item) if isinstance(item, Total) else item, exponent)}


def _merged(parts: list[tuple[float, Powers]]) -> tuple[float, Powers]:
    number, powers = 1.0, Powers()
    for factor, own in parts:
        number *= factor
        for key, (base, exponent) in own.items():
            powers[key] = (base, exponent + powers.get(key, (base, 0))[1])
    return number, {key: (base, n) for key, (base, n) in powers.items() if n}
