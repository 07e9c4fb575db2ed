"""Numbers of a full turn of the crank: extremes and where they lie, to and fro ways, mean values; shape (N,) each.

An extreme is looked for on a regular grid of the crank's angle; about each that may be the largest, the quantity is
interpolated by a polynomial in Chebyshev's points, in a part of a step of the grid about the top of the parabola
through three values. Where the polynomial does not resolve it (a kink, a peak at the end of that part) more follow,
over the whole step and each in a fifth of the one before. What has no value (a crank that cannot make the turn, a
quantity that does not change, a point that does not move to and fro) is infinite.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.mechanism.motion import Field, Motion
from variantgen.mechanism.turn.crank_turn import FULL_TURN, GRID, CrankTurn
from variantgen.mechanism.turn.polynomials import AT_FINE, FINE, NODES, TO_COEFFICIENTS, risen, value_at

Scalar = Callable[[Motion, NDArray[np.intp]], Field]  # of a motion (M,) with the variant of each of its rows

_STEP = FULL_TURN / GRID
_PART, _CLOSER = 0.25, 0.2  # of a step of the grid: about the parabola's top; each time again, where need be
_TIMES = 13  # until a kink is known to ten digits
_RESOLVED = 1e-12  # relative: the last two coefficients of a polynomial that leaves nothing out
_INSIDE = 0.95  # of the part: peaks farther out may lie beyond it
_NEAR = 0.05  # of the range: how far below the largest value of the grid another may lie and be it
_SAME = 1e-9  # relative: of two equally large values the first counts
_CONSTANT = 1e-9  # relative range of what does not change
_STOP = 1e-7  # of the largest speed: less is at rest
_ON_LINE = 1e-7  # of the way
_APART = 1e-7  # rad: between two places at which a point is at rest
_GAUSS, _WEIGHTS = np.polynomial.legendre.leggauss(20)
_PARTS = 8  # pieces of a turn, at least, that are integrated one by one


class Extreme(Struct, frozen=True):
    """The largest value of a quantity over a turn (SI), and the angle (rad, 0 to 2 pi) where it is first reached."""

    value: Field
    angle: Field


def largest(turn: CrankTurn, quantity: Scalar) -> Extreme:
    """The largest value over the turn; infinite, as its angle, where the quantity does not change."""
    variants = np.repeat(np.arange(turn.size), GRID)
    table = quantity(turn.grid, variants).reshape(turn.size, GRID)
    top = np.max(table, axis=1, keepdims=True)
    spread = top - np.min(table, axis=1, keepdims=True)
    peaks = (
        (table >= np.roll(table, 1, axis=1)) & (table >= np.roll(table, -1, axis=1)) & (table >= top - _NEAR * spread)
    )
    constant = spread[:, 0] <= _CONSTANT * np.max(np.abs(table), axis=1)
    peaks &= (turn.complete & ~constant)[:, None]
    own, place = np.nonzero(peaks)
    value = np.where(turn.complete & ~constant, top[:, 0], np.inf)
    angle = np.full(turn.size, np.inf)
    if own.size:
        at, height = _refined(turn, quantity, own, place, table)
        best = np.full(turn.size, -np.inf)
        np.maximum.at(best, own, height)
        first = height >= best[own] - _SAME * np.abs(best[own])
        np.minimum.at(angle, own[first], at[first])
        value = np.where(np.isfinite(best), best, value)
    return Extreme(value, angle)


def smallest(turn: CrankTurn, quantity: Scalar) -> Extreme:
    """The smallest value over the turn."""
    found = largest(turn, lambda motion, variants: -quantity(motion, variants))
    return Extreme(np.where(turn.complete, -found.value, np.inf) + 0.0, found.angle)


def _refined(
    turn: CrankTurn, quantity: Scalar, own: NDArray[np.intp], place: NDArray[np.intp], table: Field
) -> tuple[Field, Field]:
    """Angles (0 to 2 pi) and heights of the peaks near places of the grid, one of the variant ``own`` each.

    ``table`` has the values on the grid, shape (N, GRID).
    """
    before, top, after = (table[own, (place + k) % GRID] for k in (-1, 0, 1))
    bend = before - 2 * top + after
    aside = 0.5 * (before - after) / np.where(bend < 0, bend, -np.inf)
    centre: Field = (place + aside) * _STEP
    centre, height, resolved = _polynomial(turn, quantity, own, centre, _PART * _STEP)
    centre[~resolved] = place[~resolved] * _STEP
    width = _STEP
    for _ in range(_TIMES):
        few = np.flatnonzero(~resolved)
        if not few.size:
            break
        centre[few], height[few], resolved[few] = _polynomial(turn, quantity, own[few], centre[few], width)
        width *= _CLOSER
    angle = np.mod(centre, FULL_TURN)
    return np.where(FULL_TURN - angle < _SAME, 0.0, angle), height


def _polynomial(
    turn: CrankTurn, quantity: Scalar, own: NDArray[np.intp], centre: Field, width: float
) -> tuple[Field, Field, NDArray[np.bool_]]:
    """Angle and height of the peak so far about a centre, and whether the polynomial resolves it; shape (M,) each."""
    angles = centre[:, None] + width * NODES
    variants = np.repeat(own, len(NODES))
    values = quantity(turn.at(variants, angles.ravel()), variants).reshape(angles.shape)
    coefficients = values @ TO_COEFFICIENTS.T
    peak = risen(coefficients, FINE[np.argmax(coefficients @ AT_FINE.T, axis=1)])
    rest = np.max(np.abs(coefficients[:, -2:]), axis=1)
    resolved = (rest <= _RESOLVED * np.max(np.abs(values), axis=1)) & (np.abs(peak) <= _INSIDE)
    return centre + width * peak, value_at(coefficients, peak), resolved


def mean(turn: CrankTurn, quantity: Scalar) -> Field:
    """The mean over a turn, shape (N,), of what is never negative and is smooth but where it is zero: a speed."""
    own, stops = _stops(turn, quantity)
    rows, starts, ends = _pieces(turn, own, stops)
    angles = 0.5 * (starts + ends)[:, None] + 0.5 * (ends - starts)[:, None] * _GAUSS
    every = np.repeat(rows, len(_GAUSS))
    values = quantity(turn.at(every, angles.ravel()), every).reshape(angles.shape)
    total = np.zeros(turn.size)
    np.add.at(total, rows, 0.5 * (ends - starts) * (values @ _WEIGHTS))
    return np.where(turn.complete, total / FULL_TURN, np.inf)


def _stops(turn: CrankTurn, quantity: Scalar) -> tuple[NDArray[np.intp], Field]:
    """Where a speed is zero: variant and angle of each such place."""
    variants = np.repeat(np.arange(turn.size), GRID)
    table = quantity(turn.grid, variants).reshape(turn.size, GRID)
    square = table**2
    low = (square <= np.roll(square, 1, axis=1)) & (square <= np.roll(square, -1, axis=1)) & turn.complete[:, None]
    own, place = np.nonzero(low)
    stops = np.empty(0)
    if own.size:
        stops, height = _refined(turn, lambda motion, rows: -(quantity(motion, rows) ** 2), own, place, -square)
        still = -height <= (_STOP * np.max(table, axis=1)[own]) ** 2
        own, stops = own[still], stops[still]
    return own, stops


def _pieces(turn: CrankTurn, own: NDArray[np.intp], stops: Field) -> tuple[NDArray[np.intp], Field, Field]:
    """The turn of each variant in pieces between its stops, short enough: variant, start, end."""
    rows: list[int] = []
    starts: list[float] = []
    ends: list[float] = []
    for variant in range(turn.size):
        cuts = np.unique(np.concatenate([np.arange(_PARTS + 1) * (FULL_TURN / _PARTS), stops[own == variant]]))
        rows += [variant] * (len(cuts) - 1)
        starts += cuts[:-1].tolist()
        ends += cuts[1:].tolist()
    return np.array(rows, dtype=np.intp), np.array(starts), np.array(ends)


def straight_way(turn: CrankTurn, point: str) -> tuple[Scalar, NDArray[np.bool_]]:
    """The coordinate (m) of a point along its straight line, and which variants have it on one, shape (N,)."""
    z = turn.grid.z[point].reshape(turn.size, GRID)
    start = z[:, 0]
    far = z[np.arange(turn.size), np.argmax(np.abs(z - start[:, None]), axis=1)] - start
    length = np.abs(far)
    ray = np.where(length > 0, far, 1.0) / np.where(length > 0, length, 1.0)
    aside = np.max(np.abs(np.imag((z - start[:, None]) * np.conj(ray[:, None]))), axis=1)

    def along(motion: Motion, variants: NDArray[np.intp]) -> Field:
        found: Field = np.real((motion.z[point] - start[variants]) * np.conj(ray[variants]))
        return found

    return along, aside <= _ON_LINE * length


def rotation(turn: CrankTurn, body: str) -> tuple[Scalar, NDArray[np.bool_]]:
    """The angle (rad) of a body about the middle of its swing, and which variants swing, not round, shape (N,)."""
    members = turn.grid.scene.bodies[body]
    pole = members[0]
    tip = max(members[1:], key=lambda name: float(np.min(np.abs(turn.grid.z[name] - turn.grid.z[pole]))), default=pole)
    rays = (turn.grid.z[tip] - turn.grid.z[pole]).reshape(turn.size, GRID)
    angles = np.unwrap(np.angle(rays), axis=1)
    middle = 0.5 * (np.max(angles, axis=1) + np.min(angles, axis=1))
    closing = angles[:, 0] - angles[:, -1]
    swings = (np.abs(closing) < np.pi) & (np.ptp(angles, axis=1) < 0.95 * FULL_TURN)

    def turned(motion: Motion, variants: NDArray[np.intp]) -> Field:
        found: Field = np.angle((motion.z[tip] - motion.z[pole]) * np.exp(-1j * middle[variants]))
        return found

    return turned, swings


def to_and_fro(turn: CrankTurn, target: str) -> tuple[Extreme, Extreme, NDArray[np.bool_]]:
    """Both limit positions of a point on a line or of a body that swings; which variants have them, shape (N,)."""
    is_body = target in turn.grid.scene.bodies
    with np.errstate(all="ignore"):
        way, has = (rotation if is_body else straight_way)(turn, target)
        high, low = largest(turn, way), smallest(turn, way)
    return high, low, has & turn.complete & np.isfinite(high.angle) & np.isfinite(low.angle)


def travel(turn: CrankTurn, target: str) -> Field:
    """The way between the limit positions: a stroke (m), the angle of a swing (rad), shape (N,)."""
    high, low, has = to_and_fro(turn, target)
    with np.errstate(invalid="ignore"):
        found = np.where(has, high.value - low.value, np.inf)
    if target in turn.grid.z and not np.all(has):
        curved, ends = _ends_of_arc(turn, target, ~has)
        first, last = (turn.at(curved, angles).z[target] for angles in ends)
        found[curved] = np.abs(last - first)
    return found


def _ends_of_arc(
    turn: CrankTurn, point: str, wanted: NDArray[np.bool_]
) -> tuple[NDArray[np.intp], tuple[Field, Field]]:
    """The variants of the wanted ones, shape (N,), whose point is at rest twice in a turn, and both angles there.

    These are the ends of a curve on which it goes to and fro, as the pin of a rocker does on its arc.
    """
    own, stops = _stops(turn, lambda motion, _: np.abs(motion.v[point]))
    ends = {variant: np.sort(stops[own == variant]) for variant in np.flatnonzero(wanted).tolist()}
    ends = {variant: angles[np.diff(angles, prepend=-1.0) > _APART] for variant, angles in ends.items()}
    curved = [variant for variant, angles in ends.items() if turn.complete[variant] and len(angles) == 2]
    pairs = np.array([ends[variant] for variant in curved]).reshape(-1, 2)
    return np.array(curved, dtype=np.intp), (pairs[:, 0], pairs[:, 1])


def time_ratio(turn: CrankTurn, target: str) -> Field:
    """The longer of the times there and back over the shorter one, shape (N,)."""
    high, low, has = to_and_fro(turn, target)
    there = np.where(has, np.mod(np.where(has, high.angle - low.angle, 0.0), FULL_TURN), 0.0)
    if target in turn.grid.z and not np.all(has):
        curved, (first, last) = _ends_of_arc(turn, target, ~has)
        there[curved] = last - first
    back = FULL_TURN - there
    return np.where(there > 0, np.maximum(there, back) / np.where(there > 0, np.minimum(there, back), 1.0), np.inf)
