"""Results in lines: one for each class (or group) and way."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from types import ModuleType

import numpy as np
from msgspec import Struct

from variantgen.accuracy.measure import FAILURES, Errors, discovered
from variantgen.accuracy.run import CaseClass, Measurement


class ResultRow(Struct, frozen=True):
    """Median and largest errors of velocities and accelerations, and largest errors over (kappa eps).

    ``microseconds`` per variant in batches of ``batch``; ``variants`` tried, ``failures`` by kind; NaN where nothing
    was measured.
    """

    title: str
    group: str
    way: str
    variants: int
    velocity: float
    velocity_most: float
    acceleration: float
    acceleration_most: float
    factor: float
    factor_most: float
    microseconds: float
    batch: int
    failures: dict[str, int]
    least_failed: float

    @property
    def solved(self) -> int:
        """Variants with a result."""
        return self.variants - sum(self.failures.values())

    @property
    def module(self) -> ModuleType:
        """The way."""
        return discovered()[self.way]


def by_group(measured: Measurement) -> list[ResultRow]:
    """A line for each group and way."""
    return [_result_row(case.title, e.group, [e]) for case in measured.classes for e in case.errors if not e.absent]


def by_class(case: CaseClass) -> list[ResultRow]:
    """A line for each way in a class."""
    found = []
    for way in discovered():
        errors = [e for e in case.errors if e.way == way and not e.absent]
        if errors:
            found.append(_result_row(case.title, "", errors))
    return found


def _result_row(title: str, group: str, errors: Sequence[Errors]) -> ResultRow:
    rows = np.array([row for e in errors for row in e.rows]).reshape(-1, 3)
    factors = np.array([row for e in errors for row in e.factors]).reshape(-1, 2)
    seconds = [e.seconds for e in errors if math.isfinite(e.seconds)]
    return ResultRow(
        title,
        group,
        errors[0].way,
        sum(e.variants for e in errors),
        _of(np.median, rows[:, 1]),
        _of(np.max, rows[:, 1]),
        _of(np.median, rows[:, 2]),
        _of(np.max, rows[:, 2]),
        _of(np.median, factors.ravel()),
        _of(np.max, factors.ravel()),
        1e6 * _of(np.median, seconds),
        max(e.batch for e in errors),
        {name: sum(e.failures[name] for e in errors) for name in FAILURES},
        min(e.least_failed for e in errors),
    )


def _of(measure: object, values: Iterable[float]) -> float:
    found = np.array(list(values))
    return float(measure(found)) if found.size else math.nan  # type: ignore[operator]  # a function of numpy
