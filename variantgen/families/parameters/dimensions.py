"""Dimensions of expressions: how a number in SI depends on the units of length and time."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce

import numpy as np

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
    Variable,
)
from variantgen.errors import InputError, Problem
from variantgen.families.parameters.units import LENGTHS

Dimension = tuple[float, float]
_PURE: Dimension = (0, 0)

CONSTANTS: dict[str, tuple[float, Dimension]] = {
    "pi": (float(np.pi), _PURE),
    "deg": (float(np.pi / 180), _PURE),
    **{"inch" if name == "in" else name: (float(factor), (1, 0)) for name, factor in LENGTHS.items()},
}


def dimension_of(item: Expression, known: Mapping[str, Dimension], text: str) -> Dimension | None:
    """Exponents of length and time of an expression; None for a bare zero, which fits everything.

    Raises InputError, with the ``text``, where lengths are added to times.
    """
    parts = [dimension_of(operand, known, text) for operand in item.operands()]
    match item:
        case Constant(value):
            return None if value == 0 else _PURE
        case Variable(name):
            return CONSTANTS[name][1] if name in CONSTANTS else known[name]
        case Total() | Magnitude():
            return reduce(lambda a, b: _same(a, b, text), parts)
        case Times() | Ratio():
            sign = 1 if isinstance(item, Times) else -1
            return reduce(lambda a, b: a and b and (a[0] + sign * b[0], a[1] + sign * b[1]), parts)
        case Raised(_, power):
            length, time = parts[0] or _PURE
            return length * power, time * power
        case SquareRoot():
            return parts[0] and (parts[0][0] / 2, parts[0][1] / 2)
        case Applied("min" | "max"):
            return _same(parts[0], parts[1], text)
        case Applied("atan2"):
            _same(parts[0], parts[1], text)
            return _PURE
        case Applied():
            _same(parts[0], _PURE, text)
            return _PURE
    raise TypeError(f"no dimension of {item!r}")


def _same(a: Dimension | None, b: Dimension | None, text: str) -> Dimension | None:
    if a is None or b is None:
        return a or b
    if a != b:
        raise InputError(
            Problem(
                f"adds or compares {dimension_name(a)} with {dimension_name(b)}",
                value=text,
                remedy="check the units of the parameters in it",
            )
        )
    return a


def dimension_name(dimension: Dimension) -> str:
    """A dimension in words for messages."""
    names = {
        (0, 0): "a number or an angle",
        (1, 0): "a length",
        (0, 1): "a time",
        (0, -1): "an angular velocity",
        (0, -2): "an angular acceleration",
        (1, -1): "a velocity",
        (1, -2): "an acceleration",
    }
    return names.get((int(dimension[0]), int(dimension[1])), f"length^{dimension[0]:g} time^{dimension[1]:g}")
