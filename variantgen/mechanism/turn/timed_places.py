"""When a place is reached whose velocity is a function of it, many variants at once: ``t = integral of ds / v(s)``.

The way is written as ``s = s_0 + d p(u)`` with u from 0 to 1, where p is u, or goes like a square at an end at which
the motion is at rest, so that ``d p' / v`` is smooth. Polynomials through its values in Chebyshev's points of pieces of
the way are integrated; what they do not resolve is followed by an integrator, a variant at a time.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

Numbers: TypeAlias = NDArray[np.float64]
Chosen: TypeAlias = NDArray[np.intp]
# The velocities and the accelerations of variants at places (SI), shape (M,) each.
Rates: TypeAlias = Callable[[Chosen, Numbers], tuple[Numbers, Numbers]]

_PRECISE, _NOTHING = 1e-12, 1e-15  # relative and absolute error of a step
_FAR = 1e3  # times the places of the interval: what goes so far goes away
_SHARES = (0.0, 0.137, 0.381, 0.618, 0.871, 1.0)  # of the way: with one acceleration there it is the same all along
_SAME = 1e-14  # relative
_STEPS = 4  # of that time, at least
_LONGEST = 1e3  # times the interval through the velocities of its ends: what takes longer never comes
_AT_REST = 1e-12  # of the largest velocity
_COUNTS = (2, 8, 32)  # pieces of the way
_POINTS = 16  # of a piece
# Of the largest: the last two coefficients of a polynomial that leaves nothing out; where a motion that comes from rest
# or to it has lost digits of a small velocity.
_LEFT_OUT, _OF_RESTING = 1e-11, 1e-10
_NODES: Numbers = np.asarray(np.cos(np.pi * (np.arange(_POINTS) + 0.5) / _POINTS), dtype=np.float64)
_TO_COEFFICIENTS: Numbers = np.asarray(np.linalg.inv(chebyshev.chebvander(_NODES, _POINTS - 1)), dtype=np.float64)
_AREA: Numbers = np.asarray(chebyshev.chebint(np.eye(_POINTS), lbnd=-1, axis=1), dtype=np.float64)  # from -1 on
_ROUNDS, _FOUND = 30, 1e-14  # of Newton's method, and the last step


class _Table(NamedTuple):
    """The time over ``pieces`` pieces of the way of some variants.

    ``times`` (s), shape (n, pieces + 1), are those of the ends of the pieces; ``slope``, shape (n, pieces, points), and
    ``area``, with a point more, the coefficients of the change of time in a piece and of the time since its beginning.
    """

    pieces: int
    times: Numbers
    slope: Numbers
    area: Numbers


class TimedPlaces:
    """The place by the time of N variants from ``first`` to ``last`` (SI), shape (N,).

    ``end`` (s), shape (N,), is the instant of the last place, infinite where it is not reached.
    """

    def __init__(self, rates: Rates, first: Numbers, last: Numbers) -> None:
        self._rates, self._first, self._last = rates, first, last
        every = np.arange(first.size)
        places = np.array([first + share * (last - first) for share in _SHARES])
        with np.errstate(all="ignore"):  # where it never comes it may have no velocity
            stated = self._rates(np.tile(every, len(_SHARES)), places.ravel())
        velocities, accelerations = (rate.reshape(places.shape) for rate in stated)
        self._velocity, self._acceleration = velocities[0], accelerations[0]
        uniform = np.ptp(accelerations, axis=0) <= _SAME * np.max(np.abs(accelerations), axis=0)
        with np.errstate(all="ignore"):  # by the mean of both velocities
            self.end = np.where(uniform, 2.0 * (last - first) / (velocities[0] + velocities[-1]), np.inf)
            still = ~(np.abs(velocities[[0, -1]]) > _AT_REST * np.nanmax(np.abs(velocities), axis=0, initial=0.0))
        self._from_rest, self._to_rest = still
        self._tables: list[_Table] = []
        self._table, self._row = np.full(first.size, -1), np.zeros(first.size, dtype=np.intp)
        self._followed: dict[int, Callable[[Numbers], Numbers]] = {}
        left = np.flatnonzero(~uniform)
        for count in _COUNTS:
            left = self._integrate(left, count) if left.size else left
        for variant in left.tolist():
            self.end[variant] = self._follow(variant)
        self.end = np.where(self.end > 0, self.end, np.inf)

    def _shares(self, variants: Chosen, u: Numbers) -> tuple[Numbers, Numbers]:
        """``p(u)`` and ``p'(u)`` of variants, both of shape (M,)."""
        begins, ends = self._from_rest[variants], self._to_rest[variants]
        kinds = [begins & ends, begins, ends]
        way = np.select(kinds, [0.5 - 0.5 * np.cos(np.pi * u), u * u, 1.0 - (1.0 - u) ** 2], u)
        rate = np.select(kinds, [0.5 * np.pi * np.sin(np.pi * u), 2.0 * u, 2.0 * (1.0 - u)], np.ones_like(u))
        return way, rate

    def _integrate(self, variants: Chosen, count: int) -> Chosen:
        """Enter the times of those of the variants that so many pieces resolve; those that need something else."""
        u = (np.arange(count)[:, None] + 0.5 * (1.0 + _NODES)).ravel() / count
        rows, at = np.repeat(variants, u.size), np.tile(u, variants.size)
        share, rate = self._shares(rows, at)
        distance = (self._last - self._first)[rows]
        with np.errstate(all="ignore"):
            velocity = self._rates(rows, self._first[rows] + distance * share)[0]
            slopes = (distance * rate / velocity).reshape(variants.size, count, _POINTS) * (0.5 / count)
            moves = np.all(np.isfinite(slopes) & (slopes > 0), axis=(1, 2))
            slope = slopes @ _TO_COEFFICIENTS.T
            last = np.max(np.abs(slope[..., -2:]), axis=(1, 2))
            rests = (self._from_rest | self._to_rest)[variants]
            good = moves & (last <= np.where(rests, _OF_RESTING, _LEFT_OUT) * np.max(np.abs(slope), axis=(1, 2)))
            # What comes to rest on its way to the last place, or has no velocity further on, goes no further.
            stops = ~moves & (self._velocity[variants] * (self._last - self._first)[variants] > 0)
        area = slope[good] @ _AREA
        times = np.cumsum(np.sum(area, axis=2), axis=1)
        own = variants[good]
        self._table[own], self._row[own] = len(self._tables), np.arange(own.size)
        self._tables.append(_Table(count, np.insert(times, 0, 0.0, axis=1), slope[good], area))
        self.end[own] = times[:, -1]
        rest: Chosen = variants[~good & ~stops]
        return rest

    def _follow(self, variant: int) -> float:
        """The instant at which a variant is at the last place, by an integrator."""
        from scipy.integrate import solve_ivp

        own, velocity = np.array([variant]), float(self._velocity[variant])
        first, last = float(self._first[variant]), float(self._last[variant])

        def slope(_: float, state: Numbers) -> list[float]:
            return [state[1], float(self._rates(own, state[:1])[1][0])]

        def arrived(_: float, state: Numbers) -> float:
            return float(state[0]) - last

        def far(_: float, state: Numbers) -> float:
            return _FAR * (abs(first) + abs(last)) - abs(float(state[0]))

        arrived.terminal = far.terminal = True  # type: ignore[attr-defined]
        fastest = abs(velocity) + abs(float(self._rates(own, np.array([last]))[0][0]))
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
        self._followed[variant] = lambda times: np.asarray(found.sol(times)[0])
        return float(found.t_events[0][0]) if found.t_events[0].size else float("inf")

    def places(self, variants: Chosen, times: Numbers) -> Numbers:
        """The places (SI) of variants at instants (s), shape (M,) each."""
        rate = self._velocity[variants] + 0.5 * self._acceleration[variants] * times
        found: Numbers = self._first[variants] + rate * times
        for number, table in enumerate(self._tables):
            own = np.flatnonzero(self._table[variants] == number)
            if own.size:
                found[own] = self._by_table(table, variants[own], times[own])
        for variant in np.unique(variants).tolist() if self._followed else ():
            if variant in self._followed:
                own = np.flatnonzero(variants == variant)
                found[own] = self._followed[variant](times[own])
        return found

    def _by_table(self, table: _Table, variants: Chosen, times: Numbers) -> Numbers:
        """The places at which the time has its values: Newton's method on the piece of each."""
        row = self._row[variants]
        ends = table.times[row]
        piece = np.sum(times[:, None] >= ends[:, 1:-1], axis=1)
        one = np.arange(row.size)
        begin, end = ends[one, piece], ends[one, piece + 1]
        slope, area = table.slope[row, piece], table.area[row, piece]
        x = np.clip(2.0 * (times - begin) / (end - begin) - 1.0, -1.0, 1.0)
        left = one
        for _ in range(_ROUNDS):
            powers = chebyshev.chebvander(x[left], _POINTS)
            gap = np.sum(powers * area[left], axis=1) - (times - begin)[left]
            step = gap / np.sum(powers[:, :-1] * slope[left], axis=1)
            before = x[left]
            x[left] = np.clip(before - step, -1.0, 1.0)
            left = left[np.abs(x[left] - before) > _FOUND]
            if not left.size:
                break
        share, _ = self._shares(variants, (piece + 0.5 * (1.0 + x)) / table.pieces)
        found: Numbers = self._first[variants] + (self._last - self._first)[variants] * share
        return found
