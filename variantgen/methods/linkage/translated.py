"""Expressions of a family as expressions of a solution: in printed units, translated once.

A scene is computed in SI and radians, a solution in the printed units of its family and in degrees. What a number means
depends on where it stands. One written literally in a scene (``distance = 60``) is a quantity: it is SI already and is
brought to its printed unit here. One in a formula (``2 * OA``) is a plain factor. Angles in formulas are degrees where
they come from the data and plain numbers (radians) where they come from rates and times; the two meet here too.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce

from msgspec import Struct

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
    Variable,
)
from variantgen.algebra.normal_form import simplified
from variantgen.algebra.values import walk
from variantgen.families.parameters.dimensions import CONSTANTS
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.units import unit

_DIGITS = 12  # to which a number is a short decimal but for the rounding of its conversion


def _short(number: float) -> float:
    """A number without the rounding of a conversion: 0.07 m are 7 cm, not 7.000000000000001."""
    return float(f"{number:.{_DIGITS}g}")


class _Part(Struct, frozen=True):
    """Part of a formula; ``degrees`` where it is proportional to an angle in degrees."""

    shown: Expression
    degrees: bool = False

    def plain(self) -> Expression:
        """The same with an angle in radians."""
        return Times((Pi(), Ratio(self.shown, Constant(180.0)))) if self.degrees else self.shown

    def in_degrees(self) -> Expression:
        """The same with an angle in degrees."""
        if self.degrees:
            return self.shown
        straight = _with_straight_angle(self.shown)
        return straight if straight is not None else Ratio(simplified(Constant(180.0) * self.shown), Pi())


def _with_straight_angle(shown: Expression) -> Expression | None:
    """A product with a factor pi, with 180 degrees in its place; None for anything else."""
    if isinstance(shown, Pi):
        return Constant(180.0, "angle")
    if isinstance(shown, Times):
        for place, factor in enumerate(shown.operands()):
            changed = _with_straight_angle(factor)
            if changed is not None:
                factors = tuple(shown.operands())
                return simplified(Times((*factors[:place], changed, *factors[place + 1 :])))
    return None


def _with_degree_sign(angle: Expression) -> Expression:
    """The argument of a function with its numbers as degrees: ``1440° t``; as it is where an angle is a factor."""
    match angle:
        case Constant(value, ""):
            return Constant(value, "angle")
        case Times((Constant(value, ""), *others)) if not any(_is_angle(part) for part in others):
            return Times((Constant(value, "angle"), *others))
        case Total(terms):
            return Total(tuple((sign, _with_degree_sign(term)) for sign, term in terms))
    return angle


def _is_angle(item: Expression) -> bool:
    return any(isinstance(part, Value) and part.measure == "angle" for part in walk(item))


class Translator(Struct, frozen=True):
    """Translates the expressions of one variant.

    ``named`` gives a parameter as its value (an angle in degrees), a choice as its number; None for another name.
    ``derived`` gives the expression of a derived quantity, ``unit_of`` the printed unit of a measure.
    """

    named: Callable[[str], Expression | None]
    derived: Callable[[str], FamilyExpression | None]
    unit_of: Callable[[str], str]

    def translate(self, expression: FamilyExpression, degrees: bool = False) -> Expression | None:
        """The expression in printed units, an angle as a plain number or in ``degrees``.

        None where a part of it cannot be shown in a solution.
        """
        match expression.tree:
            case Constant(_, measure) if measure:
                printed = unit(self.unit_of(measure)).from_si(float(expression.value({})))
                return Constant(_short(printed))
            case Variable(name) if isinstance(value := self.named(name), Value) and value.measure != "angle":
                return value
        found = self._part(expression.tree)
        if found is None:
            return None
        return found.in_degrees() if degrees else found.plain()

    def _part(self, item: Expression) -> _Part | None:
        if isinstance(item, Variable):
            return self._name(item.name)
        found = [self._part(operand) for operand in item.operands()]
        parts = [part for part in found if part]
        if len(parts) < len(found):
            return None
        match item:
            case Constant():
                return _Part(item)
            case Total(terms):
                first = parts[0] if terms[0][0] > 0 else _Part(-parts[0].shown, parts[0].degrees)
                signed = zip((sign for sign, _ in terms[1:]), parts[1:], strict=True)
                return reduce(lambda total, term: _added(total, *term), signed, first)
            case Times():
                return reduce(_multiplied, parts)
            case Ratio():
                return _divided(*parts)
            case Raised(_, exponent):
                return _Part(parts[0].plain() ** exponent)
            case SquareRoot():
                return _Part(SquareRoot(parts[0].plain()))
            case Applied("cos" | "sin" | "tan" as function):
                return _Part(Applied(function, _with_degree_sign(simplified(parts[0].in_degrees()))))
            case Applied("exp" | "ln" as function):
                return _Part(Applied(function, simplified(parts[0].plain())))
        return None

    def _name(self, name: str) -> _Part | None:
        """A parameter as its value, a choice as its number, a derived quantity written out, a constant."""
        if name == "deg":
            return _Part(Constant(1.0, "angle"), True)
        if name == "pi":
            return _Part(Pi())
        if name in CONSTANTS:
            return _Part(Constant(unit(self.unit_of("length")).from_si(CONSTANTS[name][0]), "length"))
        found = self.named(name)
        if found is not None:
            return _Part(found, isinstance(found, Value) and found.measure == "angle")
        derived = self.derived(name)
        return None if derived is None else self._part(derived.tree)


def _multiplied(left: _Part, right: _Part) -> _Part:
    if left.degrees and right.degrees:
        return _Part(left.plain() * right.plain())
    return _Part(_product(left.shown, right.shown), left.degrees or right.degrees)


def _divided(left: _Part, right: _Part) -> _Part:
    if _is_length(right.shown) and right.shown.number(True) == 1:  # a plain number of the printed unit
        return left
    if right.degrees and not left.degrees:
        return _Part(left.shown / right.plain())
    return _Part(left.shown / right.shown, left.degrees and not right.degrees)


def _added(left: _Part, sign: int, right: _Part) -> _Part:
    degrees = left.degrees or right.degrees
    first, second = (part.in_degrees() if degrees else part.shown for part in (left, right))
    if _is_length(first) and _is_length(second):
        return _Part(Constant(_short(first.number(True) + sign * second.number(True)), "length"))
    return _Part(Total(((1, first), (sign, second))), degrees)


def _is_length(item: Expression) -> bool:
    """Whether it is a length by a number and a unit, ``5 * cm``."""
    return isinstance(item, Constant) and item.measure == "length"


def _product(left: Expression, right: Expression) -> Expression:
    """A product, with factors of plus or minus one written as signs."""
    if isinstance(left, Constant) and isinstance(right, Constant) and (_is_length(left) or _is_length(right)):
        return Constant(_short(left.value * right.value), "length")
    for one, other in ((left, right), (right, left)):
        if isinstance(one, Constant) and isinstance(other, Constant) and one.measure == "angle":
            return Constant(_short(one.value * other.value), "angle")
        if isinstance(one, Constant) and abs(one.value) == 1 and one.measure != "angle":
            return other if one.value > 0 else -other
    return left * right
