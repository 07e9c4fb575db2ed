"""The motion of a form by its laws: the scene at any instant of an interval."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from functools import cached_property
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.mechanism.arithmetic import Real
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene

if TYPE_CHECKING:
    from variantgen.mechanism.turn.timed_places import TimedPlaces


class Interval(Struct, frozen=True):
    """An interval as a form states it: the parameter that is the instant, or with ``is_of_place`` the place, and both
    ends.
    """

    time: str
    start: FamilyExpression
    end: FamilyExpression
    is_of_place: bool = False


class FoundInstant(Struct, frozen=True):
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


class FormInTime(Struct, frozen=True):
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

    @property
    def is_by_place(self) -> bool:
        """The interval is one of time."""
        return False

    def at(self, variants: NDArray[np.intp], times: NDArray[np.float64]) -> Scene:
        """The scenes of variants at instants (s), shape (M,) each, as one batch."""
        return _moved(self, self.time, variants, times)

    @property
    def found(self) -> str:
        """The name of the instant, if it is found and not given."""
        return self.time if self.form.found_instant else ""

    def take(self, index: NDArray[Any] | int, size: int) -> FormInTime:
        """The variants chosen by indices, shape (K,), a mask, shape (N,), or a single number."""
        parameters, frame, start, end = _cut(self, (self.start, self.end), index, size)
        return FormInTime(self.form, self.time, parameters, frame, start, end)


class FormByPlace(Struct, frozen=True, dict=True):
    """The motion of variants of a form while a parameter, the ``place``, goes from ``first`` to ``last`` (SI).

    Its velocity is a function of it; instants count from the beginning of the way. The rest is as in
    :class:`FormInTime`.
    """

    form: MovingForm
    place: str
    parameters: Mapping[str, Real]
    frame: Frame
    first: Real
    last: Real

    @property
    def is_by_place(self) -> bool:
        """The interval is stated by its places."""
        return True

    @property
    def found(self) -> str:
        """The place is given, no instant is found."""
        return ""

    @property
    def start(self) -> Real:
        """The beginning of the way (s)."""
        return 0.0

    @property
    def end(self) -> Real:
        """The instant (s) at which the last place is reached, shape (N,); infinite where it never is."""
        return self._ways.end

    @cached_property
    def _ways(self) -> TimedPlaces:
        from variantgen.mechanism.turn.timed_places import TimedPlaces

        size = max(np.size(value) for value in (*self.parameters.values(), self.first, self.last))
        first, last = (
            np.array(np.broadcast_to(np.asarray(end, dtype=float), (size,))) for end in (self.first, self.last)
        )

        def rates(variants: NDArray[np.intp], places: NDArray[np.float64]) -> tuple[Any, Any]:
            data = {name: value[variants] if np.ndim(value) else value for name, value in self.parameters.items()}
            velocity, acceleration = self.rates(data, places)
            return np.broadcast_to(velocity, places.shape), np.broadcast_to(acceleration, places.shape)

        return TimedPlaces(rates, first, last)

    def at(self, variants: NDArray[np.intp], times: NDArray[np.float64]) -> Scene:
        """The scenes of variants at instants (s), shape (M,) each, as one batch."""
        return _moved(self, self.place, variants, self._ways.places(variants, times))

    def rates(self, parameters: Mapping[str, Real], place: Real) -> tuple[Real, Real]:
        """The velocity and the acceleration of the place at it, in SI."""
        found = self.form.values({**parameters, self.place: place})
        return found[f"{self.place}_dot"], found[f"{self.place}_ddot"]

    def take(self, index: NDArray[Any] | int, size: int) -> FormByPlace:
        """The variants chosen by indices, shape (K,), a mask, shape (N,), or a single number."""
        parameters, frame, first, last = _cut(self, (self.first, self.last), index, size)
        return FormByPlace(self.form, self.place, parameters, frame, first, last)


def _moved(
    course: FormInTime | FormByPlace, name: str, variants: NDArray[np.intp], values: NDArray[np.float64]
) -> Scene:
    """The scenes of variants with values of the parameter that moves, shape (M,) each."""

    def own(value: Real) -> Any:
        return value[variants] if np.ndim(value) else value

    data = {given: own(value) for given, value in course.parameters.items()} | {name: values}
    frame = course.frame
    frame = Frame(own(frame.turn), own(frame.sense)) if np.ndim(frame.turn) else frame
    return course.form.scene(course.form.values(data), frame)


def _cut(
    course: FormInTime | FormByPlace, ends: tuple[Real, Real], index: NDArray[Any] | int, size: int
) -> tuple[dict[str, Real], Frame, Real, Real]:
    """The parameters, the pose and both ends of some of the variants."""

    def cut(value: Any) -> Any:
        return value[index] if np.shape(value) == (size,) else value

    frame = course.frame
    frame = Frame(cut(frame.turn), cut(frame.sense)) if np.ndim(frame.turn) else frame
    return {name: cut(value) for name, value in course.parameters.items()}, frame, cut(ends[0]), cut(ends[1])
