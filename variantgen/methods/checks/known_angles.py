"""The angles of a check as a reader of the solution knows them.

A check projects on an axis of its own, so its angles are sums that no step has. A sum of data alone is written as its
number, ``cos(180 - 60 - 60) = cos 60``. Any other is a known angle or its complement or supplement, as ``42 + 34 + 25``
where an angle of ``180 - 42 - 34 - 25`` has a line, or else the sum or difference of two known ones. So a check needs
no line that the solution does not have.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import combinations

from msgspec.structs import replace

from variantgen.algebra.decimals import ANGLE
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
)
from variantgen.algebra.values import in_order
from variantgen.methods.solution.used import read
from variantgen.methods.steps.step import Ascending, Balance, Derived, Item, Step

_KINDS = ("angle", "inclination", "parameter")
_SAME = 1e-7  # degrees within which two angles are one, but for rounding
_RIGHT, _HALF_TURN, _TURN = 90.0, 180.0, 360.0
_QUARTERS = (0, 2, 1, 3)  # right angles between two angles of one sine and cosine, signs apart: the simplest first
_OTHER = {"cos": "sin", "sin": "cos"}
_FUNCTIONS = {"cos": math.cos, "sin": math.sin}


def known_angles(steps: Iterable[Step], found: Iterable[Value]) -> list[Value]:
    """The angles that a reader has met: given, or with a line."""
    values = in_order([*(value for step in steps for item in step.items for value in read(item)), *found])
    named = (value for value in values if value.measure == ANGLE and value.name is not None)
    return [value for value in named if value.name is not None and value.name.kind in _KINDS]


def by_known_angles(check: Sequence[Item], known: Sequence[Value]) -> tuple[Item, ...]:
    """A check with its angles by ``known`` ones."""
    found: list[Item] = []
    for item in check:
        match item:
            case Balance(left, right):
                found.append(Balance(_side(left, known), _side(right, known)))
            case Derived(value):
                found.append(replace(item, value=_side(value, known)))
            case Ascending(values):
                found.append(Ascending(tuple(_side(value, known) for value in values)))
            case _:
                found.append(item)
    return tuple(found)


def _side(value: Value, known: Sequence[Value]) -> Value:
    """A number of a check with its arithmetic by known angles."""
    if value.expression is None or isinstance(value.expression, Value):
        return value
    whole = _with_sign(*_rewritten(value.expression, known))
    return Value(value.name, value.measure, value.exact, whole, value.size, value.unit)


def _with_sign(sign: int, item: Expression) -> Expression:
    return item if sign > 0 else Total(((-1, item),))


def _rewritten(item: Expression, known: Sequence[Value]) -> tuple[int, Expression]:
    """An expression with its sines and cosines by known angles, and its sign."""
    match item:
        case Applied("cos" | "sin" as function, angle):
            return _by_known(function, angle, known)
        case Total(terms):
            parts = [(sign, *_rewritten(term, known)) for sign, term in terms]
            whole = [(sign * own, term) for sign, own, term in parts]
            if any(own < 0 for _, own, _ in parts):  # a sum begins with what is positive
                whole.sort(key=lambda part: -part[0])
            return 1, Total(tuple(whole))
        case Times(factors):
            signs, parts_of = zip(*(_rewritten(factor, known) for factor in factors), strict=True)
            return math.prod(signs), Times(parts_of)
        case Ratio(above, below):
            (up, upper), (down, lower) = _rewritten(above, known), _rewritten(below, known)
            return up * down, Ratio(upper, lower)
        case Raised(base, exponent):
            sign, inner = _rewritten(base, known)
            return sign**exponent, Raised(inner, exponent)
        case SquareRoot(inner):
            return 1, SquareRoot(_with_sign(*_rewritten(inner, known)))
    return 1, item


def _by_known(function: str, angle: Expression, known: Sequence[Value]) -> tuple[int, Expression]:
    """A sine or cosine by a known angle, by a number of data alone, or by two known ones; as it is where none fits."""
    if isinstance(angle, Value) and angle in known:
        return 1, Applied(function, angle)
    exact = angle.number(True) % _TURN
    if _is_short(exact):
        acute = min(exact % _HALF_TURN, -exact % _HALF_TURN)
        return _in_place_of(function, exact, Constant(round(acute, 2), ANGLE), 0)
    for quarters in _QUARTERS:
        for other in known:
            if _is_turned(exact, other.exact, quarters):
                return _in_place_of(function, exact, other, quarters)
    for quarters in _QUARTERS:
        for pair in combinations(known, 2):
            larger, smaller = sorted(pair, key=lambda value: -value.exact)
            for sign in (1, -1):
                if _is_turned(exact, larger.exact + sign * smaller.exact, quarters):
                    return _in_place_of(function, exact, Total(((1, larger), (sign, smaller))), quarters)
    return 1, Applied(function, angle)


def _is_short(angle: float) -> bool:
    """Whether an angle has no more than hundredths: it is made of data, and printed exactly."""
    return abs(angle - round(angle, 2)) < _SAME


def _is_turned(angle: float, other: float, quarters: int) -> bool:
    """Whether an angle is another one, or less that one, and so many right angles."""
    return any(
        abs((angle - _RIGHT * quarters - sign * other + _HALF_TURN) % _TURN - _HALF_TURN) < _SAME for sign in (1, -1)
    )


def _in_place_of(function: str, exact: float, other: Expression, quarters: int) -> tuple[int, Expression]:
    """A sine or cosine by the ``other`` angle, from which it differs by right angles, with its sign."""
    own = _OTHER[function] if quarters % 2 else function
    numbers = _FUNCTIONS[function](math.radians(exact)), _FUNCTIONS[own](math.radians(other.number(True)))
    return 1 if numbers[0] * numbers[1] >= 0 else -1, Applied(own, other)
