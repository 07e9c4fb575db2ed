"""Rounding as on paper: halves away from zero, whatever the last bits of the machine say of a half."""

from __future__ import annotations

import math
from decimal import ROUND_HALF_UP, Decimal

ANGLE = "angle"
DRAWING_LENGTH = "drawing length"  # mm on paper, laid off and read to a tenth
WHOLE_DEGREES = 2  # so many digits of an angle stand before the point, as far as precision goes
PRINTED_DIGITS = 4  # significant digits of a number of the solution
# Significant digits that are no rounding of the machine: 10.625 is 10.63, be it 10.624999999999998 there.
SURE_DIGITS = 13


def rounded_to_digits(value: float, digits: int) -> Decimal:
    """A finite number with so many significant digits."""
    exact = _sure(value)
    rounded = exact.quantize(Decimal(1).scaleb(exact.adjusted() - digits + 1), ROUND_HALF_UP)
    if rounded.adjusted() > exact.adjusted():  # carried into a new leading digit
        rounded = rounded.quantize(Decimal(1).scaleb(rounded.adjusted() - digits + 1))
    return rounded


def rounded_to_places(value: float, places: int) -> Decimal:
    """A finite number with so many decimals."""
    return _sure(value).quantize(Decimal(1).scaleb(-places), ROUND_HALF_UP)


def _sure(value: float) -> Decimal:
    return Decimal(f"{value:.{SURE_DIGITS - 1}e}")


def rounded(number: float, digits: int, measure: str = "") -> float:
    """A number with so many significant digits; an angle (degrees) with the decimals that are worth as much,
    a length on a drawing to 0.1 mm.
    """
    if number == 0 or not math.isfinite(number):
        return 0.0 if number == 0 else number
    if measure == DRAWING_LENGTH:
        return float(rounded_to_places(number, 1)) + 0.0
    if measure == ANGLE:
        return float(rounded_to_places(number, digits - WHOLE_DEGREES)) + 0.0
    return float(rounded_to_digits(number, digits))


def decimals_of(number: float) -> int:
    """The decimals of a number as it is written."""
    exponent = Decimal(repr(number)).normalize().as_tuple().exponent
    assert isinstance(exponent, int)
    return max(0, -exponent)
