"""Plain numbers where an angle is meant: ``phi + 180`` adds 180 radians, so its author is asked.

Angles and numbers have the same dimension. Here a part of an expression is an angle (a parameter in degrees, ``deg``,
an arc function, and what is made of them), a plain number (its possible values are known), or something else (a ratio
of lengths, say). A plain number may be added to an angle, compared with one, or be the argument of a sine only if it is
zero or a small multiple of pi.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from enum import Enum
from itertools import product
from typing import TypeAlias

from variantgen.algebra.expression import Applied, Expression, Magnitude, Ratio, Times, Total, Variable
from variantgen.errors import InputError, Problem
from variantgen.families.parameters.dimensions import CONSTANTS
from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.families.parameters.parameter import Parameter


class Unknown(Enum):
    """A part of an expression whose values are not known."""

    ANGLE = "an angle"
    OTHER = "something else"


# The values that a plain number may have: several if it depends on a choice.
Kind: TypeAlias = Unknown | frozenset[float]

_STEP = math.pi / 12  # multiples of this are meant in radians
_LARGEST = 4 * math.pi
_MOST = 64  # combinations of choices that are followed
_ARCS, _CIRCULAR = ("arcsin", "arccos", "arctan", "atan2"), ("sin", "cos", "tan")


def kind_of_parameter(parameter: Parameter) -> Kind:
    """What a parameter is: a choice is a plain number, a rate of turning counts as an angle (it is one, per second)."""
    if parameter.unit is None:
        return frozenset(parameter.si.tolist())
    return Unknown.ANGLE if parameter.unit.measures.startswith("ang") else Unknown.OTHER


def kind_of(expression: FamilyExpression, known: Mapping[str, Kind]) -> Kind:
    """What an expression is, from what its names are. Raises InputError for a plain number beside an angle."""
    return _Reading(expression.text, known).kind(expression.tree)


def check_angle(expression: FamilyExpression, known: Mapping[str, Kind]) -> None:
    """Raise InputError if an expression that stands for an angle is, or adds to one, a number of degrees."""
    reading = _Reading(expression.text, known)
    reading.beside_angle(reading.kind(expression.tree))


class _Reading:
    """Walks one expression; ``text`` is for messages."""

    def __init__(self, text: str, known: Mapping[str, Kind]) -> None:
        self._text = text
        self._known = known

    def kind(self, item: Expression) -> Kind:
        """What a part of the expression is; whatever is added to an angle in it is looked at."""
        if isinstance(item, Variable):
            return self._of_name(item.name)
        kinds = [self.kind(part) for part in item.operands()]
        if isinstance(item, Applied) and item.function in _CIRCULAR:
            self.beside_angle(kinds[0])
        if isinstance(item, Applied) and item.function in _ARCS:
            return Unknown.ANGLE
        if all(isinstance(kind, frozenset) for kind in kinds):
            return self._values(item)
        match item:
            case Total() | Magnitude() | Applied("min" | "max"):
                return self._together(kinds)
            case Times() if Unknown.ANGLE in kinds:
                return Unknown.ANGLE
            case Ratio() if isinstance(kinds[1], frozenset) and not _is_turn(kinds[1]):
                return kinds[
                    0
                ]  # an angle divided by an angle, by pi, or by what may be one (epsilon / omega**2) is none
        return Unknown.OTHER

    def beside_angle(self, kind: Kind) -> None:
        """Raise InputError for a plain number that is no small multiple of pi."""
        wrong = next((v for v in sorted(kind) if not _in_radians(v)), None) if isinstance(kind, frozenset) else None
        if wrong is not None:
            raise InputError(
                Problem(
                    f"the plain number {wrong:.6g} stands where an angle is meant, and would count in radians",
                    value=self._text,
                    remedy=f"did you mean {wrong:.6g} * deg? Only multiples of pi may stand without deg",
                )
            )

    def _of_name(self, name: str) -> Kind:
        if name == "deg":
            return Unknown.ANGLE
        return frozenset({CONSTANTS[name][0]}) if name == "pi" else self._known.get(name, Unknown.OTHER)

    def _together(self, kinds: list[Kind]) -> Kind:
        """Parts that are added or compared."""
        if Unknown.ANGLE not in kinds:
            return Unknown.OTHER
        for kind in kinds:
            self.beside_angle(kind)
        return Unknown.ANGLE

    def _values(self, item: Expression) -> Kind:
        """The values of a plain number, whatever the choices in it."""
        part = FamilyExpression(self._text, item)
        names = sorted(part.names & self._known.keys())
        choices = [sorted(kind) for name in names if isinstance(kind := self._known[name], frozenset)]
        if math.prod(len(values) for values in choices) > _MOST:
            return Unknown.OTHER
        return frozenset(float(part.value(dict(zip(names, row, strict=True)))) for row in product(*choices))


def _in_radians(value: float) -> bool:
    """Whether a plain number may be an angle in radians: zero or a small multiple of pi."""
    steps = value / _STEP
    return abs(value) <= _LARGEST and abs(steps - round(steps)) < 1e-4


def _is_turn(values: frozenset[float]) -> bool:
    """Whether a plain number is a multiple of pi, and not zero."""
    return all(value != 0 and _in_radians(value) for value in values)
