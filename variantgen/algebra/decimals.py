"""Rounding as on paper: halves away from zero, whatever the last bits of the machine say of a half."""

from __future__ import annotations

from decimal import ROUND_HALF_UP, Decimal

# Significant digits that are no rounding of the machine: 10.625 is 10.63, be it 10.624999999999998 there.
_SURE = 13


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
    return Decimal(f"{value:.{_SURE - 1}e}")
