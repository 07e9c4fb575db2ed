"""Numbers as programs read them, whatever the language of the exam."""

from __future__ import annotations

from decimal import Decimal


def number(value: float | Decimal) -> str:
    """A number with a decimal point if it needs one and without an exponent, as every platform reads it."""
    exact = Decimal(repr(value)) if isinstance(value, float) else value
    return format(exact.normalize() if exact else Decimal(0), "f")
