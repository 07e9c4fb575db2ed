"""A point near a stated place; where exactly, the conditions of the scene decide."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from msgspec import Struct

from variantgen.mechanism.arithmetic import Complex, Flags
from variantgen.mechanism.component import Length
from variantgen.mechanism.outcome import Outcome


class Near(Struct, frozen=True):
    """``z = x + i y`` (m) is where the search starts: the picture from which the assembly branch is taken."""

    x: Length
    y: Length
    failure: ClassVar[Outcome] = Outcome.NOT_ASSEMBLED

    def place(self, at: Mapping[str, Complex]) -> tuple[Complex, Flags]:
        """The stated place; :mod:`variantgen.mechanism.assembly` moves it to where the conditions hold."""
        position: Complex = self.x + 1j * self.y
        return position, True
