"""Units that may stand in a family file and on a sheet, with exact decimal factors to the SI."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from decimal import Decimal
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from variantgen.errors import InputError, Problem, nearest

Number = TypeVar("Number", float, NDArray[np.float64])


@dataclass(frozen=True)
class Unit:
    """A unit: name, dimension (exponents of length and time), factor to SI, what it measures.

    ``turn`` marks units that carry an extra factor, which no decimal number can hold: pi/180, pi/30, 1/3.6.
    """

    name: str
    dimension: tuple[int, int]
    factor: Decimal
    measures: str
    turn: float = 1.0

    @property
    def is_metric(self) -> bool:
        """Whether the unit is not made of inches or feet."""
        return self.name.partition("/")[0] not in ("in", "ft")

    def to_si(self, value: Decimal) -> float:
        """A printed value in SI, rounded once (twice for degrees and rpm)."""
        return float(value * self.factor) * self.turn

    def from_si(self, value: Number) -> Number:
        """An SI value in this unit, or an array of such."""
        return value / self.turn / float(self.factor)


# Units of length by their metres; velocities and accelerations are made of them.
LENGTHS = {
    "m": Decimal(1),
    "dm": Decimal("0.1"),
    "cm": Decimal("0.01"),
    "mm": Decimal("0.001"),
    "in": Decimal("0.0254"),
    "ft": Decimal("0.3048"),
}


def _table() -> dict[str, Unit]:
    one = Decimal(1)
    units = [Unit(name, (1, 0), factor, "length") for name, factor in LENGTHS.items()]
    units += [Unit(f"{name}/s", (1, -1), factor, "velocity") for name, factor in LENGTHS.items()]
    units += [Unit(f"{name}/s^2", (1, -2), factor, "acceleration") for name, factor in LENGTHS.items()]
    units += [
        Unit("km/h", (1, -1), one, "velocity", 1 / 3.6),
        Unit("rad", (0, 0), one, "angle"),
        Unit("deg", (0, 0), one, "angle", math.pi / 180),
        Unit("1", (0, 0), one, "number"),
        Unit("rad/s", (0, -1), one, "angular velocity"),
        Unit("rpm", (0, -1), one, "angular velocity", math.pi / 30),
        Unit("rad/s^2", (0, -2), one, "angular acceleration"),
        Unit("s", (0, 1), one, "time"),
    ]
    return {unit.name: unit for unit in units}


UNITS = _table()
_LARGEST_EXPONENT = 12
_DECIMALS = 12  # of a number in another unit, where it does not end
_NUMBER_WITH_UNIT = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([A-Za-z][A-Za-z0-9/^-]*)?\s*")


def unit(name: str, key: str = "unit") -> Unit:
    """The unit of that name; InputError with the nearest names if there is none."""
    if name not in UNITS:
        raise InputError(Problem("unknown unit", key=key, value=name, remedy=nearest(name, UNITS)))
    return UNITS[name]


def checked(value: Decimal, key: str) -> Decimal:
    """The value itself; InputError if it is not finite or far beyond anything that can be drawn or built."""
    if not value.is_finite() or (value != 0 and abs(value.adjusted()) > _LARGEST_EXPONENT):
        raise InputError(Problem("expected a number of ordinary size", key=key, value=str(value)[:40]))
    return value


def is_number(text: str) -> bool:
    """Whether a text is a number, bare or followed by a unit (and not an expression)."""
    return _NUMBER_WITH_UNIT.fullmatch(text) is not None


def parse_value(text: str, default: Unit, key: str) -> Decimal:
    """A number, with or without a unit, as a value in the unit ``default``.

    ``"30"`` and ``"0.3 m"`` with default cm both give 30. Raises InputError for anything else and for a unit of
    another dimension.
    """
    match = _NUMBER_WITH_UNIT.fullmatch(text)
    if match is None:
        raise InputError(
            Problem("expected a number", key=key, value=text, remedy=f'write it like "30" or "30 {default.name}"')
        )
    try:
        value, name = checked(Decimal(match[1]), key), match[2]
    except ArithmeticError:
        raise InputError(Problem("expected a number of ordinary size", key=key, value=text[:40])) from None
    if name is None or name == default.name:
        return value
    if name not in UNITS:
        fitting = [other.name for other in UNITS.values() if other.measures == default.measures]
        raise InputError(Problem("unknown unit", key=key, value=name, remedy="use one of: " + ", ".join(fitting)))
    given = UNITS[name]
    if given.measures != default.measures:
        raise InputError(
            Problem(
                f"the unit {name} measures {given.measures}, {default.measures} is due",
                key=key,
                value=text,
                remedy=f"use {default.name} or another unit of {default.measures}",
            )
        )
    if given.turn == default.turn and (value * given.factor) % default.factor.scaleb(-_DECIMALS) == 0:
        return value * given.factor / default.factor
    return Decimal(repr(round(default.from_si(given.to_si(value)), _DECIMALS)))
