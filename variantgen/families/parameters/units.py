"""Units that may stand in a family file and on a sheet, with exact decimal factors to the SI."""

from __future__ import annotations

import math
import re
from decimal import Decimal
from typing import TypeVar

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.errors import InputError, Problem, nearest

Number = TypeVar("Number", float, NDArray[np.float64])


class Unit(Struct, frozen=True):
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
        """Whether the unit is not made of inches, feet, yards or miles."""
        return self.name.partition("/")[0] not in ("in", "ft", "yd", "mi")

    def to_si(self, value: Decimal) -> float:
        """A printed value in SI, rounded once (twice for degrees and rpm)."""
        return float(value * self.factor) * self.turn

    @property
    def size(self) -> float:
        """One of it in SI."""
        return float(self.factor) * self.turn

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
    "yd": Decimal("0.9144"),
    "km": Decimal(1000),
    "mi": Decimal("1609.344"),
}
# Velocities in which the time is no second: a length and a time of so many seconds.
_PER_LONGER = [("km", "h"), ("mi", "h"), ("m", "min"), ("ft", "min"), ("in", "min")]
_SECONDS = {"min": 60, "h": 3600}
# Other spellings of a unit or of a part of it, by what stands in their place.
_SPELLED = {"²": "^2", "**2": "^2", "°": "deg", "об/мин": "rpm", "rev/min": "rpm", "r/min": "rpm", "mph": "mi/h"}


IN_LONGER_TIMES = {f"{way}/{time}": _SECONDS[time] for way, time in _PER_LONGER}  # with the seconds of the time


def _table() -> dict[str, Unit]:
    one = Decimal(1)
    units = [Unit(name, (1, 0), factor, "length") for name, factor in LENGTHS.items()]
    units += [Unit(f"{name}/s", (1, -1), factor, "velocity") for name, factor in LENGTHS.items()]
    units += [Unit(f"{name}/s^2", (1, -2), factor, "acceleration") for name, factor in LENGTHS.items()]
    units += [Unit(f"{way}/{time}", (1, -1), LENGTHS[way], "velocity", 1 / _SECONDS[time]) for way, time in _PER_LONGER]
    angles = {"rad": 1.0, "deg": math.pi / 180, "rev": math.tau}
    units += [Unit(name, (0, 0), one, "angle", turn) for name, turn in angles.items()]
    units += [Unit("1", (0, 0), one, "number")]
    units += [Unit(f"{name}/s", (0, -1), one, "angular velocity", turn) for name, turn in angles.items()]
    units += [Unit("rpm", (0, -1), one, "angular velocity", math.pi / 30)]
    units += [Unit(f"{name}/s^2", (0, -2), one, "angular acceleration", turn) for name, turn in angles.items()]
    units += [
        Unit("rpm/s", (0, -2), one, "angular acceleration", math.pi / 30),
        Unit("s", (0, 1), one, "time"),
        Unit("min", (0, 1), Decimal(60), "time"),
        Unit("h", (0, 1), Decimal(3600), "time"),
    ]
    return {unit.name: unit for unit in units}


UNITS = _table()
_LARGEST_EXPONENT = 12
_DECIMALS = 12  # of a number in another unit, where it does not end
_SHORTER, _SHORT, _SAME = 4, 6, 1e-10  # digits of a number that is stated as it is; what a conversion rounds, relative
_NUMBER_WITH_UNIT = re.compile(
    r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(?:\s*/\s*(\d+\.?\d*))?\s*((?:[^\W\d_]|°)[\w/^°²*-]*)?\s*"
)


def usual_name(name: str) -> str:
    """The name of a unit in the spelling of the table: ``ft/s²`` is ``ft/s^2``, ``rev/min`` is ``rpm``."""
    spelled = name.strip()
    for other, own in _SPELLED.items():
        spelled = spelled.replace(other, own)
    return spelled


def unit(name: str, key: str = "unit") -> Unit:
    """The unit of that name; InputError with the nearest names if there is none."""
    found = UNITS.get(name) or UNITS.get(usual_name(name))
    if found is None:
        raise InputError(Problem("unknown unit", key=key, value=name, remedy=nearest(name, UNITS)))
    return found


def short_unit(si: float, usual: Unit) -> Unit:
    """The unit in which a rate (SI) is a short number: rpm, km/h and the like where it is none in the usual unit."""
    longer = {"angular velocity": ["rpm"], "angular acceleration": ["rpm/s"], "velocity": IN_LONGER_TIMES}
    others = (UNITS[name] for name in longer.get(usual.measures, ()))
    units = [usual, *sorted(others, key=lambda other: other.is_metric != usual.is_metric)]
    found = (own for digits in (_SHORTER, _SHORT) for own in units if _is_short(own.from_si(si), digits))
    return next(found, usual)


def _is_short(number: float, digits: int) -> bool:
    return abs(float(f"{number:.{digits}g}") - number) <= _SAME * abs(number)


def checked(value: Decimal, key: str) -> Decimal:
    """The value itself; InputError if it is not finite or far beyond anything that can be drawn or built."""
    if not value.is_finite() or (value != 0 and abs(value.adjusted()) > _LARGEST_EXPONENT):
        raise InputError(Problem("expected a number of ordinary size", key=key, value=str(value)[:40]))
    return value


def is_number(text: str) -> bool:
    """Whether a text is a number, bare or followed by a unit (and not an expression)."""
    return _NUMBER_WITH_UNIT.fullmatch(text) is not None


def parse_value(text: str, default: Unit, key: str) -> Decimal:
    """A number or a fraction, with or without a unit, as a value in the unit ``default``.

    ``"30"`` and ``"0.3 m"`` with default cm both give 30, ``"5/3"`` 1.666666666667. Raises InputError for anything else
    and for a unit of another dimension.
    """
    match = _NUMBER_WITH_UNIT.fullmatch(text)
    if match is None:
        raise InputError(
            Problem("expected a number", key=key, value=text, remedy=f'write it like "30" or "30 {default.name}"')
        )
    try:
        value, name = checked(Decimal(match[1]), key), match[3] and usual_name(match[3])
        if match[2] is not None:
            value = checked(_rounded(float(value / Decimal(match[2]))), key)
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
    return _rounded(default.from_si(given.to_si(value)))


def _rounded(value: float) -> Decimal:
    """A number that does not end, with so many decimals, or as many digits where it is small."""
    small = max(0, -Decimal(value).adjusted()) if value else 0
    return Decimal(repr(round(value, _DECIMALS + small)))
