"""Rounding as on paper: halves away from zero, whatever the last bits of the machine say of a half."""

from __future__ import annotations

import math
from decimal import ROUND_HALF_UP, Decimal

ANGLE = "angle"
DRAWING_LENGTH = "drawing length"  # mm on paper, laid off and read to a tenth
WHOLE_DEGREES = 2  # so many digits of an angle stand before the point, as far as precision goes
PRINTED_DIGITS = 4  # significant digits of a number of the solution
RECORDED_DIGITS = 8  # of an answer in keys and manifests, which the last bits of a machine do not change
SURE_DIGITS = 13  # significant digits that are no rounding of the machine
_SAME = 1e-12  # relative difference of two numbers that are one, but for rounding of the arithmetic


def rounded_to_digits(value: float, digits: int) -> Decimal:
    """A finite number with so many significant digits."""
    exact = _as_recorded(value, digits)
    rounded = exact.quantize(Decimal(1).scaleb(exact.adjusted() - digits + 1), ROUND_HALF_UP)
    if rounded.adjusted() > exact.adjusted():  # carried into a new leading digit
        rounded = rounded.quantize(Decimal(1).scaleb(rounded.adjusted() - digits + 1))
    return rounded


def rounded_to_places(value: float, places: int) -> Decimal:
    """A finite number with so many decimals."""
    return _as_recorded(value).quantize(Decimal(1).scaleb(-places), ROUND_HALF_UP)


def _as_recorded(value: float, digits: int = 0) -> Decimal:
    """A number as keys have it, so that a step, whose value is not recorded, and its answer, which is read back, end
    alike: 2.50049995 is recorded as 2.5005 and is 2.501 in both, and 10.625 is 10.63, be it 10.624999999999998 here.
    """
    return Decimal(f"{value:.{max(digits, RECORDED_DIGITS) - 1}e}")


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
    mantissa, _, exponent = repr(number).partition("e")
    return max(0, len(mantissa.partition(".")[2].rstrip("0")) - int(exponent or 0))


def decimals_shown(shown: float, exact: float, measure: str) -> int:
    """The decimals to which a printed number is rounded, negative for tens; of an exact one those that it has."""
    if shown == 0 or not math.isfinite(shown):
        return 0
    is_exact = abs(shown - exact) <= _SAME * abs(exact)
    return decimals_of(shown) if is_exact else max(decimals_of(shown), usual_decimals(shown, measure))


def usual_decimals(shown: float, measure: str) -> int:
    """The decimals of the last of as many digits as numbers of a measure are printed with."""
    of_number = PRINTED_DIGITS - 1 - math.floor(math.log10(abs(shown))) if shown else PRINTED_DIGITS
    return {DRAWING_LENGTH: 1, ANGLE: PRINTED_DIGITS - WHOLE_DEGREES}.get(measure, of_number)
