"""The way of a mechanism: its positions while the drivers move on, and the motion in each of them.

The way is measured by the leading driver: the first that prescribes a rotation (rad), else the first one (m); positive
in the sense of the given motion, zero at the instant of the problem. All drivers move in the proportion of their given
velocities (of their accelerations where the motion starts from rest). In every position the drivers have the
velocities and accelerations that are given for the instant, so that a curve tells what the answer would be there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import Enum

import numpy as np
from msgspec import Struct
from msgspec.structs import replace

from variantgen.mechanism.motion import ComplexField, Field, Motion
from variantgen.mechanism.outcome import Outcome
from variantgen.mechanism.rows import Constraint
from variantgen.mechanism.scene import Scene
from variantgen.mechanism.solving.solve import add_speeds
from variantgen.mechanism.solving.structure import Plan
from variantgen.mechanism.turn.continuation import Continuation, PathState, StopReason

FULL_TURN = 2 * np.pi
# How far drivers go that could go on for ever, to either side, in sizes of the mechanism (its points' largest distance
# from their middle): longer beside a driver that turns, and where it takes so long to turn a body half round.
_FARTHEST, _LONG = 1.2, 4.0
# Share of a step by which the last positions before a dead point follow each other.
_CLOSER = (0.5, 0.25, 0.1, 0.03, 0.01)
# Scaled determinant below which velocities have no digits left that a curve could show.
_BLIND = 1e-6


class SweepEnd(Enum):
    """Why the way ends: a turn is complete, a dead point, a joint at its limit, or it is long enough."""

    TURN = "turn"
    DEAD_POINT = "dead_point"
    JOINT = "joint"
    LENGTH = "length"


class LeadingDriver(Struct, frozen=True):
    """The driver that measures the way: its number, whether it is an angle, its given rate per second (rad or m)."""

    number: int
    angular: bool
    rate: float


class Sweep(Struct, frozen=True):
    """Positions along the way, shape (K,): the motion there, the way (rad or m), the rotations of the bodies (rad).

    ``instant`` is the index of the instant of the problem; ``ends`` tell why the way ends below and above. ``clear``
    tells where the given motion determines the velocities: not at a dead point.
    """

    motion: Motion
    way: Field
    turned: Mapping[str, Field]
    instant: int
    leading_driver: LeadingDriver
    ends: tuple[SweepEnd, SweepEnd]

    @property
    def clear(self) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
        """Whether velocities and accelerations have a meaning at a position, shape (K,)."""
        return self.motion.solved & (self.motion.transmission > _BLIND)

    @property
    def closed(self) -> bool:
        """Whether all bodies are back where they were after a full turn."""
        if SweepEnd.TURN not in self.ends:
            return False
        gaps = [abs(z[-1] - z[0]) for z in self.motion.z.values()]
        return bool(max(gaps) < 1e-7 * float(self.motion.length_scale()[0]))


def sweep(
    motion: Motion,
    plan: Plan,
    before: float = 0.0,
    samples: int = 361,
    limits: Sequence[tuple[str, str, str]] = (),
) -> Sweep:
    """The way of a solved motion (of one variant) as far as it can go, at most a full turn of the leading driver.

    Where a full turn is possible, ``before`` (0 to 2 pi) of it lies before the instant. ``limits`` are triples (point,
    start, towards): the point stays on the side of ``start`` where ``towards`` is. Raises ValueError for a motion that
    is not solved, for more than one variant, and where no driver moves.
    """
    if motion.size != 1 or not motion.solved[0]:
        raise ValueError("a sweep starts from one solved variant")
    leading_driver, rates = find_leading_driver(motion.scene)
    continuation = Continuation(motion, rates / leading_driver.rate, limits)
    whole = leading_driver.angular
    if whole:
        continuation.bound(_LONG, np.inf)
    else:
        continuation.bound(_LONG if continuation.turning * _LONG > 0.5 * FULL_TURN else _FARTHEST, 0.5 * FULL_TURN)
    low, high = _trace(continuation, before, whole)
    ways, instant = _ways(low, high, samples)
    states = [*reversed(low.states[1:]), *high.states]
    turned, places = continuation.between(states, ways)
    along = moved(motion, places, len(ways))
    ends = _end(low, whole), _end(high, whole)
    return Sweep(add_speeds(along, plan, 2), ways, turned, instant, leading_driver, ends)


def find_leading_driver(scene: Scene) -> tuple[LeadingDriver, Field]:
    """The leading driver, and the rates of the rows of all drivers (per second, shape (D,)).

    Raises ValueError where no driver moves.
    """
    for order in (1, 2):
        tables = [np.array([float(np.ravel(r)[0]) for r in driver.rates(order)]) for driver in scene.drivers]
        moving = [number for number, table in enumerate(tables) if np.any(table != 0)]
        if moving:
            turning = [number for number in moving if _is_angular(scene.drivers[number])]
            number = (turning or moving)[0]
            rate = float(np.linalg.norm(tables[number]))
            return LeadingDriver(number, bool(turning), rate), np.concatenate(tables)
    raise ValueError("no driver moves")


def _is_angular(driver: Constraint) -> bool:
    return not any(shape.points for shape in driver.shapes())


class _Traced(Struct, frozen=True):
    """States from the instant outwards, the way that they cover, and what stopped it (None: it was long enough)."""

    states: list[PathState]
    way: float
    stop: StopReason | None


def _run(continuation: Continuation, wanted: float) -> _Traced:
    """The way to a wanted place, or as far as it goes."""
    states, stop = continuation.run(wanted)
    return _Traced(states, wanted if stop is None else states[-1].way, stop)


def _trace(continuation: Continuation, before: float, whole: bool) -> tuple[_Traced, _Traced]:
    """The way below and above the instant; together at most a full turn."""
    if not whole:
        return _run(continuation, -continuation.longest), _run(continuation, continuation.longest)
    low, high = _run(continuation, -before), _run(continuation, FULL_TURN - before)
    if high.stop is not None and low.stop is None:
        low = _run(continuation, high.way - FULL_TURN)
    elif low.stop is not None and high.stop is None:
        high = _run(continuation, low.way + FULL_TURN)
    return low, high


def _end(traced: _Traced, whole: bool) -> SweepEnd:
    if traced.stop is None:
        return SweepEnd.TURN if whole else SweepEnd.LENGTH
    return {
        StopReason.DEAD_POINT: SweepEnd.DEAD_POINT,
        StopReason.JOINT: SweepEnd.JOINT,
        StopReason.LENGTH: SweepEnd.LENGTH,
    }[traced.stop]


def _ways(low: _Traced, high: _Traced, samples: int) -> tuple[Field, int]:
    """Places on the way, evenly on both sides of the instant and closer towards a dead point; index of the instant."""
    length = high.way - low.way
    share = int(np.clip(round((samples - 1) * high.way / length), 0, samples - 1)) if length else 0
    above = _side(high, share or (1 if high.way > 0 else 0))
    below = _side(low, samples - 1 - share or (1 if low.way < 0 else 0))
    return np.concatenate([below[:0:-1], above]), len(below) - 1


def _side(traced: _Traced, count: int) -> Field:
    """Places from the instant outwards: 0, ..., the end."""
    if not count:
        return np.zeros(1)
    even = np.linspace(0.0, traced.way, count + 1)
    if traced.stop is not StopReason.DEAD_POINT:
        return even
    step = traced.way / count
    return np.concatenate([even[:-1], traced.way - step * np.array(_CLOSER), even[-1:]])


def moved(motion: Motion, places: Mapping[str, ComplexField], count: int) -> Motion:
    """The motion with other positions, as a batch of so many."""
    still = {name: np.broadcast_to(z, (count,)) for name, z in motion.z.items()}
    others = {name: np.broadcast_to(z, (count,)) for name, z in places.items()}
    outcome = np.full(count, int(Outcome.SOLVED), dtype=np.int8)
    empty: dict[str, Field] = {}
    return replace(
        motion,
        outcome=outcome,
        transmission=np.ones(count),
        z={**still, **others},
        v={},
        a={},
        omega=empty,
        epsilon=empty,
    )
