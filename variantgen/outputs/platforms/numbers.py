"""Numbers as programs read them, whatever the language of the exam."""

from __future__ import annotations

from decimal import Decimal


def plain(value: Decimal) -> str:
    """A number with a decimal point and without an exponent."""
    text = f"{value:f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text in ("-0", "") else text
