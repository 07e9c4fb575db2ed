"""Straight lines of a scene: which points lie on one, and its direction as the constructions give it."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping

from msgspec import Struct

from variantgen.methods.geometry.angles import AngleForm, between


class _Line(Struct):
    form: AngleForm
    points: set[str]


class Lines:
    """Lines with two points or more; ``at`` places points on paper, ``number`` tells the degrees of a direction.

    The places only decide which of the two ways along a line is meant.
    """

    def __init__(self, at: Mapping[str, complex], nothing: float, number: Callable[[AngleForm], float]) -> None:
        self._at = at
        self._nothing = nothing
        self._number = number
        self._lines: list[_Line] = []

    def add(self, start: str, end: str, form: AngleForm) -> None:
        """Note that a line of this direction goes through two points."""
        ends = {start, end}
        same = [line for line in self._lines if not ends.isdisjoint(line.points) and line.form.is_along(form)]
        if same:
            self._lines = [line for line in self._lines if line not in same]
        self._lines.append(_Line(same[0].form if same else form, ends.union(*(line.points for line in same))))

    def form(self, start: str, end: str) -> AngleForm | None:
        """The direction of the ray from one point to another, if both lie on a line; None if they are in one place."""
        step = self._at[end] - self._at[start]
        if abs(step) <= self._nothing:
            return None
        for line in self._lines:
            if start in line.points and end in line.points:
                apart = between(math.degrees(cmath.phase(step)), self._number(line.form))
                return line.form if apart < 90.0 else line.form.turned(180.0)
        return None
