"""Points that must be placed together: Newton's method from a stated picture, on the branch of that picture.

Groups of class III and higher have no construction by circles and lines. What the conditions leave in the picture, r,
is taken back to nothing, ``c(z(s)) = (1 - s) r`` with s from 0 to 1, so that the points move from the picture
continuously. This way ends where the Jacobian J becomes singular: such a variant is reported as not assembled.

Every step is as long as Kantorovich's theorem allows, so no step leaves the branch (P. Deuflhard, Newton Methods for
Nonlinear Problems, 2011, theorem 2.1). The conditions are quadratic, so their second derivative B is constant. Lengths
of displacements are counted as the largest change of a vector between two points, and at the place z::

    w = max |inv(J) B[x, y]| for |x| = |y| = 1     c = -inv(J) (what is left of c(z) = (1 - s) r)
    v = dz/ds = -inv(J) r                          M = max |inv(J) B[v, x]| for |x| = 1,   K = |inv(J) B[v, v]| / 2

At ``p = z + c + t v`` the Jacobian differs from J by the share ``q = w|c| + M t`` at most, and what is left there is
``e = K t^2 + w |c| (|c|/2 + |v| t)`` at most, by inv(J). Where ``w e <= (1 - q)^2 / 2`` there is exactly one solution
near p, it is regular, and Newton's method leads to it; as this holds for all smaller t as well, these solutions are one
path. The next place is p with some corrections of the simplified Newton method (with inv(J) from z), by which it comes
nearer to its solution. It is the same that the theorem finds from there: that lies within ``2 e / (1 - q)`` of p, where
there is no other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from msgspec import Struct
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import Complex, Flags
from variantgen.mechanism.condition import Condition, VectorProduct
from variantgen.mechanism.small_matrices import inverse

# Kantorovich's bound is a half; the rest is room for rounding.
_BOUND = 0.48
# Corrections to p, each w|move| times as large as the one before, and w|c| from which they leave nothing but rounding.
_CORRECTIONS, _CLOSED = 3, 4e-4
# Least step of s, and largest number of steps: a way that needs more has come too near to a singular position.
_LEAST, _MOST_STEPS = 1e-6, 100
# Variants that are followed together: as many as fit into the cache of a processor with their matrices.
_TOGETHER = 4000

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]
Places = NDArray[np.intp]


def assemble(
    picture: Mapping[str, Complex], known: Mapping[str, Complex], conditions: Sequence[Condition]
) -> tuple[dict[str, Complex], Flags]:
    """Places (m) of the points of the picture that meet the conditions, and whether they were found."""
    products = [condition.product() for condition in conditions]
    named = {name for p in products for pair in (p.first, p.second) for name in pair or ()}
    points = {**picture, **{name: z for name, z in known.items() if name in named}}
    tables = [[*points.values()], [p.factor for p in products], [p.value for p in products]]
    shape = np.broadcast_shapes((1,), *(np.shape(x) for rows in tables for x in rows))
    z, factor, value = (np.array([np.broadcast_to(x, shape) for x in rows]) for rows in tables)
    names = _Names(list(points), len(picture), products)
    found = np.zeros(shape, dtype=bool)
    for start in range(0, shape[0], _TOGETHER):
        part = slice(start, start + _TOGETHER)
        z[:, part], found[part] = _followed(_Way.from_picture(names, z[:, part], factor[:, part], value[:, part]))
    return {name: z[i] for i, name in enumerate(picture)}, found


class _Names:
    """The points by their numbers, those to be placed first, and between which of them the conditions' vectors lead.

    Vectors are pairs of starts and ends, shape (2, vectors).
    """

    def __init__(self, points: list[str], moving: int, products: Sequence[VectorProduct]) -> None:
        self.moving, self.points = moving, len(points)
        number = {name: i for i, name in enumerate(points)}
        self.linear = np.array([p.first is None for p in products])[:, None]
        # Where a linear condition has no first vector stands one that nothing changes: from a point to itself.
        first, second = [p.first or (p.second[0], p.second[0]) for p in products], [p.second for p in products]
        self.first, self.second = (np.array([[number[n] for n in way] for way in ways]).T for ways in (first, second))
        self.rows = np.arange(len(products))
        # Those of conditions that are not linear, each once.
        every = np.concatenate([pairs[:, ~self.linear[:, 0]] for pairs in (self.first, self.second)], axis=1)
        self.bent = np.unique(every, axis=1)

    def places(self, coordinates: Array) -> ComplexArray:
        """Displacements of all points from those along x and y of the points to be placed; first axis the points."""
        found = np.zeros((self.points, *coordinates.shape[1:]), dtype=complex)
        found.real[: self.moving], found.imag[: self.moving] = coordinates[0::2], coordinates[1::2]
        return found


def _between(z: ComplexArray, pairs: Places) -> ComplexArray:
    """The vectors between points, or how they change when the points move."""
    vectors: ComplexArray = z.take(pairs[1], axis=0) - z.take(pairs[0], axis=0)
    return vectors


class _Way(Struct, frozen=True):
    """Variants on their way from the picture; the batch is the last axis.

    ``number`` says which ones, ``z`` (points, N) and ``s`` (N) where they are, ``start`` what the conditions left in
    the picture; ``factor`` and ``value`` are those of the conditions, shape (conditions, N).
    """

    names: _Names
    number: Places
    z: ComplexArray
    s: Array
    start: Array
    factor: ComplexArray
    value: Array

    @classmethod
    def from_picture(cls, names: _Names, z: ComplexArray, factor: ComplexArray, value: Array) -> _Way:
        """All variants, at their pictures."""
        size = z.shape[1]
        way = cls(names, np.arange(size), z, np.zeros(size), np.zeros_like(value), factor, value)
        return replace(way, start=way.left())

    def take(self, index: NDArray[np.bool_]) -> _Way:
        """Some of the variants."""
        factor, value = self.factor[:, index], self.value[:, index]
        return _Way(
            self.names, self.number[index], self.z[:, index], self.s[index], self.start[:, index], factor, value
        )

    def vectors(self) -> tuple[ComplexArray, ComplexArray]:
        """The two vectors of each condition, shape (conditions, N)."""
        names = self.names
        return np.where(names.linear, 1.0, _between(self.z, names.first)), _between(self.z, names.second)

    def left(self) -> Array:
        """What is left of the conditions, shape (conditions, N)."""
        first, second = self.vectors()
        return (self.factor * first.conj() * second).real - self.value

    def jacobian(self) -> Array:
        """Derivative by x and y of each point to be placed, shape (conditions, 2 points, N)."""
        names, (first, second) = self.names, self.vectors()
        slopes = np.zeros((len(names.rows), names.points, self.s.size), dtype=complex)
        for pairs, slope in ((names.first, self.factor * second), (names.second, self.factor.conj() * first)):
            slopes[names.rows, pairs[1]] += slope
            slopes[names.rows, pairs[0]] -= slope
        found = np.empty((len(names.rows), 2 * names.moving, self.s.size))
        found[:, 0::2], found[:, 1::2] = slopes[:, : names.moving].real, slopes[:, : names.moving].imag
        return found


def _followed(way: _Way) -> tuple[ComplexArray, Flags]:
    """Places of all points at the end of the way, or where it was left, and whether it has been gone to its end."""
    z, found = way.z.copy(), np.zeros(way.s.size, dtype=bool)
    for _ in range(_MOST_STEPS):
        way, arrived, lost = _step(way)
        z[:, way.number] = way.z
        found[way.number] = arrived
        going = ~(arrived | lost)
        if not going.all():
            way = way.take(going)
        if not way.s.size:
            break
    return z, found


class _Linearised:
    """The conditions in the neighbourhood of a place, for all variants of a way; the module has the formulas."""

    def __init__(self, way: _Way) -> None:
        self._names, self._factor = way.names, way.factor
        self._inverse, self.regular = inverse(way.jacobian())
        # How vectors change when the left side of a condition grows by one, shape (vectors, conditions, N).
        self._reach = np.abs(_between(self._names.places(self._inverse), self._names.bent))

    def moved(self, left: Array) -> ComplexArray:
        """How the points move when the left sides of the conditions grow by so much."""
        return self._names.places((self._inverse * left).sum(axis=1))

    def size(self, move: ComplexArray) -> Array:
        """The largest change of a vector (m)."""
        return _largest(np.abs(_between(move, self._names.bent)))

    def curved(self, move: ComplexArray) -> ComplexArray:
        """``inv(J) B[move, move] / 2``."""
        first, second = _between(move, self._names.first), _between(move, self._names.second)
        return self.moved((self._factor * first.conj() * second).real)

    def greatest(self, bends: Array) -> Array:
        """Bound of ``inv(J) b`` for left sides of the sizes ``|factor| bends``; linear conditions have none."""
        sizes = np.where(self._names.linear, 0.0, np.abs(self._factor)) * bends
        return _largest((self._reach * sizes).sum(axis=1))


def _largest(sizes: Array) -> Array:
    found: Array = sizes.max(axis=0, initial=0.0)
    return found


def _step(way: _Way) -> tuple[_Way, Flags, Flags]:
    """The way one step on, which variants have arrived, and which are given up."""
    near = _Linearised(way)
    c, v = -near.moved(way.left() - (1.0 - way.s) * way.start), -near.moved(way.start)
    w = near.greatest(np.full_like(way.value, 2.0))
    m = near.greatest(np.abs(_between(v, way.names.first)) + np.abs(_between(v, way.names.second)))
    wc, wv, wk = w * near.size(c), w * near.size(v), w * near.size(near.curved(v))
    # The largest t with w e <= _BOUND (1 - q)^2 is the smaller root of a t^2 - 2 b t + rest.
    a, b, rest = _BOUND * m * m - wk, _BOUND * m * (1.0 - wc) + 0.5 * wc * wv, _BOUND * (1.0 - wc) ** 2 - 0.5 * wc**2
    divisor = b + np.sqrt(np.maximum(b * b - a * rest, 0.0))
    to_go = 1.0 - way.s
    t = np.where(rest >= to_go * divisor, to_go, rest / np.where(divisor > 0.0, divisor, 1.0))
    lost = ~(near.regular & (wc < 1.0) & (rest > 0.0)) | ((t < _LEAST) & (t < to_go))
    along = move = c + t * v
    for _ in range(_CORRECTIONS):
        move = along - near.curved(move)
    s = np.where(t == to_go, 1.0, way.s + t)
    arrived = (to_go == 0.0) & (wc < _CLOSED) & ~lost
    return replace(way, z=way.z + np.where(lost, 0.0, move), s=s), arrived, lost
