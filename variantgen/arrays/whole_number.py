"""Whole numbers among the arguments of functions for Python."""

from __future__ import annotations

import operator
from typing import Any

from variantgen.errors import InputError, Problem


def whole_number(value: Any, key: str, least: int, most: int) -> int:
    """The value as a whole number between two bounds; those of numpy are welcome. Raises InputError."""
    try:
        number = least - 1 if isinstance(value, bool) else operator.index(value)
    except TypeError:
        number = least - 1
    if not least <= number <= most:
        raise InputError(Problem(f"expected a whole number from {least} to {most}", key=key, value=repr(value)))
    return number
