"""A parameter of a family: the grid of its printed values, and the same in SI."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal
from functools import cached_property

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.families.parameters.units import Unit


class Parameter(Struct, frozen=True, dict=True):
    """A drawn parameter: its grid of printed values, and the same in SI.

    A choice parameter has ``words`` and no unit. ``symbol`` is how it is written (``omega_OA``, ``phi``). A
    ``constant`` has the dimension of a rate but is none that the figure shows (g, the acceleration of free fall).
    A ``silent`` parameter only gives the figure variety: it is not printed and no answer may depend on it. One that is
    ``found`` is the instant at which something happens: it is not printed, and can be asked.
    """

    name: str
    unit: Unit | None
    printed: tuple[Decimal, ...]
    words: tuple[str, ...] = ()
    symbol: str = ""
    constant: bool = False
    silent: bool = False
    found: bool = False

    @cached_property
    def si(self) -> NDArray[np.float64]:
        """The grid in SI, shape (G,): what is printed is what is solved."""
        return np.array([self._to_si(value) for value in self.printed])

    def in_si(self, printed: Iterable[Decimal]) -> NDArray[np.float64]:
        """Printed values in SI, shape (N,); they need not lie on the grid."""
        known = self._on_grid
        return np.array([known[value] if value in known else self._to_si(value) for value in printed])

    @cached_property
    def _on_grid(self) -> dict[Decimal, float]:
        return dict(zip(self.printed, self.si.tolist(), strict=True))

    def _to_si(self, value: Decimal) -> float:
        return float(value) if self.unit is None else self.unit.to_si(value)

    @property
    def given(self) -> bool:
        """Whether its value is printed (a choice is seen in the figure)."""
        return self.unit is not None and not self.silent and not self.found

    @property
    def is_rate(self) -> bool:
        """Whether it is a velocity, acceleration or their angular kin, whose sign the figure shows."""
        return self.unit is not None and self.unit.dimension[1] < 0 and not self.constant

    @property
    def of_second_order(self) -> bool:
        """Whether it is an acceleration, no constant: only accelerations depend on it, and what laws make of it."""
        return self.unit is not None and self.unit.dimension[1] == -2 and not self.constant
