"""What an exam file says of the work of its variants: how equal it is, and how much a problem may take."""

from __future__ import annotations

from decimal import Decimal
from typing import Any

from variantgen.tables import Table

Span = tuple[int, int]  # least and most, both included

WIDTH = 0.05  # the most calculations of a problem are so much more than the least, relatively
_LARGEST = 1.0
MOST = 10_000  # calculations of any problem
# Thirds of the forms of the catalogue by the calculations of their usual variants (benchmarks/fairness.md).
LEVELS: dict[str, Span] = {"easy": (1, 32), "medium": (33, 46), "hard": (47, MOST)}


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


def read_work(table: Table) -> Span | None:
    """The keys ``work = [20, 30]`` (calculations) and ``level`` of a problem; mistakes are noted in the table."""
    table.expect("work", "level")
    if "level" in table.data:
        if "work" in table.data:
            table.problem("both level and work are given", "level", table.data["level"], "keep one of them")
        return LEVELS[table.choice("level", tuple(LEVELS))]
    if "work" not in table.data:
        return None
    given: Any = table.take("work", list, [1, MOST], "two whole numbers, as in [20, 30]")
    whole = len(given) == 2 and all(type(number) is int for number in given)
    if not (whole and 1 <= given[0] <= given[1] <= MOST):
        got = f"[{', '.join(map(str, given))}]"
        remedy = f"the fewest come first: [{given[1]}, {given[0]}]" if whole and given[0] > given[1] else "[20, 30]"
        table.problem(f"expected the fewest and the most calculations, whole numbers up to {MOST}", "work", got, remedy)
        return None
    return given[0], given[1]


def level_of(calculations: float) -> str:
    """The level of a form whose usual variants take so many calculations."""
    return next(name for name, (_, most) in LEVELS.items() if calculations < most + 1)
