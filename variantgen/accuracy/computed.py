"""What a way to compute has found for a batch of variants, and the batches themselves."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Protocol

import numpy as np
from msgspec import Struct, field
from numpy.typing import NDArray

from variantgen.mechanism.scene import Scene


class Computed(Struct, frozen=True):
    """Places, velocities, accelerations by point and by body, shape (N,) each; what a way does not find is left out.

    ``refused``: which variants the way itself says it cannot solve; ``lost``: for which it did not converge.
    """

    z: Mapping[str, Any]
    v: Mapping[str, Any]
    a: Mapping[str, Any]
    omega: Mapping[str, Any]
    epsilon: Mapping[str, Any]
    refused: NDArray[np.bool_] | None = None
    lost: NDArray[np.bool_] | None = None

    def one(self, index: int) -> Computed:
        """The variant at an index."""
        return self.each(lambda values: values[index])

    def each(self, change: Callable[[Any], Any]) -> Computed:
        """The same with every value changed; without flags."""
        z, v, a, omega, epsilon = (
            {name: change(values) for name, values in table.items()}
            for table in (self.z, self.v, self.a, self.omega, self.epsilon)
        )
        return Computed(z, v, a, omega, epsilon)

    @property
    def finite(self) -> bool:
        """Whether all numbers are finite."""
        tables = (self.z, self.v, self.a, self.omega, self.epsilon)
        return all(bool(np.all(np.isfinite(x))) for table in tables for x in table.values())


class Textbook(Protocol):
    """A mechanism with a closed form in real coordinates; its numbers have the shape (N,)."""

    def scene(self) -> Scene:
        """The mechanism as a scene."""
        ...

    def closed_form(self) -> Computed:
        """Positions, velocities and accelerations by the formulas of the textbooks."""
        ...

    def coordinates(self, time: Any) -> dict[str, tuple[Any, Any]]:
        """Coordinates x, y of the points, in operations that hold for complex times too."""
        ...

    def links(self) -> Mapping[str, tuple[str, str]]:
        """Of each link its two ends."""
        ...

    def take(self, index: Any) -> Textbook:
        """The variants at some indices."""
        ...

    def rate(self) -> Any:
        """How fast the driving link turns (rad/s), for steps of time."""
        ...


class CaseGroup(Struct, frozen=True):
    """Variants of one structure: a scene of the shape (size,), and the closed form where there is one."""

    label: str
    scene: Scene
    size: int
    textbook: Textbook | None = None
    notes: Mapping[str, float] = field(default_factory=dict)
