"""What an exam file says of tolerances."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from variantgen.tables import Table

LARGEST = 0.2


class Tolerance(Struct, frozen=True):
    """Relative tolerances of answers (of an angle in radians).

    ``floor``: the least one. ``ceiling``, if there is one: a variant on which what is asked would need more in a
    careful hand calculation with three significant digits is drawn again. ``mistakes``: nor is one drawn on which a
    plausible mistake goes unnoticed. What a draw must bear anyway is said by the screens of its family.
    """

    floor: float = 0.01
    ceiling: float | None = None
    mistakes: bool = True


_USUAL = Tolerance()


def places_by_tolerance(tolerances: Iterable[Tolerance]) -> dict[Tolerance, list[int]]:
    """The indices of the problems that are marked by each tolerance."""
    found: dict[Tolerance, list[int]] = {}
    for i, tolerance in enumerate(tolerances):
        found.setdefault(tolerance, []).append(i)
    return found


def read_tolerance(table: Table, usual: Tolerance = _USUAL) -> Tolerance:
    """The key ``tolerance`` of an exam file, or of one of its problems: a number, the floor, or a table.

    What it does not say is as ``usual``; mistakes are noted in the table.
    """
    if "tolerance" not in table.data:
        table.expect("tolerance")
        return usual
    given: Any = table.take("tolerance", (int, Decimal, dict), {}, "a number or a table")
    if not isinstance(given, dict):
        floor = float(given)
        if not 0 < floor <= LARGEST:
            table.problem(f"expected a number between 0 and {LARGEST:g}", "tolerance", floor)
            return usual
        return Tolerance(floor, _at_least(usual.ceiling, floor), usual.mistakes)
    inner = table.table("tolerance")
    floor = float(inner.number("floor", Decimal(str(usual.floor))))
    ceiling = float(inner.number("ceiling", 0)) if "ceiling" in inner.data else _at_least(usual.ceiling, floor)
    inner.expect("ceiling")
    mistakes = inner.take("mistakes", bool, usual.mistakes)
    inner.finish()
    if not 0 < floor <= LARGEST:
        inner.problem(f"expected a number between 0 and {LARGEST:g}", "floor", floor)
        return usual
    if ceiling is not None and not floor <= ceiling <= LARGEST:
        inner.problem(f"expected a number between the floor, {floor:g}, and {LARGEST:g}", "ceiling", ceiling)
        return usual
    return Tolerance(floor, ceiling, mistakes)


def with_floor(tolerance: Tolerance, floor: float) -> Tolerance:
    """A tolerance with another floor; a ceiling that would be below it is left out."""
    kept = tolerance.ceiling is not None and tolerance.ceiling >= floor
    return replace(tolerance, floor=floor, ceiling=tolerance.ceiling if kept else None)


def _at_least(ceiling: float | None, floor: float) -> float | None:
    """A ceiling that is not below the floor, if there is one."""
    return None if ceiling is None else max(ceiling, floor)
