"""What an exam file says of tolerances."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from typing import Any

from variantgen.tables import Table

_LARGEST = 0.2


@dataclass(frozen=True)
class Tolerance:
    """Relative tolerances of answers (of an angle in radians).

    ``floor``: the least one. ``ceiling``: a variant on which a careful hand calculation with three significant digits
    would need more is not drawn. ``mistakes``: nor one on which a plausible mistake leads to an answer within the
    tolerance.
    """

    floor: float = 0.01
    ceiling: float = 0.03
    mistakes: bool = True


def read_tolerance(table: Table) -> Tolerance:
    """The key ``tolerance`` of an exam file: a number, the floor, or a table; mistakes are noted in the table."""
    given: Any = table.take("tolerance", (int, Decimal, dict), {}, "a number or a table")
    usual = Tolerance()
    if not isinstance(given, dict):
        floor = float(given)
        if not 0 < floor <= _LARGEST:
            table.problem(f"expected a number between 0 and {_LARGEST:g}", "tolerance", floor)
            return usual
        return Tolerance(floor, max(floor, usual.ceiling))
    inner = table.table("tolerance")
    floor = float(inner.number("floor", Decimal(str(usual.floor))))
    ceiling = float(inner.number("ceiling", Decimal(str(max(floor, usual.ceiling)))))
    mistakes = inner.take("mistakes", bool, usual.mistakes)
    inner.finish()
    if not 0 < floor <= _LARGEST:
        inner.problem(f"expected a number between 0 and {_LARGEST:g}", "floor", floor)
        return usual
    if not floor <= ceiling <= _LARGEST:
        inner.problem(f"expected a number between the floor, {floor:g}, and {_LARGEST:g}", "ceiling", ceiling)
        return usual
    return Tolerance(floor, ceiling, mistakes)
