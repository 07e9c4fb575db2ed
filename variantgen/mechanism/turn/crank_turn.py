"""A full turn of the crank: its extremes, to and fro ways and mean values, for a batch of variants at once.

The way is the angle by which the crank has turned, in the sense of its given rotation, since the position of the
problem; its angular velocity is the given one all along. Positions of N variants at K angles each are solved as one
batch of N times K: the points of the crank are turned about its pivot, and all others follow by their constructions.
Where these do not follow (a position that starts from another link, a picture met by Newton's method), or leave the
branch, which the next positions show beside their velocities, the variant is followed by continuation.
"""

from __future__ import annotations

from contextlib import suppress
from functools import cached_property
from typing import TypeAlias

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from variantgen.mechanism.arithmetic import Complex
from variantgen.mechanism.constructions.coordinates import Coordinates
from variantgen.mechanism.drivers.rotation import Rotation
from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.solving.solve import add_speeds, place
from variantgen.mechanism.solving.structure import analyse
from variantgen.mechanism.turn.continuation import Continuation, PathState
from variantgen.mechanism.turn.crank import crank_of
from variantgen.mechanism.turn.sweep import moved

FULL_TURN = 2 * np.pi
GRID = 72  # positions of a turn among which extremes are looked for
# A way (rad) so small that positions change as the velocities tell, and of the largest change the share that it may
# deviate from them: more, and the constructions do not keep the lengths. Between two positions of the grid a point that
# goes over to the other branch deviates as much as it moves.
_NEARBY, _DEVIATES, _JUMPS = 1e-5, 1e-3, 0.3
_NOTHING = 1e-13  # m

_Path: TypeAlias = tuple[Continuation, list[PathState]]


class CrankTurn:
    """A full turn of the crank of N variants, ``size`` of them, with velocities (``order`` 1) or accelerations (2).

    Raises ValueError for a scene without a crank.

    ``complete`` tells for which variants the crank can make the turn, shape (N,).
    """

    def __init__(self, motion: Motion, order: int) -> None:
        found = crank_of(motion.scene)
        if found is None:
            raise ValueError("the mechanism has no crank")
        driver = motion.scene.drivers[0]
        assert isinstance(driver, Rotation)
        steady = replace(motion.scene, drivers=(replace(driver, epsilon=0.0),))
        self.size = motion.size
        self._crank, self.order, self._plan = found, order, analyse(steady)
        self._motion = replace(motion, scene=steady)
        self._rate = np.broadcast_to(np.asarray(driver.omega, dtype=float), (motion.size,))
        self._paths: dict[int, _Path | None] = {}
        self._by_path = np.zeros(motion.size, dtype=bool)
        self.complete = self._look_round()

    def at(self, variants: NDArray[np.intp], angles: Field) -> Motion:
        """The motion of variants at angles (rad) of their cranks, shape (M,) each; the outcome tells what has none."""
        z, outcome = self._placed(variants, angles)
        for variant in np.unique(variants[self._by_path[variants]]).tolist():
            own = np.flatnonzero(variants == variant)
            path = self._path(variant)
            if path is not None:
                _, places = path[0].between(path[1], np.mod(angles[own], FULL_TURN))
                for name, table in z.items():
                    table[own] = places.get(name, self._motion.z[name][variant])
                outcome[own] = int(Outcome.SOLVED)
        placed = moved(self._motion.take(variants), z, angles.size)
        return add_speeds(replace(placed, outcome=outcome), self._plan, self.order)

    def _placed(self, variants: NDArray[np.intp], angles: Field) -> tuple[dict[str, ComplexField], NDArray[np.int8]]:
        """Places (m) by the constructions, with the points of the crank turned about its pivot, and outcomes."""
        start = self._motion.take(variants)
        centre = start.z[self._crank.pivot]
        turn = np.exp(1j * np.sign(self._rate[variants]) * start.frame.sense * angles)
        points = dict(start.scene.points)
        for name in start.scene.bodies[self._crank.body]:
            where: Complex = start.frame.unplace(centre + turn * (start.z[name] - centre))
            points[name] = Coordinates(np.real(where), np.imag(where))
        found, outcome = place(replace(start.scene, points=points), self._plan)
        z = {name: np.array(np.broadcast_to(at, angles.shape), dtype=complex) for name, at in found.items()}
        return z, np.array(np.broadcast_to(np.asarray(outcome, dtype=np.int8), angles.shape))

    def _regular(self, beyond: float = 0.0) -> tuple[NDArray[np.intp], Field]:
        """Every variant at every angle of the grid, or so much beyond it."""
        angles = np.arange(GRID) * (FULL_TURN / GRID) + beyond
        return np.repeat(np.arange(self.size), GRID), np.tile(angles, self.size)

    @cached_property
    def grid(self) -> Motion:
        """The motion at the angles of a regular grid, variant after variant, shape (N * GRID,)."""
        return self.at(*self._regular())

    def _look_round(self) -> NDArray[np.bool_]:
        """Whether the crank can make the turn, shape (N,); marks the variants that must be followed by continuation."""
        if self._motion.scene.conditions:
            follows, ends = np.zeros((2, self.size), dtype=bool)
        else:
            follows, ends = self._by_constructions()
        whole = follows & ~ends
        for variant in np.flatnonzero(~follows & self._motion.solved).tolist():
            self._by_path[variant] = True
            whole[variant] = self._path(variant) is not None
        if self._by_path.any():
            vars(self).pop("grid", None)
        return whole

    def _by_constructions(self) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Whether the constructions follow the crank: positions change as the velocities tell; and whether a point
        cannot be placed somewhere, so that the way ends before; shape (N,) each.
        """
        with np.errstate(all="ignore"):
            found = self.grid
            near = self._placed(*self._regular(_NEARBY))[0]
            time = 1.0 / np.abs(self._rate[:, None])
        placed = np.isin(found.outcome, (Outcome.SOLVED, Outcome.DEAD_POINT)).reshape(self.size, GRID)
        follows = placed[:, 0].copy()
        shape = (-1, self.size, GRID)
        tables = (np.stack([table[name] for name in found.v]) for table in (found.z, found.v, near))
        places, speeds, closer = (table.reshape(shape) for table in tables)
        rate = speeds * time
        for step, meant, share in (
            (closer - places, rate * _NEARBY, _DEVIATES),
            (_next(places) - places, 0.5 * (_next(rate) + rate) * (FULL_TURN / GRID), _JUMPS),
        ):
            known = np.isfinite(step * meant)
            change, mean = np.where(known, step, 0.0), np.where(known, meant, 0.0)
            most = np.max(np.maximum(np.abs(change), np.abs(mean)), axis=2, keepdims=True)
            follows &= np.all(np.abs(change - mean) <= share * most + _NOTHING, axis=(0, 2))
        return follows, ~np.all(placed, axis=1)

    def _path(self, variant: int) -> _Path | None:
        """The continuation of a variant over the turn with its states; None where it does not get so far."""
        if variant not in self._paths:
            found = None
            with suppress(np.linalg.LinAlgError):
                share = np.array([np.sign(self._rate[variant])])
                continuation = Continuation(self._motion.take(np.array([variant])), share)
                states, stop = continuation.run(FULL_TURN)
                found = (continuation, states) if stop is None else None
            self._paths[variant] = found
        return self._paths[variant]


def _next(table: ComplexField) -> ComplexField:
    """Each value's successor on the grid, the last axis."""
    return np.concatenate([table[..., 1:], table[..., :1]], axis=-1)


# The last turn: several values of one turn are asked one after the other, and going round takes most of the time.
_last: list[tuple[Motion, CrankTurn]] = []


def crank_turn(motion: Motion, order: int) -> CrankTurn:
    """The turn of a motion, with velocities (order 1 or less) or accelerations (2) along it. Raises ValueError."""
    for known, turn in _last:
        if known is motion and turn.order >= order:
            return turn
    _last[:] = [(motion, CrankTurn(motion, max(1, order)))]
    return _last[0][1]
