"""Sums and products without zeros, derivatives by time, and linear forms of expressions. None stands for zero."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping

from variantgen.methods.algebra.expression import (
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
from variantgen.methods.algebra.values import parts

Maybe = Expression | None
_ONE = Constant(1.0)
_ROUNDING = 1e-12  # a cosine or a sine below it is zero, but for the rounding of a right angle in radians


def signed(item: Expression) -> tuple[int, Expression]:
    """An expression without its leading sign, and that sign."""
    if isinstance(item, Total) and len(item.terms) == 1:
        sign, inner = item.terms[0]
        deeper, inner = signed(inner)
        return sign * deeper, inner
    return 1, item


def forward(item: Expression) -> tuple[int, Expression]:
    """A sign and an expression, one that does not begin with a minus."""
    sign, inner = signed(item)
    if isinstance(inner, Total) and all(s < 0 for s, _ in inner.terms):
        return -sign, Total(tuple((-s, term) for s, term in inner.terms))
    return sign, inner


def added(*terms: tuple[int, Maybe]) -> Maybe:
    """The sum of terms with signs: sums in it are opened, like terms put together, a positive term comes first."""
    flat: dict[Expression, float] = {}
    for sign, term in _opened(terms):
        number, rest = _split(term)
        flat[rest] = flat.get(rest, 0.0) + sign * number
    found = [(1 if number > 0 else -1, _scaled(abs(number), rest)) for rest, number in flat.items() if number]
    if not found:
        return None
    first = next((i for i, (sign, _) in enumerate(found) if sign > 0), 0)
    found.insert(0, found.pop(first))
    return found[0][1] if len(found) == 1 and found[0][0] > 0 else Total(tuple(found))


def _opened(terms: Iterable[tuple[int, Maybe]]) -> Iterator[tuple[int, Expression]]:
    for sign, term in terms:
        if isinstance(term, Total):
            yield from _opened((sign * s, t) for s, t in term.terms)
        elif term is not None:
            yield sign, term


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
    if rest == _ONE:
        return Constant(number)
    return Times((Constant(number), *(rest.factors if isinstance(rest, Times) else (rest,))))


def product(*items: Maybe) -> Maybe:
    """The product of factors: signs are taken out, numbers put together in front, like factors to powers."""
    sign, number = 1, 1.0
    powers: dict[Expression, int] = {}
    for item in items:
        if item is None:
            return None
        own, inner = forward(item)
        sign *= own
        for factor in inner.factors if isinstance(inner, Times) else (inner,):
            own, ahead = forward(factor)
            sign *= own
            if isinstance(ahead, Constant) and not ahead.measure:
                number *= ahead.value
                continue
            base, exponent = (ahead.base, ahead.exponent) if isinstance(ahead, Raised) else (ahead, 1)
            powers[base] = powers.get(base, 0) + exponent
    if number == 0:
        return None
    if number < 0:
        sign, number = -sign, -number
    factors = [base if exponent == 1 else Raised(base, exponent) for base, exponent in powers.items()]
    if number != 1 or not factors:
        factors.insert(0, Constant(number))
    whole = factors[0] if len(factors) == 1 else Times(_grouped(factors))
    return whole if sign > 0 else Total(((-1, whole),))


def _grouped(factors: list[Expression]) -> tuple[Expression, ...]:
    """Functions come last, where a formula has them: ``r omega cos phi``."""
    return tuple(sorted(factors, key=lambda item: isinstance(item, Applied)))


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


def substituted(item: Expression, table: Mapping[Value, Expression]) -> Maybe:
    """An expression with values replaced by what they stand for."""
    match item:
        case Value():
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
        case Applied(function, argument):
            return Applied(function, substituted(argument, table) or Constant(0.0))
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


def _sum_of_forms(
    forms: list[tuple[int, tuple[dict[Value, Expression], Maybe]]],
) -> tuple[dict[Value, Expression], Maybe]:
    rest = added(*((sign, rest) for sign, (_, rest) in forms))
    values = dict.fromkeys(value for _, (found, _) in forms for value in found)
    sums = {v: added(*((sign, found.get(v)) for sign, (found, _) in forms)) for v in values}
    return {v: c for v, c in sums.items() if c is not None}, rest
