"""Points that must be placed together: Newton's method from a stated picture, on the branch of that picture.

Groups of class III and higher have no construction by circles and lines. The conditions c_i (distances, lines) hold for
the picture up to remainders r_i; these are taken back to zero in small steps, ``c_i(z(s)) = (1 - s) r_i``, so that the
points move from the picture continuously. The assembly branch can change only where the Jacobian becomes singular; a
variant whose Jacobian changes its sign on the way, or nearly vanishes, is reported as not assembled.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import Complex, Flags, Real

# Share of the picture's size by which the conditions move per step, and the largest number of steps. Each step is one
# of Newton's method, so what is left after it is of second order and goes into the next.
_STEP, _MOST_STEPS = 0.04, 16
_POLISH = 5
# Of the size of the picture: what a converged chain may leave open (a few roundings of the coordinates).
_CLOSED = 1e-13
# Ratio of the Jacobian's determinant to that of the picture below which the way has come too near to a dead point.
_SINGULAR = 1e-6

Array = NDArray[np.float64]


class Condition(Protocol):
    """What this module needs of a condition (see :mod:`variantgen.mechanism.conditions`)."""

    def value(self, at: Mapping[str, Complex]) -> Real:
        """The residual of the condition (m)."""
        ...

    def gradient(self, at: Mapping[str, Complex]) -> dict[str, Complex]:
        """By point the vector c of ``d value = sum Re(conj(c) dz)``."""
        ...


def assemble(
    picture: Mapping[str, Complex], known: Mapping[str, Complex], conditions: Sequence[Condition]
) -> tuple[dict[str, Complex], Flags]:
    """Places (m) of the points of the picture that meet the conditions, and whether they were found."""
    return _Assembly(picture, known, conditions).run()


class _Assembly:
    """The path from the picture to the assembled chain, for a batch."""

    def __init__(
        self, picture: Mapping[str, Complex], known: Mapping[str, Complex], conditions: Sequence[Condition]
    ) -> None:
        self.names = list(picture)
        self.known, self.conditions = known, conditions
        values = [c.value({**known, **picture}) for c in conditions]
        shapes = (np.shape(x) for x in (*picture.values(), *known.values(), *values))
        self.shape = np.broadcast_shapes((1,), *shapes)
        self.z = np.stack(
            [np.broadcast_to(np.asarray(z, dtype=complex), self.shape) for z in picture.values()], axis=-1
        )
        spread = np.max(np.abs(self.z - np.mean(self.z, axis=-1, keepdims=True)), axis=-1)
        self.size = np.maximum(spread, np.max(np.abs(self.residual()), axis=-1))

    def at(self) -> dict[str, Complex]:
        """All points."""
        return {**self.known, **{name: self.z[..., i] for i, name in enumerate(self.names)}}

    def residual(self) -> Array:
        """What is left of the conditions, shape (N, conditions)."""
        at = self.at()
        found = np.empty((*self.shape, len(self.conditions)))
        for row, condition in enumerate(self.conditions):
            found[..., row] = condition.value(at)
        return found

    def jacobian(self) -> Array:
        """Derivative by x and y of each point, shape (N, conditions, 2 points)."""
        at = self.at()
        found = np.zeros((*self.shape, len(self.conditions), 2 * len(self.names)))
        for row, condition in enumerate(self.conditions):
            gradient = condition.gradient(at)
            for i, name in enumerate(self.names):
                if name in gradient:
                    found[..., row, 2 * i] = np.real(gradient[name])
                    found[..., row, 2 * i + 1] = np.imag(gradient[name])
        return found

    def run(self) -> tuple[dict[str, Complex], Flags]:
        """Follow the path; see :func:`assemble`."""
        start = self.residual()
        jacobian = self.jacobian()
        first = np.linalg.det(jacobian)
        sound = np.abs(first) > _SINGULAR
        # Steps short enough to stay on the branch; a picture that is nearly right needs but one.
        worst = float(np.max(np.abs(start) / self.size[..., None]))
        steps = min(_MOST_STEPS, max(1, math.ceil(worst / _STEP)))
        for step in range(1, steps + 1):
            self._newton(jacobian, (1.0 - step / steps) * start, sound)
            jacobian = self.jacobian()
            sound = sound & (np.linalg.det(jacobian) / np.where(first == 0, 1.0, first) > _SINGULAR)
        for _ in range(_POLISH):
            self._newton(jacobian, np.zeros_like(start), sound)
            left = np.max(np.abs(self.residual()), axis=-1)
            if np.all((left <= 0.01 * _CLOSED * self.size) | ~sound):
                break
            jacobian = self.jacobian()
        return {name: self.z[..., i] for i, name in enumerate(self.names)}, sound & (left <= _CLOSED * self.size)

    def _newton(self, jacobian: Array, target: Array, sound: Flags) -> None:
        """One step towards ``residual = target``; variants that are given up stay where they are."""
        safe = np.where(sound[..., None, None], jacobian, np.eye(2 * len(self.names)))
        lack = np.where(sound[..., None], target - self.residual(), 0.0)
        # Only a step shorter than the picture can belong to the path; it also keeps lost variants finite.
        move = np.linalg.solve(safe, lack[..., None])[..., 0]
        longest = np.max(np.abs(move), axis=-1, keepdims=True)
        limit = self.size[..., None]
        move = move * np.where(longest > limit, limit / np.where(longest > 0, longest, 1.0), 1.0)
        self.z = self.z + move[..., 0::2] + 1j * move[..., 1::2]
