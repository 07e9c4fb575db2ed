"""Angles of right triangles with whole sides: 3:4:5, 5:12:13, 8:15:17, 7:24:25. Their functions stay fractions."""

from __future__ import annotations

import math

_TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25))
_PLACES = 11  # decimals by which functions are told apart: no angle in whole degrees, or to a hundredth, is so near
_FUNCTIONS = {"sin": math.sin, "cos": math.cos, "tan": math.tan}
_RATIOS = {
    name: {
        round(top / under, _PLACES): (top, under)
        for a, b, c in _TRIPLES
        for top, under in (((a, b), (b, a)) if name == "tan" else ((a, c), (b, c)))
    }
    for name in _FUNCTIONS
}


def ratio(function: str, degrees: float) -> tuple[int, int] | None:
    """The function of an acute angle as a ratio of two sides, ``cos = 4/5``; None where it is no such angle."""
    known = _FUNCTIONS.get(function)
    return None if known is None else _RATIOS[function].get(round(known(math.radians(degrees)), _PLACES))
