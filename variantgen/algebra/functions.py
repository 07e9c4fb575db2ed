"""The functions of angles in degrees, and the inverse ones, by their names in formulas."""

from __future__ import annotations

import math
from collections.abc import Callable

FUNCTIONS: dict[str, Callable[[float], float]] = {
    "cos": lambda x: math.cos(math.radians(x)),
    "sin": lambda x: math.sin(math.radians(x)),
    "tan": lambda x: math.tan(math.radians(x)),
    "arctan": lambda x: math.degrees(math.atan(x)),
    "arcsin": lambda x: math.degrees(math.asin(min(1.0, max(-1.0, x)))),  # rounding may have made it larger than 1
    "arccos": lambda x: math.degrees(math.acos(min(1.0, max(-1.0, x)))),
}
