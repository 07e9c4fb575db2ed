"""The motion of a form by its laws of time: the scene at any instant of an interval."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.mechanism.arithmetic import Real
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene


@dataclass(frozen=True)
class Interval:
    """An interval of time as a form states it: the parameter that is the instant, and both ends."""

    time: str
    start: FamilyExpression
    end: FamilyExpression


@dataclass(frozen=True)
class FoundInstant:
    """What the instant of a problem is found by: when a law of time or a quantity first has a value in the interval.

    ``name`` is that of the law or of the quantity, ``value`` as it is written, in the unit of that name.
    """

    name: str
    value: Decimal
    unit: str


class MovingForm(Protocol):
    """What a course needs of a form: its scene for any values of its parameters, and whether its instant is found."""

    @property
    def found_instant(self) -> FoundInstant | None:
        """By what the instant of the problem is found; None where it is given."""
        ...

    def values(self, parameters: Mapping[str, Real]) -> dict[str, Real]:
        """Parameters in SI together with the derived quantities."""
        ...

    def scene(self, values: Mapping[str, Real], on_paper: Frame | None = None) -> Scene:
        """The scene for these values."""
        ...


@dataclass(frozen=True)
class FormInTime:
    """The motion of variants of a form in its interval of time, from ``start`` to ``end`` (s).

    ``parameters`` are those of the instant of the problem, in SI, scalars or of shape (N,), ``time`` the name of the
    one that is the instant; ``frame`` is the pose.
    """

    form: MovingForm
    time: str
    parameters: Mapping[str, Real]
    frame: Frame
    start: Real
    end: Real

    def at(self, variants: NDArray[np.intp], times: NDArray[np.float64]) -> Scene:
        """The scenes of variants at instants (s), shape (M,) each, as one batch."""

        def own(value: Real) -> Any:
            return value[variants] if np.ndim(value) else value

        data = {name: own(value) for name, value in self.parameters.items()} | {self.time: times}
        frame = Frame(own(self.frame.turn), own(self.frame.sense)) if np.ndim(self.frame.turn) else self.frame
        return self.form.scene(self.form.values(data), frame)

    @property
    def found(self) -> str:
        """The name of the instant, if it is found and not given."""
        return self.time if self.form.found_instant else ""

    def take(self, index: NDArray[Any] | int, size: int) -> FormInTime:
        """The variants chosen by indices, shape (K,), a mask, shape (N,), or a single number."""

        def cut(value: Any) -> Any:
            return value[index] if np.shape(value) == (size,) else value

        parameters = {name: cut(value) for name, value in self.parameters.items()}
        frame = Frame(cut(self.frame.turn), cut(self.frame.sense)) if np.ndim(self.frame.turn) else self.frame
        return FormInTime(self.form, self.time, parameters, frame, cut(self.start), cut(self.end))
