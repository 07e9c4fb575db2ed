"""The antiderivative of an expression by one of its names, where simple rules lead to one."""

from __future__ import annotations

from variantgen.algebra.derivative import derivative
from variantgen.algebra.expression import (
    Applied,
    Constant,
    Expression,
    Raised,
    Ratio,
    SquareRoot,
    Times,
    Total,
    Variable,
)
from variantgen.algebra.normal_form import Maybe, added, product, signed
from variantgen.algebra.substitution import substituted
from variantgen.algebra.values import walk

_DEGREE = 8  # of polynomials
# Functions of a straight argument, with the sign and the function of their antiderivative.
_INNER = {"sin": (-1, "cos"), "cos": (1, "sin"), "exp": (1, "exp")}


def antiderivative(item: Expression, name: str) -> Maybe:
    """A function whose derivative by the name is the expression: of polynomials, of sine, cosine and the exponential
    function of ``p + q x`` and their products with polynomials, of ``1 / (p + q x)^n`` and of roots of ``p + q x``.

    None stands for zero. Raises LookupError where these rules do not lead to one.
    """
    x = Variable(name)
    if not has(item, name):
        return product(item, x)
    coefficients = polynomial(item, name)
    if coefficients is not None:
        return added(*((1, _power_integral(c, x, k)) for k, c in enumerate(coefficients)))
    match item:
        case Total(terms):
            return added(*((sign, antiderivative(term, name)) for sign, term in terms))
        case Ratio(above, below) if not has(below, name):
            found = antiderivative(above, name)
            return None if found is None else Ratio(found, below)
        case Ratio(above, below) if not has(above, name):
            return product(above, _of_inverse(below, name))
        case SquareRoot(inner):
            slope = _slope(inner, name)
            return Ratio(Times((Constant(2.0), inner, SquareRoot(inner))), _times(3.0, slope))
        case Applied(function, argument) if function in _INNER:
            sign, inner_function = _INNER[function]
            return _through(Applied(inner_function, argument), _slope(argument, name), sign)
        case Times(factors):
            return _of_product(factors, name)
    raise LookupError("no antiderivative")


def has(item: Expression, name: str) -> bool:
    """Whether the name stands in an expression."""
    return any(isinstance(part, Variable) and part.name == name for part in walk(item))


def at(item: Maybe, name: str, value: Expression) -> Maybe:
    """An expression with a value in the place of a name; None stands for zero."""
    return None if item is None else substituted(item, {Variable(name): value})


def polynomial(item: Expression, name: str) -> list[Maybe] | None:
    """The coefficients of a polynomial of the name, the lowest first; None for another expression."""
    if not _is_polynomial(item, name):
        return None
    found: list[Maybe] = []
    rest: Maybe = item
    factorial = 1.0
    for power in range(_DEGREE + 1):
        if rest is None:
            return found
        factorial *= max(power, 1)
        value = at(rest, name, Constant(0.0))
        found.append(None if value is None else product(Constant(1.0 / factorial), value))
        rest = derivative(rest, {Variable(name): Constant(1.0)})
    return found if rest is None else None


def _is_polynomial(item: Expression, name: str) -> bool:
    match item:
        case _ if not has(item, name):
            return True
        case Variable():
            return True
        case Total() | Times():
            return all(_is_polynomial(part, name) for part in item.operands())
        case Raised(base, _):
            return _is_polynomial(base, name)
        case Ratio(above, below):
            return _is_polynomial(above, name) and not has(below, name)
    return False


def straight(item: Expression, name: str) -> tuple[Maybe, Maybe] | None:
    """The numbers p and q of an expression ``p + q x``; None for another one."""
    found = polynomial(item, name)
    return None if found is None or len(found) > 2 else ((*found, None, None)[0], (*found, None, None)[1])


def _power_integral(coefficient: Maybe, x: Variable, power: int) -> Maybe:
    return product(Constant(1.0 / (power + 1)), coefficient, Raised(x, power + 1) if power else x)


def _slope(item: Expression, name: str) -> Expression:
    """The number q of ``p + q x``. Raises LookupError for another expression."""
    found = straight(item, name)
    if found is None or found[1] is None:
        raise LookupError("no straight argument")
    return found[1]


def _times(number: float, item: Expression) -> Expression:
    return product(Constant(number), item) or Constant(0.0)


def _of_inverse(below: Expression, name: str) -> Expression:
    """The antiderivative of one through a power or a root of ``p + q x``."""
    match below:
        case SquareRoot(inner):
            return _through(_times(2.0, SquareRoot(inner)), _slope(inner, name))
        case Raised(base, power) if power > 1:
            sign, slope = signed(_times(power - 1.0, _slope(base, name)))
            return _through(Constant(1.0), Times((slope, Raised(base, power - 1))), -sign)
    return _through(Applied("ln", below), _slope(below, name))


def _through(above: Expression, below: Expression, sign: int = 1) -> Expression:
    """A fraction with a sign, that of its denominator taken out."""
    own, bare = signed(below)
    found = above if bare == Constant(1.0) else Ratio(above, bare)
    return found if sign * own > 0 else -found


def _of_product(factors: tuple[Expression, ...], name: str) -> Maybe:
    """Constant factors stay; a polynomial times a function of ``p + q x`` by parts, degree by degree."""
    constant = [factor for factor in factors if not has(factor, name)]
    moving = [factor for factor in factors if has(factor, name)]
    if constant:
        rest = moving[0] if len(moving) == 1 else Times(tuple(moving))
        return product(*constant, antiderivative(rest, name))
    functions = [factor for factor in moving if polynomial(factor, name) is None]
    if len(functions) != 1 or not isinstance(functions[0], Applied):
        raise LookupError("no antiderivative of this product")
    others = [factor for factor in moving if factor is not functions[0]]
    power: Maybe = others[0] if len(others) == 1 else Times(tuple(others))
    function, argument = functions[0].function, functions[0].argument
    slope, sign = _slope(argument, name), 1
    found: Maybe = None
    below: Expression = slope
    while power is not None:
        if function not in _INNER:
            raise LookupError("no antiderivative of this product")
        own, function = _INNER[function]
        sign *= own
        term = Ratio(product(power, Applied(function, argument)) or Constant(0.0), below)
        found = added((1, found), (sign, term))
        power, sign, below = derivative(power, {Variable(name): Constant(1.0)}), -sign, Times((below, slope))
    return found
