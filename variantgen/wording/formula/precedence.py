"""Where a formula needs parentheses, and what stands between two factors: decided once for all markups.

Each question is asked for a child at its place in the parent and answered with True if the child has to be put in
parentheses. ``flat`` tells that the markup writes fractions and roots in the line (``a / b``, ``√a``) instead of with
a bar, so that their parts are not held together by it.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum, IntEnum

from variantgen.wording.formula.tree import (
    Cross,
    Dotted,
    Equation,
    Formula,
    FormulaList,
    Fraction,
    Function,
    Graph,
    Measured,
    Number,
    Parenthesised,
    Power,
    Product,
    Quotient,
    Relation,
    Root,
    Sum,
    Surd,
    Symbol,
    SymbolProperty,
    UnitText,
    Vector,
)


class Binding(IntEnum):
    """How firmly the parts of a formula hold together, the loosest first."""

    RELATION = 0
    SUM = 1
    PRODUCT = 2
    PREFIX = 3  # cos φ, √a, a fraction with a bar: whole as a factor, not as the base of a power
    POWER = 4
    WHOLE = 5


class Between(Enum):
    """What stands between two factors."""

    DOT = "dot"
    THIN = "thin"  # a number and its letter: 2 ω
    OPERATOR = "operator"  # a letter and a function: v cos φ


def binding(formula: Formula, flat: bool) -> Binding:
    """The binding of a formula, signs apart (see :func:`starts_with_minus`)."""
    match formula:
        case Equation() | FormulaList() | Relation() | Graph():
            return Binding.RELATION
        case Sum(((sign, term),)):  # −π: nothing is added
            return Binding.PREFIX if as_term(sign, term, True, flat) else min(binding(term, flat), Binding.PREFIX)
        case Sum():
            return Binding.SUM
        case Product() | Cross() | UnitText() | Quotient():
            return Binding.PRODUCT
        case Measured(_, unit):
            if not unit.parts:
                return Binding.WHOLE
            return Binding.PREFIX if unit.tight else Binding.PRODUCT
        case Fraction():
            return Binding.PRODUCT if flat else Binding.PREFIX
        case Surd():
            return _binding_of_surd(formula, flat)
        case Function():
            return Binding.PREFIX
        case SymbolProperty(what):
            return Binding.PREFIX if what == "sense" else Binding.WHOLE
        case Root():
            return Binding.PREFIX if flat else Binding.WHOLE
        case Power():
            return Binding.POWER
        case _:
            return Binding.WHOLE


def _binding_of_surd(surd: Surd, flat: bool) -> Binding:
    if surd.denominator > 1:
        return Binding.PRODUCT if flat else Binding.PREFIX
    if surd.radicand == 1:
        return Binding.WHOLE
    return Binding.PREFIX if abs(surd.numerator) == 1 else Binding.PRODUCT


def starts_with_minus(formula: Formula, flat: bool) -> bool:
    """Whether a minus sign would be the first thing printed."""
    match formula:
        case Number(text):
            return text[:1] in ("\N{MINUS SIGN}", "-")
        case Measured(number):
            return starts_with_minus(number, flat)
        case Sum(terms):
            sign, term = terms[0]
            return sign < 0 or starts_with_minus(term, flat)
        case Product(factors):
            return not as_factor(factors, 0, flat) and starts_with_minus(factors[0], flat)
        case Cross(left):
            return not as_side_of_cross(left, True, flat) and starts_with_minus(left, flat)
        case Fraction(numerator):
            return flat and not as_numerator(numerator, flat) and starts_with_minus(numerator, flat)
        case Surd(numerator):
            return numerator < 0
        case _:
            return False


def as_term(sign: int, term: Formula, first: bool, flat: bool) -> bool:
    """A term of a sum: ``a − (b + c)``, ``a + (−3)``; the first one stands as it is, unless it has a minus before."""
    if first and sign > 0:
        return binding(term, flat) < Binding.SUM
    return binding(term, flat) <= Binding.SUM or starts_with_minus(term, flat)


def as_factor(factors: Sequence[Formula], i: int, flat: bool) -> bool:
    """Factor number ``i`` of a product: ``3 · (−20.3)``, ``2 · (a + b)``, ``(a / b) · c``."""
    factor, last = factors[i], i == len(factors) - 1
    if binding(factor, flat) < Binding.PRODUCT or (i > 0 and starts_with_minus(factor, flat)):
        return True
    if isinstance(factor, Cross):
        # Numbers before a vector product may stand with it: 2 ω × v. Anything else would be another product.
        return not (last and all(isinstance(before, Number) for before in factors[:-1]))
    return not last and _ends_with_slash(factor, flat)


def as_numerator(numerator: Formula, flat: bool) -> bool:
    """The numerator of a fraction; under a bar nothing is needed."""
    return flat and (binding(numerator, flat) < Binding.PRODUCT or _ends_with_slash(numerator, flat))


def as_denominator(denominator: Formula, flat: bool) -> bool:
    """The denominator of a fraction: ``a / (b · c)``."""
    return flat and (binding(denominator, flat) < Binding.PREFIX or starts_with_minus(denominator, flat))


def as_base(base: Formula, flat: bool) -> bool:
    """The base of a power: ``(a · b)^2``; a letter with something above its index has no room for an exponent."""
    return binding(base, flat) < Binding.WHOLE or starts_with_minus(base, flat) or _has_upper(base)


def as_radicand(radicand: Formula, flat: bool) -> bool:
    """What stands under a root: in the line all but a letter or a number."""
    return flat and as_base(radicand, flat)


def as_argument(argument: Formula) -> bool:
    """The argument of a function: bare letters, numbers and angles in degrees; a :class:`Parenthesised` has its own."""
    match argument:
        case Measured(_, unit) if unit.parts and not unit.tight:
            return True
        case Number() | Measured():
            return starts_with_minus(argument, True)
        case Symbol() | Vector() | Dotted() | Parenthesised():
            return False
        case _:
            return True


def as_side_of_cross(side: Formula, first: bool, flat: bool) -> bool:
    """One side of a vector product: ``ω × (ω × r)``; a number may stand before the first: ``2 ω × v``."""
    if first and isinstance(side, Product):
        *numbers, last = side.factors
        return not (_is_letter(last) and all(isinstance(number, Number) for number in numbers))
    return binding(side, flat) < Binding.PREFIX or (not first and starts_with_minus(side, flat))


def _ends_with_slash(formula: Formula, flat: bool) -> bool:
    """Whether a fraction in the line comes last, so that what follows could be read as part of its denominator."""
    match formula:
        case Fraction():
            return flat
        case Surd(_, denominator):
            return flat and denominator > 1
        case Measured(_, unit):
            return flat and any("/" in word for word, _ in unit.parts)
        case Sum(((_, formula),)) | Product((*_, formula)):
            return _ends_with_slash(formula, flat)
        case _:
            return False


def between(factors: Sequence[Formula], i: int) -> Between:
    """What stands between factor number ``i`` and the next: ``v cos φ``, ``2 ω``, ``(a t + b) cm``, else a dot."""
    one, other = factors[i], factors[i + 1]
    if isinstance(other, Cross):
        other = other.left
    if _is_letter(one) and (isinstance(other, Function) or _is_power_of_function(other)):
        return Between.OPERATOR
    if isinstance(other, UnitText) or (i == 0 and _is_whole(one) and _is_single_letter(other)):
        return Between.THIN
    return Between.DOT


def _is_power_of_function(formula: Formula) -> bool:
    return isinstance(formula, Power) and isinstance(formula.base, Function) and formula.exponent > 0


def _is_whole(formula: Formula) -> bool:
    return isinstance(formula, Number) and formula.text.lstrip("\N{MINUS SIGN}-").isdecimal()


def _letter(formula: Formula) -> Symbol | None:
    """The letter that a formula consists of, marks and exponent apart."""
    match formula:
        case Symbol():
            return formula
        case Vector(symbol) | Dotted(symbol):
            return symbol
        case Power(base) if not as_base(base, False):
            return _letter(base)
        case _:
            return None


def _has_upper(formula: Formula) -> bool:
    match formula:
        case Symbol(upper=upper) | Vector(Symbol(upper=upper)) | Dotted(Symbol(upper=upper)):
            return bool(upper)
        case _:
            return False


def _is_letter(formula: Formula) -> bool:
    return _letter(formula) is not None


def _is_single_letter(formula: Formula) -> bool:
    letter = _letter(formula)
    return letter is not None and not letter.is_name and not letter.base.isdecimal()
