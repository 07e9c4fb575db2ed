"""How the points of a problem are divided over its parts."""

from __future__ import annotations

from decimal import Decimal


def shares(points: int | None, parts: int, steps: int = 100) -> tuple[Decimal, ...]:
    """The points of each part, in hundredths, equal as far as they can be; their sum is that of the problem.

    A problem without points has one for each part. ``steps`` of a point are told apart: 1 makes whole numbers.
    """
    least, more = divmod(steps * (parts if points is None else points), parts)
    return tuple(Decimal(least + (place < more)) / steps for place in range(parts))
