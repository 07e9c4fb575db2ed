"""Laws that no formula gives: the place and the velocity by their differential equation, worked out numerically."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.families.parameters.expressions import FamilyExpression
from variantgen.mechanism.arithmetic import Real

_PRECISE, _NOTHING = 1e-12, 1e-14  # relative and absolute error of a step
_FAR = 1e9  # of the unit: what grows beyond has no value


class InitialValue(Struct, frozen=True, eq=False):
    """``y' = f(x, y)`` or ``y'' = f(x, y, y')`` (``order`` 2) from ``start``: x, y and y' there.

    With ``is_by_place`` y itself is x, and y' at it is wanted. All in numbers of the law, of which ``scale`` is one in
    SI; ``variable`` is the name of x, ``own`` that of y.
    """

    rate: FamilyExpression
    start: tuple[FamilyExpression, ...]
    variable: str
    own: str
    order: int
    scale: float
    sign: int

    @property
    def is_by_place(self) -> bool:
        """Whether the place is given, not the time."""
        return self.variable == self.own

    @property
    def names(self) -> frozenset[str]:
        """What it depends on: the variable and the parameters in it."""
        used = self.rate.names.union(*(part.names for part in self.start))
        return (used - {self.own, f"{self.own}_dot"}) | {self.variable}

    def solved(self, values: Mapping[str, Real], part: int) -> NDArray[np.float64]:
        """The place (part 0) or the velocity (1) for values in SI, scalars or of shape (N,); NaN without one."""
        names = sorted(self.names - {self.variable})
        table = np.broadcast_arrays(*(np.asarray(values[name], dtype=float) for name in (self.variable, *names)))
        flat = np.stack([column.ravel() for column in table])
        unit = self.scale if self.is_by_place else 1.0
        found = np.full(flat.shape[1], np.nan)
        rows, own = np.unique(flat[1:].T, axis=0, return_inverse=True)
        for number, row in enumerate(rows):
            chosen = np.flatnonzero(own.ravel() == number)
            found[chosen] = self._row(tuple(zip(names, row.tolist(), strict=True)), flat[0, chosen] / unit, part)
        return found.reshape(table[0].shape) * self.scale

    def _row(self, data: tuple[tuple[str, float], ...], at: NDArray[np.float64], part: int) -> NDArray[np.float64]:
        start = float(self.start[0].value(dict(data)))
        found = np.full(at.shape, np.nan)
        for chosen in (np.isfinite(at) & (at >= start), np.isfinite(at) & (at < start)):
            if np.any(chosen):
                furthest = float(np.max(np.abs(at[chosen] - start)))
                end = _beyond(start, furthest if at[chosen][0] >= start else -furthest)
                state, last = _followed(self, data, end)
                reached = chosen & (np.abs(at - start) <= abs(last - start) * (1 + _PRECISE))
                table = state(np.where(reached, at, start))
                found[reached] = self._wanted(table, part)[reached]
        return found

    def _wanted(self, table: NDArray[np.float64], part: int) -> NDArray[np.float64]:
        if not self.is_by_place:
            row: NDArray[np.float64] = table[part]
            return row
        with np.errstate(invalid="ignore"):  # half the square of the velocity
            velocity: NDArray[np.float64] = self.sign * np.sqrt(2.0 * table[0])
        return velocity

    def slope(self, data: Mapping[str, float]) -> Callable[[float, NDArray[np.float64]], list[float]]:
        """The right side for an integrator, whose state has the shape (order,), by place (1,)."""
        own, velocity = self.own, f"{self.own}_dot"

        def by_time(x: float, state: NDArray[np.float64]) -> list[float]:
            now = {**data, self.variable: x, own: state[0], velocity: state[-1]}
            found = float(self.rate.value(now))
            return [found] if self.order == 1 else [state[1], found]

        def by_place(x: float, state: NDArray[np.float64]) -> list[float]:
            speed = self.sign * float(np.sqrt(max(2.0 * state[0], 0.0)))
            return [float(self.rate.value({**data, own: x, velocity: speed}))]

        return by_place if self.is_by_place else by_time

    def begun(self, data: Mapping[str, float]) -> list[float]:
        """What the integrator begins with."""
        numbers = [float(part.value(data)) for part in self.start[1:]]
        return [0.5 * numbers[0] ** 2] if self.is_by_place else numbers


def _beyond(start: float, way: float) -> float:
    """An end at least so far, one of few: what is asked next of a law is mostly found in what has been followed."""
    return start + math.copysign(2.0 ** math.ceil(math.log2(abs(way))), way) if way else start


@lru_cache(maxsize=1024)
def _followed(
    law: InitialValue, data: tuple[tuple[str, float], ...], end: float
) -> tuple[Callable[[NDArray[np.float64]], NDArray[np.float64]], float]:
    """The state by the variable from the start to the end, and how far it goes."""
    from scipy.integrate import solve_ivp

    known = dict(data)
    start, begun = float(law.start[0].value(known)), law.begun(known)
    if end == start:
        return (lambda at: np.repeat(np.array(begun)[:, None], at.size, axis=1)), end

    def far(_: float, state: Any) -> float:
        return _FAR - float(np.max(np.abs(state)))

    def still(_: float, state: Any) -> float:
        return float(state[0])

    far.terminal = still.terminal = True  # type: ignore[attr-defined]
    still.direction = -1  # type: ignore[attr-defined]
    events = [far, still] if law.is_by_place else [far]
    with np.errstate(all="ignore"):
        found = solve_ivp(
            law.slope(known),
            (start, end),
            begun,
            method="DOP853",
            rtol=_PRECISE,
            atol=_NOTHING,
            dense_output=True,
            events=events,
        )
    return found.sol, float(found.t[-1])


class SolvedLaw(FamilyExpression, frozen=True, eq=False):
    """The place (``part`` 0) or the velocity (1) of a law as an expression of a family."""

    law: InitialValue
    part: int

    @property
    def names(self) -> frozenset[str]:
        """The quantities that it uses."""
        return self.law.names

    @property
    def risky(self) -> bool:
        """It may end before the instant."""
        return True

    def value(self, values: Mapping[str, Real]) -> Real:
        """Its value; zero where it has none."""
        found = self.law.solved(values, self.part)
        return np.where(np.isfinite(found), found, 0.0)

    def defined(self, values: Mapping[str, Real]) -> Any:
        """Whether the law goes so far."""
        return np.isfinite(self.law.solved(values, self.part))

    def inlined(self, definitions: Mapping[str, FamilyExpression]) -> FamilyExpression:
        """Itself: it uses parameters alone."""
        return self
