"""Sums and products in one form, as a reader expects them. None stands for zero.

A sum has no sums in it, like terms put together, and begins with a positive term; a product has its sign and its number
in front, like factors as powers, functions at its end.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TypeAlias

from variantgen.algebra.decimals import decimals_of
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
    total,
)
from variantgen.algebra.values import walk

Maybe: TypeAlias = Expression | None
Signed: TypeAlias = tuple[int, Expression]
Powers = dict[Expression, int]  # exponents by factor
_ONE = Constant(1.0)
_SMALL = 100  # the largest denominator of a fraction
_ROUNDING = 1e-12  # relative
_SHORT = 3  # digits after the point


def signed(item: Expression) -> Signed:
    """An expression without its leading sign, and that sign."""
    if isinstance(item, Total) and len(item.terms) == 1:
        sign, inner = item.terms[0]
        deeper, inner = signed(inner)
        return sign * deeper, inner
    if isinstance(item, Constant) and item.value < 0:
        return -1, Constant(-item.value, item.measure)
    return 1, item


def forward(item: Expression) -> Signed:
    """A sign and an expression, one that does not begin with a minus."""
    sign, inner = signed(item)
    if isinstance(inner, Total) and all(s < 0 for s, _ in inner.terms):
        return -sign, Total(tuple((-s, term) for s, term in inner.terms))
    return sign, inner


def added(*terms: tuple[int, Maybe]) -> Maybe:
    """The sum of terms with signs: sums in it are opened, like terms put together, a positive term comes first."""
    if len(terms) == 1 and isinstance(value := terms[0][1], Value):
        return value if terms[0][0] > 0 else Total(((-1, value),))
    flat: dict[Expression, float] = {}
    for sign, item in terms:
        for own, term in terms_of(item, sign):
            number, rest = _split(term)
            flat[rest] = flat.get(rest, 0.0) + own * number
    found = [(1 if number > 0 else -1, _scaled(abs(number), rest)) for rest, number in flat.items() if number]
    if not found:
        return None
    if found[0][0] < 0:
        first = next((i for i, (sign, _) in enumerate(found) if sign > 0), 0)
        found.insert(0, found.pop(first))
    return found[0][1] if len(found) == 1 and found[0][0] > 0 else Total(tuple(found))


def summed(terms: Iterable[tuple[int, Maybe]]) -> Expression:
    """The sum of terms as :func:`added` makes it, the number 0 where nothing is left."""
    return added(*terms) or Constant(0.0)


def terms_of(item: Maybe, sign: int = 1) -> Iterator[Signed]:
    """The terms of a sum, of sums in it too; signs of factors and of numerators become signs of terms."""
    match item:
        case None:
            return
        case Total(terms):
            for own, term in terms:
                yield from terms_of(term, sign * own)
        case Times(factors):
            signs, rest = zip(*map(signed, factors), strict=True)
            yield sign * math.prod(signs), Times(rest)
        case Ratio(Total(((own, above),)), below):
            yield sign * own, Ratio(above, below)
        case _:
            own, bare = signed(item)
            yield sign * own, bare


def _split(term: Expression) -> tuple[float, Expression]:
    """A term as a number and the rest."""
    if isinstance(term, Constant) and not term.measure:
        return term.value, _ONE
    if isinstance(term, Times) and isinstance(term.factors[0], Constant) and not term.factors[0].measure:
        rest = term.factors[1:]
        return term.factors[0].value, rest[0] if len(rest) == 1 else Times(rest)
    return 1.0, term


def _scaled(number: float, rest: Expression) -> Expression:
    if number == 1:
        return rest
    return Constant(number) if rest == _ONE else Constant(number) * rest


def product(*items: Maybe) -> Maybe:
    """The product of factors: signs are taken out, numbers put together in front, like factors to powers."""
    number, powers = 1.0, Powers()
    for item in items:
        if item is None:
            return None
        number *= _collected(item, 1, powers)
    return _signed_by(number, _multiplied(abs(number), powers)) if number else None


def simplified(item: Expression) -> Expression:
    """A product as one fraction with its number in simplest form, a sum term by term.

    Derivatives of laws of motion come as ``g * (2 t) / 2`` or ``3 t^2 / 4``; a reader expects ``g t``, and no decimal
    where a fraction of small numbers stood: ``(3/4) t^2``, but ``0.4 t``.
    """
    if isinstance(item, Total) and len(item.terms) > 1:
        return summed((sign, simplified(term)) for sign, term in item.terms)
    powers = Powers()
    number = _collected(item, 1, powers, fractions=True)
    size = abs(number)
    if not any(powers.values()) and decimals_of(size) <= _SHORT:
        return _signed_by(number, Constant(size))
    top, bottom = _as_fraction(size, _is_fraction(item))
    above = _multiplied(top, {base: exponent for base, exponent in powers.items() if exponent > 0})
    below = _multiplied(bottom, {base: -exponent for base, exponent in powers.items() if exponent < 0})
    return _signed_by(number, above if below == _ONE else Ratio(above, below))


def _is_fraction(item: Expression) -> bool:
    """Whether something is divided in an expression, and all its numbers are whole."""
    found = list(walk(item))
    numbers = [part.value for part in found if isinstance(part, Constant)]
    return any(isinstance(part, Ratio) for part in found) and all(number == int(number) for number in numbers)


def _as_fraction(size: float, of_fractions: bool) -> tuple[float, float]:
    """A number as numerator and denominator: of small whole numbers where it is made ``of_fractions``, else 1 below."""
    fraction = Fraction(size).limit_denominator(_SMALL)
    is_short = abs(float(fraction) - size) <= _ROUNDING * size
    if is_short and (of_fractions or fraction.numerator == 1):
        return float(fraction.numerator), float(fraction.denominator)
    return (size, 1.0) if size >= 1 or size == 0 or decimals_of(size) <= _SHORT else (1.0, 1.0 / size)


def _collected(item: Expression, exponent: int, powers: Powers, fractions: bool = False) -> float:
    """The number of a product, itself raised to an exponent; its factors are added to ``powers``.

    With ``fractions`` numerators and denominators are factors, too.
    """
    sign, inner = forward(item)
    number = float(sign**exponent)
    match inner:
        case Constant(value, ""):
            number *= value**exponent
        case Times(factors):
            for factor in factors:
                number *= _collected(factor, exponent, powers, fractions)
        case Raised(base, power):
            number *= _collected(base, exponent * power, powers, fractions)
        case Ratio(above, below) if fractions:
            number *= _collected(above, exponent, powers, fractions)
            number *= _collected(below, -exponent, powers, fractions)
        case _:
            base = simplified(inner) if fractions and isinstance(inner, Total) else inner
            powers[base] = powers.get(base, 0) + exponent
    return number


def _multiplied(number: float, powers: Powers) -> Expression:
    """A number times powers, functions last, where a formula has them: ``r omega cos phi``."""
    factors = [base if exponent == 1 else Raised(base, exponent) for base, exponent in powers.items() if exponent]
    factors.sort(key=lambda item: isinstance(item, Applied))
    if number != 1 or not factors:
        factors.insert(0, Constant(number))
    return factors[0] if len(factors) == 1 else Times(tuple(factors))


def _signed_by(number: float, size: Expression) -> Expression:
    """A magnitude with the sign of a number."""
    return size if number >= 0 else Total(((-1, size),))


def positive(item: Expression) -> Signed:
    """The sign of a number and the expression of its magnitude; (0, ...) for zero."""
    number = item.number(True)
    if number == 0:
        return 0, item
    return (1, summed([(1, item)])) if number > 0 else (-1, summed([(-1, item)]))


def squared(parts: Iterable[Expression]) -> Expression:
    """The sum of squares, without a minus before what is squared."""
    kept = (tuple(terms_of(part)) for part in parts)
    bare = (terms[0][1] if len(terms) == 1 else Total(terms).begun_by_plus for terms in kept)
    return summed((1, part**2) for part in bare if part != Constant(0.0))


def hypotenuse(parts: Sequence[Expression]) -> Expression:
    """Root of the sum of squares, of sums with the sign with which they begin by a plus; of one part its magnitude."""
    squares = [Raised(part.begun_by_plus if isinstance(part, Total) else part, 2) for part in parts]
    return Magnitude(parts[0]) if len(parts) == 1 else SquareRoot(total(squares))
