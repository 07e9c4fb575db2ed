"""How the points of a problem are divided over its parts."""

from __future__ import annotations

from decimal import Decimal


def shares(points: int | None, parts: int) -> tuple[Decimal, ...]:
    """The points of each part, in hundredths, equal as far as they can be; their sum is that of the problem.

    A problem without points has one for each part.
    """
    hundredths = 100 * (parts if points is None else points)
    least, more = divmod(hundredths, parts)
    return tuple(Decimal(least + (place < more)) / 100 for place in range(parts))
