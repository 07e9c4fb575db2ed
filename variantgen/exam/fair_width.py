"""What an exam file says of fair variants."""

from __future__ import annotations

from decimal import Decimal
from typing import Any

from variantgen.tables import Table

WIDTH = 0.05  # the most calculations of a problem are so much more than the least, relatively
_LARGEST = 1.0


def read_fair(table: Table) -> float | None:
    """The key ``fair``: true (the usual width), false (None) or a width of its own; mistakes are noted in the table."""
    if isinstance(table.data.get("fair", True), bool):
        return WIDTH if table.take("fair", bool, True) else None
    given: Any = table.take("fair", (int, Decimal), WIDTH, "true, false or a number")
    if not 0 < float(given) <= _LARGEST:  # nor what is no number
        remedy = "0.05 lets one variant take 5 % more calculations than another; false leaves it to chance"
        table.problem(f"expected a number above 0, at most {_LARGEST:g}", "fair", given, remedy)
        return WIDTH
    return float(given)
