"""Arithmetic that can be shown: values with names, and expressions of them.

Every value has two numbers. ``exact`` is computed in full precision, so that a method can be compared with the solver;
``shown`` is the printed one: the full number rounded. A reader with a calculator gets it from the printed numbers
before it but for its last digit; where that is not so, the line says "nearly". Lengths, velocities and accelerations
are in the printed units of the family, angles in degrees, rates of rotation in rad/s and rad/s^2.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

from msgspec import Struct

from variantgen.algebra.decimals import ANGLE, decimals_shown, rounded, usual_decimals
from variantgen.algebra.functions import FUNCTIONS
from variantgen.algebra.name import Name
from variantgen.algebra.triples import ratio

_NEXT = 1.5  # units of the last digit: what is nearer is rounded to the next number at most
_CLOSES = 0.6  # the same for a sum of angles: its last digit is that of the printed terms
_ROUNDING = 1e-9  # of the natural scale: nothing, in arithmetic with printed numbers
_ZERO = 1e-10  # of the natural scale: what is smaller is rounding and is shown as zero


class Expression:
    """Part of a formula with numbers behind it; arithmetic with the usual operators."""

    __slots__ = ()

    def number(self, exact: bool) -> float:
        """Its number: in full precision, or from the printed numbers."""
        raise NotImplementedError

    def operands(self) -> Sequence[Expression]:
        """The expressions that it is put together from; a value stands for itself."""
        return ()

    def __add__(self, other: Expression) -> Expression:
        return Total(((1, self), (1, other)))

    def __sub__(self, other: Expression) -> Expression:
        return Total(((1, self), (-1, other)))

    def __neg__(self) -> Expression:
        if isinstance(self, Total):
            return Total(tuple((-sign, term) for sign, term in self.terms))
        return Total(((-1, self),))

    def __mul__(self, other: Expression) -> Expression:
        return Times((*_factors(self), *_factors(other)))

    def __truediv__(self, other: Expression) -> Expression:
        return Ratio(self, other)

    def __pow__(self, exponent: int) -> Expression:
        return Raised(self, exponent)


def _factors(item: Expression) -> tuple[Expression, ...]:
    return item.factors if isinstance(item, Times) else (item,)


class Value(Expression):
    """A number of the solution: given, or defined by an expression.

    ``name`` None is a number that stands for itself (the angle in a projection). ``measure`` is what it measures, as
    in :mod:`variantgen.families.parameters.units`. ``size`` is its natural scale: what is tiny beside it is zero.
    ``unit`` is the name of a unit other than the usual one of its measure, in which it is given. ``noted`` is room for
    what :func:`variantgen.methods.geometry.angle_sums.angle_sum` found, ``made_of`` for the values in its expression.
    """

    __slots__ = ("exact", "expression", "made_of", "measure", "name", "noted", "shown", "size", "unit")

    def __init__(
        self,
        name: Name | None,
        measure: str,
        exact: float,
        expression: Expression | None = None,
        size: float = 0.0,
        unit: str = "",
    ) -> None:
        self.name = name
        self.measure = measure
        self.exact = 0.0 if abs(exact) <= _ZERO * size else exact
        self.expression = expression
        self.shown = self.exact
        self.size = size
        self.unit = unit
        self.noted: Any = None
        self.made_of: tuple[Expression | None, tuple[Value, ...]] = (None, ())

    def number(self, exact: bool) -> float:
        """The full or the printed number."""
        return self.exact if exact else self.shown

    def round_to(self, digits: int, exact: bool = True) -> None:
        """Print so many significant digits of the full number, or of that from printed ones; a given one stays."""
        if self.expression is not None:
            # A sum of angles that is written out in symbols is the sum of the printed ones.
            follows = not exact or (self.name is None and self.measure == ANGLE and isinstance(self.expression, Total))
            number = self.expression.number(exact=False) if follows and self.exact != 0 else self.exact
            self.shown = rounded(number, digits, self.measure)

    @property
    def comes_out(self) -> bool:
        """Whether the printed numbers before it lead a reader to the printed one, but for one in its last digit."""
        if self.expression is None:
            return True
        if self.exact == 0:
            return abs(self.expression.number(exact=False)) <= _ROUNDING * max(self.size, 1.0)
        finest = max(self.decimals, usual_decimals(self.shown, self.measure))  # of 60 that is computed as 59.98 too
        units = _CLOSES if self.is_sum_of_angles else _NEXT
        return abs(self.expression.number(exact=False) - self.shown) < units * 10.0**-finest

    @property
    def is_sum_of_angles(self) -> bool:
        """Whether it is an angle by addition alone, which a reader does without a calculator."""
        return self.measure == ANGLE and isinstance(self.expression, Total) and self.expression.is_plain

    @property
    def decimals(self) -> int:
        """The decimals to which the printed number is rounded, negative for tens; of an exact one those that it has."""
        return decimals_shown(self.shown, self.exact, self.measure)

    def __repr__(self) -> str:
        return f"Value({_told(self.name)}, {self.exact:.6g})"


@lru_cache(maxsize=4096)
def _told(name: Name | None) -> str:
    """A name as text, by which sums are put in order."""
    return str(name)


class Constant(Expression, Struct, frozen=True):
    """A number that belongs to a formula, as in ``2 omega v`` or ``0.5 AB``; ``measure`` "angle" for degrees."""

    value: float
    measure: str = ""

    def number(self, exact: bool) -> float:
        """Itself."""
        return float(self.value)


class Variable(Expression, Struct, frozen=True):
    """A quantity that has only a name: the data of a family, whose numbers come with a variant."""

    name: str


class Pi(Expression, Struct, frozen=True):
    """The number pi."""

    def number(self, exact: bool) -> float:
        """3.14159..."""
        return math.pi


class Total(Expression, Struct, frozen=True):
    """A sum of terms with signs."""

    terms: tuple[tuple[int, Expression], ...]

    def number(self, exact: bool) -> float:
        """The sum."""
        return sum([sign * term.number(exact) for sign, term in self.terms])

    def operands(self) -> Sequence[Expression]:
        """The terms."""
        return [term for _, term in self.terms]

    @property
    def is_plain(self) -> bool:
        """Whether its terms are values and numbers, sums of such, or simple parts of them, as half an angle is."""
        return all(
            part.is_plain
            if isinstance(part, Total)
            else isinstance(part, Constant | Value)
            or (isinstance(part, Ratio) and isinstance(part.above, Value) and isinstance(part.below, Constant))
            for _, part in self.terms
        )

    @property
    def begun_by_plus(self) -> Total:
        """The sum, with all signs changed if it begins with a minus: its square is the same."""
        return self if self.terms[0][0] > 0 else Total(tuple((-sign, term) for sign, term in self.terms))


class Times(Expression, Struct, frozen=True):
    """A product."""

    factors: tuple[Expression, ...]

    def number(self, exact: bool) -> float:
        """The product."""
        return math.prod([factor.number(exact) for factor in self.factors])

    def operands(self) -> Sequence[Expression]:
        """The factors."""
        return self.factors


class Ratio(Expression, Struct, frozen=True):
    """A fraction."""

    above: Expression
    below: Expression

    def number(self, exact: bool) -> float:
        """The quotient."""
        return self.above.number(exact) / self.below.number(exact)

    def operands(self) -> Sequence[Expression]:
        """What stands above and below."""
        return (self.above, self.below)


class Raised(Expression, Struct, frozen=True):
    """A whole power."""

    base: Expression
    exponent: int

    def number(self, exact: bool) -> float:
        """The power."""
        result: float = self.base.number(exact) ** self.exponent
        return result

    def operands(self) -> Sequence[Expression]:
        """The base."""
        return (self.base,)


class SquareRoot(Expression, Struct, frozen=True):
    """A square root."""

    inner: Expression

    def number(self, exact: bool) -> float:
        """The root; of a square that rounding has made negative, zero."""
        return math.sqrt(max(self.inner.number(exact), 0.0))

    def operands(self) -> Sequence[Expression]:
        """What stands under the root."""
        return (self.inner,)


class Magnitude(Expression, Struct, frozen=True):
    """An absolute value."""

    inner: Expression

    def number(self, exact: bool) -> float:
        """The absolute value."""
        return abs(self.inner.number(exact))

    def operands(self) -> Sequence[Expression]:
        """What stands between the bars."""
        return (self.inner,)


class Applied(Expression, Struct, frozen=True):
    """A function of an angle in degrees, or one with such a value; of plain numbers exp, ln; of two min, max, atan2."""

    function: str
    argument: Expression
    second: Expression | None = None

    def number(self, exact: bool) -> float:
        """The value of the function; from printed numbers that of a triangle like 3:4:5 stays its fraction."""
        found = None if exact else ratio(self.function, self.argument.number(True))
        return FUNCTIONS[self.function](self.argument.number(exact)) if found is None else found[0] / found[1]

    def operands(self) -> Sequence[Expression]:
        """The arguments."""
        return (self.argument,) if self.second is None else (self.argument, self.second)


def cos(angle: Expression) -> Expression:
    """Cosine of an angle in degrees."""
    return Applied("cos", angle)


def sin(angle: Expression) -> Expression:
    """Sine of an angle in degrees."""
    return Applied("sin", angle)


def total(parts: Sequence[Expression]) -> Expression:
    """A sum; of a single part the part itself."""
    return parts[0] if len(parts) == 1 else Total(tuple((1, part) for part in parts))
