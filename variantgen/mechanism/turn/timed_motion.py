"""The motion of a batch of variants in an interval of time, by their laws of time.

The interval of each variant is divided into pieces, in each of which the motion is solved at Chebyshev's points. There
are so many that polynomials through these resolve the motion, and that the solved velocities are the derivatives of
the positions, the accelerations those of the velocities: so all of it is confirmed by positions alone, and a mechanism
that goes over to another branch, or cannot be assembled somewhere, has no motion in the interval.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.mechanism.solving.solve import solve
from variantgen.mechanism.solving.structure import Plan, analyse
from variantgen.mechanism.turn.polynomials import DEGREE, NODES, SLOPE_AT_NODES, TO_COEFFICIENTS

_COUNTS = (8, 32, 128, 512)  # pieces of the interval
_MORE, _OF_RADIAN = (2048, 8192), 4  # of a wheel that makes many turns: so many at most of each radian
_LEFT_OUT = 1e-10  # of the largest: the last two coefficients of a polynomial that leaves nothing out
_AGREES = 1e-6  # of the largest: a derivative that is the same, but for rounding
_ALWAYS = 0.9  # of the instants
_NOTHING = 1e-12  # m, m/s, rad/s and so on: rounding about zero
_AT = DEGREE + 1
_ROWS = 40_000  # instants that are solved at once


class Pieces(Struct, frozen=True):
    """``count`` pieces of the intervals of some ``variants``, shape (n,), with their motion.

    ``middle`` (s), shape (n, count), and ``half`` (s), shape (n,), are those of the pieces. The motion has a row for
    each of Chebyshev's points of each piece of each variant, shape (n * count * points,).
    """

    variants: NDArray[np.intp]
    count: int
    middle: Field
    half: Field
    motion: Motion

    @property
    def rows(self) -> NDArray[np.intp]:
        """The variant of each row of the motion, shape (n * count * points,)."""
        return np.repeat(self.variants, self.count * _AT)

    def coefficients(self, values: Field) -> Field:
        """Coefficients of the polynomials through values of the rows, shape (n, count, points)."""
        found: Field = values.reshape(len(self.variants), self.count, _AT) @ TO_COEFFICIENTS.T
        return found

    def take(self, chosen: NDArray[np.bool_]) -> Pieces:
        """Those of some of its variants, a mask of shape (n,)."""
        rows = np.repeat(chosen, self.count * _AT)
        motion = self.motion.take(np.flatnonzero(rows))
        return Pieces(self.variants[chosen], self.count, self.middle[chosen], self.half[chosen], motion)


class TimedMotion:
    """The motion of N variants, ``size`` of them, in their intervals of time, with velocities, or accelerations too.

    ``start`` and ``end`` (s) have the shape (N,). ``complete`` tells which variants can make the motion; ``parts`` has
    each of these once. Raises ValueError for a scene without laws for an interval.
    """

    def __init__(self, motion: Motion, order: int) -> None:
        course = motion.scene.course
        if course is None:
            raise ValueError("the scene states no interval of time")
        self.size, self.order, self._course = motion.size, max(1, order), course
        self._plan: Plan = analyse(motion.scene)
        self.start, self.end = (
            np.array(np.broadcast_to(np.asarray(end, dtype=float), (motion.size,)))
            for end in (course.start, course.end)
        )
        self.parts: list[Pieces] = []
        self.complete = np.zeros(motion.size, dtype=bool)
        self._turning = np.zeros(motion.size)  # rad, by its fastest body
        left = np.flatnonzero(motion.solved & (self.end > self.start))
        for count in (*_COUNTS, *_MORE):
            left = left[(count <= _COUNTS[-1]) | (_OF_RADIAN * self._turning[left] >= count)]
            chunks = np.array_split(left, max(1, -(-left.size * count * _AT // _ROWS)))
            left = np.concatenate([self._divide(chunk, count) for chunk in chunks])

    def _divide(self, variants: NDArray[np.intp], count: int) -> NDArray[np.intp]:
        """Keep the motion of those of the variants that so many pieces resolve; those that need more."""
        if not variants.size:
            return variants
        pieces = self._pieces(variants, count)
        fastest = [np.abs(rates).reshape(len(variants), -1).max(axis=1) for rates in pieces.motion.omega.values()]
        self._turning[variants] = np.max(fastest, axis=0, initial=0.0) * self.duration[variants]
        moves = np.all(pieces.motion.solved.reshape(len(variants), -1), axis=1)
        good = moves & _is_resolved(pieces, self.order)
        self.complete[variants[good]] = True
        if np.any(good):
            self.parts.append(pieces.take(good))
        rest: NDArray[np.intp] = variants[moves & ~good]
        return rest

    @property
    def duration(self) -> Field:
        """The lengths of the intervals (s), shape (N,)."""
        found: Field = self.end - self.start
        return found

    def at(self, variants: NDArray[np.intp], times: Field) -> Motion:
        """The motion of variants at instants (s), shape (M,) each."""
        with np.errstate(all="ignore"):
            return solve(self._course.at(variants, times), self.order, self._plan)

    def _pieces(self, variants: NDArray[np.intp], count: int) -> Pieces:
        half = 0.5 * self.duration[variants] / count
        middle = self.start[variants][:, None] + half[:, None] * (2 * np.arange(count) + 1)
        times = middle[:, :, None] + half[:, None, None] * NODES
        return Pieces(variants, count, middle, half, self.at(np.repeat(variants, count * _AT), times.ravel()))


def _is_resolved(pieces: Pieces, order: int) -> NDArray[np.bool_]:
    """Whether polynomials resolve the motion of each variant, and each order is the derivative of the one before."""
    motion = pieces.motion
    shape = (len(pieces.variants), pieces.count, _AT)
    found = np.ones(shape[0], dtype=bool)
    tables = [_stacked(motion.v, shape), _stacked(motion.omega, shape)]
    tables += [_stacked(motion.a, shape), _stacked(motion.epsilon, shape)] if order > 1 else []
    with np.errstate(all="ignore"):
        for table in tables:
            last = np.abs(table @ TO_COEFFICIENTS.T)[..., -2:]
            found &= _within(last, _LEFT_OUT, table)
        rate = SLOPE_AT_NODES.T / pieces.half[:, None, None]
        for before, after in [(motion.z, motion.v), *([(motion.v, motion.a)] if order > 1 else [])]:
            moving = {name: before[name] for name in after}
            found &= _is_derivative(_stacked(moving, shape) @ rate, _stacked(after, shape))
        if order > 1:
            turning = _stacked(motion.omega, shape) @ rate
            found &= _within(turning - (right := _stacked(motion.epsilon, shape)), _AGREES, right)
    return found


def _is_derivative(changes: ComplexField, vectors: ComplexField) -> NDArray[np.bool_]:
    """Whether vectors of points, shape (points, n, count, nodes), are how these change, shape (n,).

    The contact of a wheel, the place of a slotted body under a pin are named anew at every instant, and never change as
    the point of the body does that is there: they tell nothing, and one point at least has to.
    """
    largest = np.max(np.abs(vectors), axis=(0, 2, 3), initial=0.0)
    allowed = (_AGREES * largest + _NOTHING)[:, None, None]
    off = np.abs(changes - vectors) > allowed
    is_renamed = np.mean(off, axis=(2, 3)) > _ALWAYS
    moves = np.max(np.abs(vectors), axis=(2, 3)) > allowed[:, 0, 0]
    shown = np.any(moves & ~is_renamed, axis=0) | ~np.any(moves, axis=0)
    found: NDArray[np.bool_] = shown & ~np.any(off & ~is_renamed[..., None, None], axis=(0, 2, 3))
    return found


def _stacked(table: Mapping[str, Field] | Mapping[str, ComplexField], shape: tuple[int, ...]) -> ComplexField:
    """All arrays of a table, shape (things, n, count, points)."""
    rows = [np.asarray(values, dtype=complex).reshape(shape) for values in table.values()]
    return np.array(rows) if rows else np.zeros((0, *shape), dtype=complex)


def _within(gap: ComplexField | Field, share: float, values: ComplexField) -> NDArray[np.bool_]:
    """Whether nothing of a gap is more than a share of the largest value of the variant, shape (n,)."""
    largest = np.max(np.abs(values), axis=(0, 2, 3), initial=0.0)
    worst = np.max(np.abs(gap), axis=(0, 2, 3), initial=0.0)
    found: NDArray[np.bool_] = worst <= share * largest + _NOTHING
    return found


# The last one: several values of one are asked one after the other, and the motion takes most of the time.
_last: list[tuple[Motion, TimedMotion]] = []


def timed_motion(motion: Motion, order: int) -> TimedMotion:
    """The motion in the interval of time, with velocities (order 1 or less) or accelerations (2). Raises ValueError."""
    for known, timed in _last:
        if known is motion and timed.order >= order:
            return timed
    _last[:] = [(motion, TimedMotion(motion, order))]
    return _last[0][1]
