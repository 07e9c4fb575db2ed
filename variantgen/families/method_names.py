"""The names of the methods by which a problem may be solved: for family files, exam files and commands."""

from __future__ import annotations

from collections.abc import Iterable

from variantgen.errors import InputError, Problem, nearest

METHODS = (
    "analytical",
    "velocity_pole",
    "projections",
    "velocity_centre",
    "acceleration_pole",
    "acceleration_centre",
    "relative_motion",
    "three_rates",
    "graphical",
    "coordinates",
)


def check_methods(names: Iterable[str], key: str = "method") -> tuple[str, ...]:
    """The names as they are. Raises InputError with every one that is unknown or stands twice."""
    found: list[str] = []
    problems: list[Problem] = []
    for name in names:
        if name not in METHODS:
            problems.append(Problem("unknown method", key=key, value=name, remedy=nearest(name, METHODS)))
        elif name in found:
            problems.append(Problem("a method is named twice", key=key, value=name, remedy="name it once"))
        found.append(name)
    if problems:
        raise InputError(problems)
    return tuple(found)
