"""A point given by its coordinates."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Flags
from variantgen.mechanism.component import Length
from variantgen.mechanism.outcome import Outcome


class Coordinates(Struct, frozen=True):
    """``z = x + i y`` (m)."""

    x: Length
    y: Length
    failure: ClassVar[Outcome] = Outcome.DEGENERATE

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """Position (m) and whether it exists (always)."""
        position: Complex = self.x + 1j * self.y
        return position, True
