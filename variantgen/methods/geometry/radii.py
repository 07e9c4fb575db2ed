"""Symbols of radii that the figure gives no name."""

from __future__ import annotations

from variantgen.methods.algebra.expression import Value
from variantgen.methods.algebra.name import Name

_SAME = 1e-9  # relative difference within which two radii are one, but for rounding


class UnnamedRadii:
    """The radii of bodies as they are met: ``r_spool``, a second one of the same body ``r_2 spool``."""

    def __init__(self) -> None:
        self._met: dict[str, list[Value]] = {}

    def of(self, body: str, exact: float) -> Value:
        """The radius of that length (printed unit) of a body."""
        met = self._met.setdefault(body, [])
        for value in met:
            if abs(value.exact - exact) <= _SAME * exact:
                return value
        number = str(len(met) + 1) if met else ""
        met.append(Value(Name("radius", body, number), "length", exact))
        return met[-1]
