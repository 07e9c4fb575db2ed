"""Symbols of radii that the figure gives no name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from variantgen.algebra.expression import Value
from variantgen.algebra.name import Name

_SAME = 1e-9  # relative difference within which two radii are one, but for rounding


class UnnamedRadii:
    """The radii of bodies as they are met: ``r_spool``, a second one of the same body ``r_2 spool``.

    Those that a scene gives as numbers come first, as its data have them: ``given`` (printed unit).
    """

    def __init__(self, given: Mapping[str, Sequence[float]]) -> None:
        self._met = {body: list(radii) for body, radii in given.items()}

    def of(self, body: str, exact: float) -> Value:
        """The radius of that length (printed unit) of a body."""
        return Value(self.named(body, exact), "length", exact)

    def named(self, body: str, exact: float) -> Name:
        """The name of that radius; equal radii of a body have one."""
        met = self._met.setdefault(body, [])
        same = [place for place, radius in enumerate(met) if abs(radius - exact) <= _SAME * exact]
        place = same[0] if same else len(met)
        if not same:
            met.append(exact)
        return Name("radius", body, str(place + 1) if place else "")
