"""Numbers of an interval of time: extremes and their instants, instants of rest, ways, means; shape (N,) each.

What has no value (a motion that cannot be made, an instant that does not come) is infinite.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.mechanism.turn.polynomials import AT_FINE, FINE, risen, value_at
from variantgen.mechanism.turn.timed_motion import Pieces, TimedMotion

Scalar = Callable[[Motion, NDArray[np.intp]], Field]  # of a motion (M,) with the variant of each of its rows

_SAME = 1e-9  # relative: of two equally large values the first counts
_CONSTANT = 1e-9  # relative range of what does not change
_ZERO = 1e-6  # of the largest value: less is zero
_ROUNDING = 1e-12  # of the way there and back: less is no change
_LATER = 1e-6  # of the interval: so long after its beginning an instant is another one
_LEFT_OUT = 1e-10  # of the largest value: the last two coefficients of what a polynomial resolves
_NEAR = 1e-5  # of the interval: about a zero, within which the quantity is a straight line
_GAUSS, _WEIGHTS = np.polynomial.legendre.leggauss(20)


class Top(Struct, frozen=True):
    """The largest value of a quantity in the interval (SI), and the instant (s) at which it is first reached."""

    value: Field
    time: Field


def largest(timed: TimedMotion, quantity: Scalar, is_magnitude: bool = False) -> Top:
    """The largest value; its instant is infinite where the quantity does not change.

    A magnitude has kinks where it is zero; its square, which has none, is looked at.
    """
    value, time = np.full((2, timed.size), np.inf)
    for pieces, table in _tables(timed, quantity):
        tops = _tops(pieces, table**2 if is_magnitude else table)
        best = np.full(timed.size, -np.inf)
        np.maximum.at(best, tops.own, tops.height)
        first = tops.height >= best[tops.own] - _SAME * np.abs(best[tops.own])
        own = pieces.variants
        np.minimum.at(time, tops.own[first], tops.time[first])
        time[own[_is_constant(pieces, table)]] = np.inf
        value[own] = np.sqrt(np.maximum(best[own], 0.0)) if is_magnitude else best[own]
    return Top(value, time)


def smallest(timed: TimedMotion, quantity: Scalar, is_magnitude: bool = False) -> Top:
    """The smallest value, that of a magnitude at least zero."""

    def turned(motion: Motion, variants: NDArray[np.intp]) -> Field:
        found: Field = -(quantity(motion, variants) ** (2 if is_magnitude else 1))
        return found

    found = largest(timed, turned)
    least = np.where(timed.complete, -found.value, np.inf)
    if is_magnitude:
        most = largest(timed, quantity, True).value
        least = np.sqrt(np.maximum(least, 0.0))
        least = np.where(least <= _ZERO * most, 0.0, least)
    return Top(least + 0.0, found.time)


def zeros(timed: TimedMotion, quantity: Scalar) -> tuple[NDArray[np.intp], Field]:
    """Where a quantity is zero: the variants and the instants (s) of all such places, shape (M,) each."""
    rows: list[NDArray[np.intp]] = []
    times: list[Field] = []
    for pieces, table in _tables(timed, quantity):
        most = np.zeros(timed.size)
        most[pieces.variants] = np.max(np.abs(table), axis=(1, 2))
        tops = _tops(pieces, -(table**2))
        near = np.sqrt(np.maximum(-tops.height, 0.0)) <= 1e-3 * most[tops.own]
        if not np.any(near):
            continue
        own, time = tops.own[near], _on_line(timed, quantity, tops.own[near], tops.time[near])
        still = np.abs(quantity(timed.at(own, time), own)) <= _ZERO * most[own]
        rows.append(own[still])
        times.append(time[still])
    return (np.concatenate(rows), np.concatenate(times)) if rows else (np.empty(0, dtype=np.intp), np.empty(0))


def first_zero(timed: TimedMotion, quantity: Scalar) -> Field:
    """The first instant (s) after the beginning at which a quantity is zero, or infinity, shape (N,)."""
    own, times = zeros(timed, quantity)
    later = times > timed.start[own] + _LATER * timed.duration[own]
    found = np.full(timed.size, np.inf)
    np.minimum.at(found, own[later], times[later])
    return found


def first_return(timed: TimedMotion, point: str) -> Field:
    """The first instant (s) at which a point is again where it was at the beginning, shape (N,)."""
    begun = timed.at(np.arange(timed.size), timed.start).z[point]
    return first_zero(timed, lambda motion, variants: np.abs(motion.z[point] - begun[variants]))


def way(timed: TimedMotion, speed: Scalar) -> Field:
    """The integral of a magnitude over the interval: the way of a point (m), or of a rotation (rad), shape (N,).

    Where the polynomials of the pieces resolve the magnitude, they are integrated. It has a kink where it is zero, and
    bends sharply where it nearly is: such pieces are cut at the zeros, and integrated by Gauss's rule.
    """
    total = np.where(timed.complete, 0.0, np.inf)
    own, stops = zeros(timed, speed)
    for pieces, table in _tables(timed, speed):
        coefficients = pieces.coefficients(table)
        smooth = _is_smooth(coefficients, table) & ~_has_stop(pieces, own, stops)
        whole = np.where(smooth, _integral(coefficients), 0.0) * pieces.half[:, None]
        total[pieces.variants] = np.sum(whole, axis=1)
        variant, low, high = _cut(pieces, ~smooth, own, stops)
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        times = middle[:, None] + half[:, None] * _GAUSS
        rows = np.repeat(variant, _GAUSS.size)
        values = speed(timed.at(rows, times.ravel()), rows).reshape(times.shape) if rows.size else times
        np.add.at(total, variant, half * (values @ _WEIGHTS))
    return total


def _is_smooth(coefficients: Field, table: Field) -> NDArray[np.bool_]:
    """Which pieces are resolved by their polynomials, shape (n, count)."""
    most = np.max(np.abs(table), axis=(1, 2))
    found: NDArray[np.bool_] = np.max(np.abs(coefficients[..., -2:]), axis=-1) <= _LEFT_OUT * most[:, None]
    return found


def _has_stop(pieces: Pieces, own: NDArray[np.intp], stops: Field) -> NDArray[np.bool_]:
    """Which pieces have one of the ``stops`` of the variants ``own``, or end at one, shape (n, count)."""
    found = np.zeros(pieces.middle.shape, dtype=bool)
    for row, piece, _ in _stops_in(pieces, own, stops):
        found[row, piece] = True
    return found


def _stops_in(pieces: Pieces, own: NDArray[np.intp], stops: Field) -> Iterator[tuple[int, int, float]]:
    """Row, piece and instant of each of the stops, for each piece that it lies in."""
    rows = {variant: row for row, variant in enumerate(pieces.variants.tolist())}
    for variant, time in zip(own.tolist(), stops.tolist(), strict=True):
        if (row := rows.get(variant)) is not None:
            within = np.abs(pieces.middle[row] - time) <= pieces.half[row] * (1 + _LATER)
            for piece in np.flatnonzero(within).tolist():
                yield row, piece, time


def _cut(
    pieces: Pieces, chosen: NDArray[np.bool_], own: NDArray[np.intp], stops: Field
) -> tuple[NDArray[np.intp], Field, Field]:
    """The chosen pieces, shape (n, count), cut at the stops: the variants, beginnings and ends (s) of the parts."""
    cuts: dict[tuple[int, int], list[float]] = {(row, piece): [] for row, piece in np.argwhere(chosen).tolist()}
    for row, piece, time in _stops_in(pieces, own, stops):
        cuts[row, piece].append(time)
    variants, low, high = [], [], []
    for (row, piece), inner in cuts.items():
        first, last = (float(pieces.middle[row, piece] + side * pieces.half[row]) for side in (-1, 1))
        edges = [first, *(min(max(time, first), last) for time in sorted(inner)), last]
        variants += [int(pieces.variants[row])] * (len(edges) - 1)
        low += edges[:-1]
        high += edges[1:]
    return np.array(variants, dtype=np.intp), np.array(low, dtype=float), np.array(high, dtype=float)


def _integral(coefficients: Field) -> Field:
    """The integrals of polynomials from -1 to 1; those of odd degrees vanish."""
    even = np.arange(0, coefficients.shape[-1], 2)
    found: Field = coefficients[..., ::2] @ (2.0 / (1.0 - even**2))
    return found


def way_of(timed: TimedMotion, point: str) -> Field:
    """The length (m) of the way of a point, shape (N,)."""
    return way(timed, lambda motion, _: np.abs(motion.v[point]))


def duration(timed: TimedMotion, _: str) -> Field:
    """The length (s) of the interval, shape (N,)."""
    found: Field = np.where(timed.complete, timed.duration, np.inf)
    return found


def mean(timed: TimedMotion, speed: Scalar) -> Field:
    """The mean of a magnitude over the interval, shape (N,)."""
    return way(timed, speed) / np.where(timed.complete, timed.duration, 1.0)


def turned(timed: TimedMotion, body: str) -> Field:
    """The angle (rad) by which a body turns in the interval, counter-clockwise less clockwise, shape (N,)."""
    total = np.full(timed.size, np.inf)
    for pieces, table in _tables(timed, lambda motion, _: motion.omega[body]):
        angles = _integral(pieces.coefficients(table)) * pieces.half[:, None]
        whole, way = np.sum(angles, axis=1), np.sum(np.abs(angles), axis=1)
        total[pieces.variants] = np.where(np.abs(whole) <= _ROUNDING * way, 0.0, whole)
    return total


def change(timed: TimedMotion, vectors: Callable[[Motion], ComplexField]) -> ComplexField:
    """What a vector is at the end of the interval less what it is at its beginning, shape (N,)."""
    every = np.arange(timed.size)
    first, last = (vectors(timed.at(every, times)) for times in (timed.start, timed.end))
    found: ComplexField = np.where(timed.complete, last - first, np.inf)
    return found


def change_per_second(timed: TimedMotion, vectors: Callable[[Motion], ComplexField]) -> ComplexField:
    """The change of a vector through the length of the interval, shape (N,)."""
    found: ComplexField = change(timed, vectors) / np.where(timed.complete, timed.duration, 1.0)
    return found


class _Tops(Struct, frozen=True):
    """Local tops of a quantity, at ends of pieces too: of which variant, at which instant (s), how high."""

    own: NDArray[np.intp]
    time: Field
    height: Field


def _tables(timed: TimedMotion, quantity: Scalar) -> Iterator[tuple[Pieces, Field]]:
    """The values of a quantity in all pieces, shape (n, count, points), for the parts of a timed."""
    for pieces in timed.parts:
        if len(pieces.variants):
            values = np.asarray(quantity(pieces.motion, pieces.rows), dtype=float)
            yield pieces, values.reshape(len(pieces.variants), pieces.count, -1)


def _tops(pieces: Pieces, table: Field) -> _Tops:
    """The local tops by polynomials."""
    coefficients = pieces.coefficients(table)
    fine = coefficients @ AT_FINE.T
    before = np.concatenate([fine[..., :1], fine[..., :-1]], axis=-1)
    after = np.concatenate([fine[..., 1:], fine[..., -1:]], axis=-1)
    own, piece, place = np.nonzero((fine >= before) & (fine >= after))
    chosen = coefficients[own, piece]
    at = risen(chosen, FINE[place])
    times = pieces.middle[own, piece] + pieces.half[own] * at
    return _Tops(pieces.variants[own], times, value_at(chosen, at))


def _is_constant(pieces: Pieces, table: Field) -> NDArray[np.bool_]:
    """Which variants have the same value all along, shape (n,)."""
    spread = np.ptp(table, axis=(1, 2))
    found: NDArray[np.bool_] = spread <= _CONSTANT * np.max(np.abs(table), axis=(1, 2))
    return found


def _on_line(timed: TimedMotion, quantity: Scalar, own: NDArray[np.intp], times: Field) -> Field:
    """The instants at which a quantity that changes its sign near ``times`` is zero; others as they are."""
    step = _NEAR * timed.duration[own]
    low = np.maximum(times - step, timed.start[own])
    high = np.minimum(times + step, timed.end[own])
    first, last = (quantity(timed.at(own, ends), own) for ends in (low, high))
    crosses = first * last < 0
    share = first / np.where(crosses, first - last, 1.0)
    return np.where(crosses, low + share * (high - low), times)
