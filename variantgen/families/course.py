"""The motion of a form by its laws: the scene at any instant of an interval."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.mechanism.arithmetic import Real
from variantgen.mechanism.rows import Frame
from variantgen.mechanism.scene import Scene

_PRECISE, _NOTHING = 1e-12, 1e-15  # relative and absolute error of a step
_FAR = 1e3  # times the places of the interval: what goes so far goes away
_SHARES = (0.0, 0.137, 0.381, 0.618, 0.871, 1.0)  # of the way: with one acceleration there it is the same all along
_SAME = 1e-14  # relative
_STEPS = 4  # of that time, at least
_LONGEST = 1e3  # times the interval through the velocities of its ends: what takes longer never comes


@dataclass(frozen=True)
class Interval:
    """An interval as a form states it: the parameter that is the instant, or with ``is_of_place`` the place, and both
    ends.
    """

    time: str
    start: FamilyExpression
    end: FamilyExpression
    is_of_place: bool = False


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


@dataclass(frozen=True)
class FormByPlace:
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
    def _ways(self) -> _Ways:
        return _Ways(self)

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


class _Ways:
    """The place by the time of each variant; ``end`` (s) is infinite where the last place is not reached."""

    def __init__(self, course: FormByPlace) -> None:
        sizes = [np.size(value) for value in (*course.parameters.values(), course.first, course.last)]
        self._size = max(sizes)
        self._course = course
        self._first, self._last = (np.broadcast_to(end, (self._size,)) for end in (course.first, course.last))
        places = [self._first + share * (self._last - self._first) for share in _SHARES]
        rates = [course.rates(course.parameters, place) for place in places]
        velocities, accelerations = (
            np.array([np.broadcast_to(np.asarray(rate[k], dtype=float), (self._size,)) for rate in rates])
            for k in (0, 1)
        )
        self._velocity, self._acceleration = velocities[0], accelerations[0]
        uniform = np.ptp(accelerations, axis=0) <= _SAME * np.max(np.abs(accelerations), axis=0)
        with np.errstate(all="ignore"):  # by the mean of both velocities
            end = np.where(uniform, 2.0 * (self._last - self._first) / (velocities[0] + velocities[-1]), np.inf)
        self._solved: dict[int, Any] = {}
        for variant in np.flatnonzero(~uniform).tolist():
            end[variant] = self._follow(variant, float(self._velocity[variant]))
        self.end = np.where(end > 0, end, np.inf)

    def _row(self, variant: int) -> dict[str, float]:
        parameters = self._course.parameters
        return {name: float(value[variant] if np.ndim(value) else value) for name, value in parameters.items()}

    def _follow(self, variant: int, velocity: float) -> float:
        """The instant at which a variant is at the last place."""
        from scipy.integrate import solve_ivp

        row, first, last = self._row(variant), float(self._first[variant]), float(self._last[variant])

        def slope(_: float, state: NDArray[np.float64]) -> list[float]:
            return [state[1], float(self._course.rates(row, state[0])[1])]

        def arrived(_: float, state: NDArray[np.float64]) -> float:
            return float(state[0]) - last

        def far(_: float, state: NDArray[np.float64]) -> float:
            return _FAR * (abs(first) + abs(last)) - abs(float(state[0]))

        arrived.terminal = far.terminal = True  # type: ignore[attr-defined]
        fastest = abs(velocity) + abs(float(self._course.rates(row, last)[0]))
        if fastest == 0:
            return float("inf")
        usual = abs(last - first) / fastest
        with np.errstate(all="ignore"):
            found = solve_ivp(
                slope,
                (0.0, _LONGEST * usual),
                [first, velocity],
                max_step=usual / _STEPS,  # both passages of a place where it turns back never lie within a step
                method="DOP853",
                rtol=_PRECISE,
                atol=_NOTHING,
                dense_output=True,
                events=(arrived, far),
            )
        self._solved[variant] = found.sol
        return float(found.t_events[0][0]) if found.t_events[0].size else float("inf")

    def places(self, variants: NDArray[np.intp], times: NDArray[np.float64]) -> NDArray[np.float64]:
        """The places (SI) of variants at instants (s), shape (M,) each."""
        rate = self._velocity[variants] + 0.5 * self._acceleration[variants] * times
        found: NDArray[np.float64] = self._first[variants] + rate * times
        for variant in np.unique(variants).tolist():
            if variant in self._solved:
                own = np.flatnonzero(variants == variant)
                found[own] = self._solved[variant](times[own])[0]
        return found
