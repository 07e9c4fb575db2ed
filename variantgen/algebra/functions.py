"""The functions of angles in degrees, the inverse ones, and those of plain numbers, by their names in formulas."""

from __future__ import annotations

import math
from collections.abc import Callable

HIGHEST = 700.0  # of what the exponential function is taken; beyond it numbers are infinite

FUNCTIONS: dict[str, Callable[[float], float]] = {
    "cos": lambda x: math.cos(math.radians(x)),
    "sin": lambda x: math.sin(math.radians(x)),
    "tan": lambda x: math.tan(math.radians(x)),
    "arctan": lambda x: math.degrees(math.atan(x)),
    "arcsin": lambda x: math.degrees(math.asin(min(1.0, max(-1.0, x)))),  # rounding may have made it larger than 1
    "arccos": lambda x: math.degrees(math.acos(min(1.0, max(-1.0, x)))),
    "exp": lambda x: math.exp(min(x, HIGHEST)),
    "ln": lambda x: math.log(x) if x > 0 else -math.inf,
}
